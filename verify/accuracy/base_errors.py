"""Certified errors of the algebraic gradient: those of its bases over boxes of the hits, and of their powers.

A's lines are run on numbers that are Enclosed twice: the exact ones over a box, and float64's errors there. These have
no unit of length: e = 1. All numbers are positive; x and y are, without loss.
"""

from fractions import Fraction
from functools import cache
from itertools import product
from typing import Any, ClassVar

import numpy as np
from flint import arb

from proofs.engine.program import Program
from proofs.formulas.algebraic_form import MAX_WAVE_NUMBER
from proofs.formulas.camera import angles_on_a
from proofs.formulas.symbols import cos_phi, cos_theta, rho, sin_phi, sin_theta
from renderer import kernels, operations
from renderer.machines.bounded import Bounded
from renderer.machines.enclosing import SLACK, Enclosed, enclosed
from renderer.operations import UNIT
from verify.evaluate import ANY_NUMBERS, code_of
from verify.evaluate.programs import lines

LEAST_SQUARE = 0.1
"""The least 1 − (ρ/ρ_s)²."""
RATIOS = (1e-6, 1 - 1e-9)
"""R/e."""
BOXES, ANGLES = (6000, 200), 2000


class OverBoxes(Bounded):
    """Numbers over boxes. value: an Enclosed of exact ones; error: an exact Enclosed that bounds |computed − exact|.

    The printed text of lines runs on it as on a float.
    """

    def __init__(self, value: Any, error: Any = 0.0):
        super().__init__(enclosed(value), Enclosed(enclosed(error).size * SLACK))

    @classmethod
    def of(cls, number: Any) -> "OverBoxes":
        """Return a number as an OverBoxes, unless it is one."""
        return number if isinstance(number, cls) else cls(number)

    @property
    def size(self) -> Any:
        """The largest size of the float64 number."""
        return abs(self.value) + self.error

    size_of_quotient = staticmethod(abs)

    def __neg__(self):
        return OverBoxes(-self.value, self.error)

    def inverse(self) -> Enclosed:
        """Return a bound of the float64 number's inverse."""
        return 1.0 / (abs(self.value) - self.error)

    def lost(self, *_: Any) -> float:
        """Return the bound of a rounding's share of the result: nothing underflows."""
        return UNIT

    lost_in_sum = lost_in_product = lost_in_quotient = lost

    @staticmethod
    def rounded(value: Enclosed, moved: Enclosed, lost: float) -> "OverBoxes":
        """Return a result whose operands' errors move it by so much; lost: the share of its own rounding."""
        return OverBoxes(value, moved + (abs(value) + moved) * lost)

    def sqrt(self) -> "OverBoxes":
        """Return the square root, by |√a − √b| = |a − b|/(√a + √b)."""
        root, least = operations.sqrt(self.value), operations.sqrt(self.value - self.error)
        return self.rounded(root, self.error / (root + least), UNIT)

    names: ClassVar = ANY_NUMBERS | {
        "rational": lambda p, q: p / q,
        "sqrt": sqrt,
        "maximum": lambda zero, number: number,
        "compare": lambda *sides: True,  # A is hit, off the pole
    }


def boxes(ends: np.ndarray, axis: int = -1) -> Enclosed:
    """Return the intervals between neighbouring ends, along one of two axes."""
    low, high = np.sort([ends[:-1], ends[1:]], axis=0)
    middle = (low + high) / 2
    reach = np.maximum(high - middle, middle - low) * (1 + 2.0**-30)
    return Enclosed(np.expand_dims(middle, -1 - axis), np.expand_dims(reach, -1 - axis))


def run(program: Program, values: dict[str, OverBoxes], closer: dict[str, Enclosed] | None = None) -> dict:
    """Run a program's lines on {name: number}, and return it with their numbers added.

    closer: {name: value} of lines whose exact value a better formula encloses more closely.
    """
    for name, line in code_of(program):
        number = OverBoxes.of(eval(line, {**OverBoxes.names, "value": values}))
        values[name] = OverBoxes(closer[name], number.error) if closer and name in closer else number
    return values


def _errors(outputs, inputs, values, closer):
    """Return the errors of outputs of A's lines, computed from given inputs."""
    numbers = run(lines(angles_on_a, inputs, outputs), values, closer)
    return [numbers[symbol.name].error for symbol in outputs]


def _largest(*parts):
    """Return the largest length of a vector of errors."""
    return float(np.max(OverBoxes(0.0, operations.sqrt(sum(part * part for part in parts))).error.value))


def errors_around() -> tuple[float, float]:
    """Return bounds of the errors of u's base and, relatively, of ρ, over a quarter of the circle ρ = 1."""
    angle = boxes(np.linspace(0, 0.5, ANGLES + 1))
    at = {"x": OverBoxes(kernels.cospi(angle)), "y": OverBoxes(kernels.sinpi(angle)), "eye": OverBoxes(1.0)}
    *of_u, of_rho = _errors((cos_theta, sin_theta, rho), (), at, {"rho_raw": Enclosed(1.0)})
    return _largest(*of_u), _largest(of_rho)


@cache
def base_errors(least: float) -> tuple[float, float]:
    """Return bounds of the errors of the bases of u and of v, where 1 − (ρ/ρ_s)² ≥ `least`."""
    (of_u, of_rho), half = errors_around(), BOXES[0] // 2 + 1
    ratios = np.concatenate([np.geomspace(RATIOS[0], 0.5, half), 1 - np.geomspace(0.5, 1 - RATIOS[1], half)[1:]])
    radius, share = boxes(ratios, 0), boxes(np.sqrt(1 - np.linspace(least, 1, BOXES[1] + 1)))  # ρ/ρ_s
    rho_here = share * radius / operations.sqrt((1.0 - radius) * (1.0 + radius))
    at = {"eye": OverBoxes(1.0), "radius": OverBoxes(radius), "rho": OverBoxes(rho_here, rho_here * of_rho)}
    closer = {"discriminant_a": radius * radius * ((1.0 - share) * (1.0 + share))}
    return of_u, _largest(*_errors((cos_phi, sin_phi), (rho,), at, closer))


def gradient_pieces(least: float) -> list[tuple[arb, arb, Fraction]]:
    """Return the one piece, all ratios of radius to distance, with its `gradient_bound`."""
    first, last = RATIOS
    return [(arb(first), arb(last), gradient_bound(*base_errors(least)))]


@cache
def gradient_bound(of_u: float, of_v: float) -> Fraction:
    """Return the exact bound of a slope's error in units of (1 + k) π k 2^-53, for all wave numbers.

    of_u, of_v: bounds of the bases' errors. By theorem rounded_powers, with four roundings of π and of the products.
    """
    unit = Fraction(UNIT)
    kappa, rest = (1 + unit) ** 3, (1 + unit) ** 4

    def factors(off, most):
        return [1, *((1 + Fraction(off)) ** power * kappa ** (power - 1) for power in range(1, most + 1))]

    by_u, by_v = factors(of_u, MAX_WAVE_NUMBER // 2), factors(of_v, MAX_WAVE_NUMBER)
    pairs = product(enumerate(by_u), enumerate(by_v))
    return max((rest * f * g - 1) / (1 + max(2 * n, m, 1)) for (n, f), (m, g) in pairs) / unit
