"""The algebraic gradient is nowhere further off than is certified, once the sides of the creases are certain."""

import numpy as np

from proofs.formulas.certified import ALGEBRAIC_GRADIENT
from proofs.formulas.height_fields import HEIGHT_FIELDS
from verify.accuracy.gradient_errors import errors_at, worst_at_image_points


def test_the_point_at_which_eight_units_were_claimed():
    x, y = map(float.fromhex, ("0x1.bc6ffc88851b2p-1", "-0x1.87c10a5d4cef9p-2"))
    at = {"eye": float.fromhex("0x1.021f2fb272d1dp+9"), "radius": 1.0, "x": np.array([x]), "y": np.array([y])}
    (found,) = errors_at(HEIGHT_FIELDS["sine"], at | {"k_u": 60.0, "k_v": 63.0})
    assert 9 < found < ALGEBRAIC_GRADIENT


def test_a_crease_has_to_be_excluded():
    ridges = HEIGHT_FIELDS["ridges"]
    assert worst_at_image_points(ridges) < ALGEBRAIC_GRADIENT
    assert worst_at_image_points(ridges, sides_certain=False) > 1e10
