"""The algebraic gradient is nowhere further off than is certified, once the sides of the creases are certain."""

import numpy as np
import pytest

from proofs.formulas.certified import ALGEBRAIC_GRADIENT
from proofs.formulas.height_fields import HEIGHT_FIELDS
from verify.accuracy.base_errors import base_errors
from verify.accuracy.gradient_errors import UNIT, errors_at, worst_at_image_points

SINE, RIDGES = HEIGHT_FIELDS["sine"], HEIGHT_FIELDS["ridges"]
ALGEBRAIC = [field for field in HEIGHT_FIELDS.values() if field.wave_numbers]


@pytest.mark.parametrize("field", ALGEBRAIC, ids=lambda field: field.name)
def test_no_sample_is_above_what_is_certified(field):
    assert 1 < worst_at_image_points(field) < ALGEBRAIC_GRADIENT


def test_the_point_at_which_eight_units_were_claimed():
    at = {
        "eye": float.fromhex("0x1.021f2fb272d1dp+9"),
        "radius": 1.0,
        "x": float.fromhex("0x1.bc6ffc88851b2p-1"),
        "y": float.fromhex("-0x1.87c10a5d4cef9p-2"),
    }
    (found,) = errors_at(SINE, {name: np.array([value]) for name, value in at.items()} | {"k_u": 60.0, "k_v": 63.0})
    assert 9 < found < ALGEBRAIC_GRADIENT


def test_a_crease_has_to_be_excluded():
    assert worst_at_image_points(RIDGES, sides_certain=False) > 1e10


def test_a_narrower_hypothesis_gives_a_smaller_bound():
    (_, rim), (_, off_rim), (_, middle) = base_errors(0.01), base_errors(), base_errors(0.9)
    assert rim > 2 * off_rim > 4 * middle > 8 * UNIT
