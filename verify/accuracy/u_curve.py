"""The U-curve measured by mpmath: the error of a central difference, and its truncation, against 50 digits.

The exact slope and the exact difference are the expressions of `proofs.formulas`, printed for mpmath. python-flint
encloses both (verify/accuracy/differences.py), and a test compares the two.
"""

from collections.abc import Iterable

import mpmath
import numpy as np

from proofs.formulas import finite_difference
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from renderer import Scene, central, gradient_at
from verify.evaluate import DIGITS, Reference

SINE = HEIGHT_FIELDS["sine"]
SLOPE, DIFFERENCE = Reference(gradient(SINE)), Reference(finite_difference.central(SINE))


def exact_slope(u: float, v: float, k_u: float = 8.0, k_v: float = 4.0) -> mpmath.mpf:
    """Return h_u of sine at (u, v), float64 numbers, as an mpf of 50 digits."""
    return SLOPE({"u": u, "v": v, "k_u": k_u, "k_v": k_v})["h_u"]


def errors(u: float, v: float, steps: Iterable[float], k_u: float = 8.0, k_v: float = 4.0) -> np.ndarray:
    """Return |float64 central difference − h_u| of sine for each step, (steps,) float64."""
    scene, slope = Scene(field="sine", ku=k_u, kv=k_v), exact_slope(u, v, k_u, k_v)
    computed = [float(gradient_at(scene, u, v, central(float(step)))[0]) for step in steps]
    with mpmath.workdps(DIGITS):
        return np.array([float(abs(mpmath.mpf(number) - slope)) for number in computed])


def truncation(u: float, v: float, steps: Iterable[float], k_u: float = 8.0, k_v: float = 4.0) -> np.ndarray:
    """Return |central difference − h_u| of sine in exact arithmetic for each step, (steps,) float64."""
    at, slope = {"u": u, "v": v, "k_u": k_u, "k_v": k_v}, exact_slope(u, v, k_u, k_v)
    with mpmath.workdps(DIGITS):
        return np.array([float(abs(DIFFERENCE(at | {"epsilon": float(step)})["h_u"] - slope)) for step in steps])
