"""What the algebraic gradient can be off, certified: its bases over boxes of the hits, and their powers.

Each of A's lines is run on intervals: of the exact values over a box, and of how far the float64 number is off,
relatively. That has no unit of length: e = 1. All numbers are positive; x and y are, without loss.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache
from itertools import product
from typing import Any

import numpy as np

from proofs.formulas.algebraic_form import MAX_WAVE_NUMBER
from proofs.formulas.camera import angles_on_a
from renderer.operations import UNIT
from verify.evaluate import Evaluator

SLACK = 1 + 2.0**-30  # more than what second orders add, and the roundings of bounds that are at most 2^-32
OUTWARD = 2.0**-50
LEAST_SQUARE = 0.1
"""The least 1 − (ρ/ρ_s)²."""
RATIOS = (1e-6, 1 - 1e-9)
"""R/e."""
BOXES = (12000, 200)


@dataclass(frozen=True)
class Off:
    """Arrays: between what the exact value is, and the most by which the float64 number is off, over that value."""

    low: Any
    high: Any
    error: Any = 0.0

    def _rounded(self, low, high, error):
        error = (error + UNIT) * SLACK
        return Off(low * (1 - OUTWARD), high * (1 + OUTWARD), np.where(error < 2.0**-32, error, np.inf))

    def __add__(self, other):
        low, moved = self.low + other.low, self.high * self.error + other.high * other.error
        with np.errstate(
            invalid="ignore", divide="ignore"
        ):  # no more than the larger error, and than the two by their shares
            error = np.fmin(np.maximum(self.error, other.error), moved / low)
        return self._rounded(low, self.high + other.high, error)

    def __sub__(self, other):
        low = np.maximum(self.low - other.high, 0.0) * (1 - OUTWARD)
        moved = self.high * self.error + other.high * other.error
        with np.errstate(invalid="ignore", divide="ignore"):
            return self._rounded(low, self.high - other.low, np.where(moved > 0, moved / low, 0.0))

    def __mul__(self, other):
        return self._rounded(self.low * other.low, self.high * other.high, self.error + other.error)

    def __truediv__(self, other):
        with np.errstate(divide="ignore"):
            return self._rounded(self.low / other.high, self.high / other.low, self.error + other.error)

    def __rtruediv__(self, number):
        return Off(number, number) / self

    def sqrt(self) -> "Off":
        """Return the root, whose relative error is half as large."""
        return self._rounded(np.sqrt(self.low), np.sqrt(self.high), self.error / 2)


NAMES = {
    "rational": lambda p, q: Off(p / q, p / q),
    "sqrt": Off.sqrt,
    "maximum": lambda zero, number: number,
    "compare": lambda *sides: True,  # A is hit, off the pole
    "where": lambda condition, value, otherwise: value(),
    "inf": None,
}
"""What the lines call."""


class Lines(Evaluator):
    """The lines of A's angles, ρ within what the box says."""

    def __init__(self, rho):
        super().__init__(angles_on_a)
        self.rho = rho

    def run(self, values: Mapping[str, Any], names: Mapping[str, Any]) -> dict[str, Any]:
        """Return {name: Off}; √(x² + y²) has the error of its operations, and the box's values."""
        computed = dict(values)
        for name, code in self.code:
            computed[name] = self.compute(code, {**names, "value": computed})
            if name == "rho_raw":
                computed[name] = replace(computed[name], low=self.rho[0], high=self.rho[1])
        return computed


def base_errors(least: float = LEAST_SQUARE) -> tuple[float, float]:
    """Return by how much the bases, of u and of v, are off at most where 1 − (ρ/ρ_s)² ≥ `least`."""
    half, (many, squares) = BOXES[0] // 2, BOXES
    ratios = np.concatenate([np.geomspace(RATIOS[0], 0.5, half), 1 - np.geomspace(0.5, 1 - RATIOS[1], many - half)[1:]])
    roots = np.sqrt(1 - np.linspace(least, 1, squares + 1))[::-1]  # ρ/ρ_s
    low, high = ratios[:-1, None], ratios[1:, None]
    # ρ_s = R/√((1 − R)(1 + R)) rises with R
    rim = [r / np.sqrt((1 - r) * (1 + r)) for r in (low, high)]
    rho = rim[0] * roots[:-1] * (1 - 2.0**-48), rim[1] * roots[1:] * (1 + 2.0**-48)
    anywhere = Off(0 * rho[0], rho[1])
    found = Lines(rho).run({"x": anywhere, "y": anywhere, "eye": Off(1.0, 1.0), "radius": Off(low, high)}, NAMES)
    of_u = np.maximum(found["cos_theta"].error, found["sin_theta"].error)
    parts = [np.minimum(found[name].high, 1.0) * found[name].error for name in ("cos_phi", "sin_phi")]
    return float(of_u.max() * SLACK), float(np.hypot(*parts).max() * SLACK)


@cache
def gradient_bound(of_u: float, of_v: float) -> Fraction:
    """Return the most by which a slope can be off in units of (1 + k) π k 2^-53, of all wave numbers; exact.

    of_u, of_v: how far the bases are off. By theorem rounded_powers, with four roundings of π and of the products.
    """
    unit = Fraction(UNIT)
    kappa, rest = (1 + unit) ** 3, (1 + unit) ** 4

    def factor(off, power):
        return (1 + Fraction(off)) ** power * kappa ** (power - 1) if power else 1

    waves = product(range(MAX_WAVE_NUMBER // 2 + 1), range(MAX_WAVE_NUMBER + 1))
    factors = (
        [factor(of_u, n) for n in range(MAX_WAVE_NUMBER // 2 + 1)],
        [factor(of_v, n) for n in range(MAX_WAVE_NUMBER + 1)],
    )
    return max((rest * factors[0][n] * factors[1][m] - 1) / (1 + max(2 * n, m, 1)) for n, m in waves) / unit
