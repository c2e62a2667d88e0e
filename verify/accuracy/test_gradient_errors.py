"""The algebraic gradient is nowhere further off than is certified, and an optimiser that climbs finds no such place."""

import math

import numpy as np
import pytest
from hypothesis import given, seed, settings, target
from hypothesis import strategies as st

from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.symbols import k_v
from verify.accuracy.base_errors import LEAST_SQUARE, RATIOS, base_errors
from verify.accuracy.gradient_errors import CERTIFIED, UNIT, errors_at, worst_at_image_points

SINE, RIDGES = HEIGHT_FIELDS["sine"], HEIGHT_FIELDS["ridges"]
ALGEBRAIC = [field for field in HEIGHT_FIELDS.values() if field.wave_numbers]


@pytest.mark.parametrize("field", ALGEBRAIC, ids=lambda field: field.name)
def test_no_sample_is_above_what_is_certified(field):
    assert 1 < worst_at_image_points(field) < CERTIFIED


def test_the_point_at_which_eight_units_were_claimed():
    at = {
        "eye": float.fromhex("0x1.021f2fb272d1dp+9"),
        "radius": 1.0,
        "x": float.fromhex("0x1.bc6ffc88851b2p-1"),
        "y": float.fromhex("-0x1.87c10a5d4cef9p-2"),
    }
    (found,) = errors_at(SINE, {name: np.array([value]) for name, value in at.items()} | {"k_u": 60.0, "k_v": 63.0})
    assert 9 < found < CERTIFIED


def test_a_crease_has_to_be_excluded():
    assert worst_at_image_points(RIDGES, sides_certain=False) > 1e10


def test_a_narrower_hypothesis_gives_a_smaller_bound():
    (_, rim), (_, off_rim), (_, middle) = base_errors(0.01), base_errors(), base_errors(0.9)
    assert rim > 2 * off_rim > 4 * middle > 8 * UNIT


@pytest.mark.long
@pytest.mark.parametrize("field", ALGEBRAIC, ids=lambda field: field.name)
@seed(24)
@settings(max_examples=3000, deadline=None, database=None)
@given(
    ratio=st.floats(*RATIOS),
    square=st.floats(LEAST_SQUARE, 1, exclude_max=True),
    angle=st.floats(-math.pi, math.pi),
    waves=st.tuples(st.integers(-32, 32), st.integers(-64, 64)).filter(any),
)
def test_no_climber_gets_above_what_is_certified(field, ratio, square, angle, waves):
    eye = 1 / ratio
    rho = math.sqrt(1 - square) * (1 - 1e-12) * eye / math.sqrt((eye - 1) * (eye + 1))
    at = {"eye": eye, "radius": 1.0, "x": np.array([rho * math.cos(angle)]), "y": np.array([rho * math.sin(angle)])}
    k = waves[1] / float(field.wave_numbers[1].subs(k_v, 1))
    (found,) = errors_at(field, at | {"k_u": 2.0 * waves[0], "k_v": k})
    target(found)
    assert found < CERTIFIED
