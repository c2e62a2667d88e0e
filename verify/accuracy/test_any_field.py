"""Errors of fields of one's own stay below the bound, a smaller bound is passed, and a crease has none."""

import numpy as np
import pytest

from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.symbols import u, v
from renderer.generate.expression import parse_expression
from renderer.generate.own import HeightField
from verify.accuracy.any_field import third_derivatives, u_curve

STEPS = np.logspace(-1, -14, 53)
POINT = {"u": 0.31, "v": 0.27, "k_u": 8.0, "k_v": 4.0}
FIELDS = [
    HEIGHT_FIELDS["sine"],
    HEIGHT_FIELDS["rings"],
    HeightField("mound", parse_expression("v**2*exp(3*cospi(2*u) - 40*(v - 1/4)**2)")),
    HeightField("swirl", parse_expression("v**2*sinpi(k_u*u + 4*sinpi(v))")),
]


@pytest.mark.parametrize("along", [u, v])
@pytest.mark.parametrize("field", FIELDS, ids=str)
def test_no_error_is_above_its_bound_and_some_come_near(field, along):
    found = u_curve(field, along, POINT, STEPS)
    assert (found.error <= found.bound).all()
    if found.error.any():  # rings have no slope along u
        assert (found.error > found.bound / 1.5).any()


def test_a_truncation_that_is_a_sixth_too_small_is_noticed():
    """As with /7 for /6, on the arm where there is nothing else."""
    found = u_curve(HEIGHT_FIELDS["sine"], u, POINT, STEPS)
    assert (found.error > found.bound - found.truncation / 7).any()


def test_a_crease_or_a_pole_has_no_bound():
    with pytest.raises(ValueError, match="one without creases"):
        third_derivatives(HEIGHT_FIELDS["ridges"], u, POINT | {"u": 0.25}, STEPS)
    with pytest.raises(ValueError, match="within which well is smooth"):
        third_derivatives(HeightField("well", parse_expression("1/(v + 1/4)")), v, POINT, np.array([0.6]))
