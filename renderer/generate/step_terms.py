"""What the error of a central difference is made of at a point, each term at most so large, by the theorems.

Each is a function of float64 numbers, NumPy's arrays or traced values, as the kernels are.
"""

from collections.abc import Callable

from sympy import Abs, Mul

from proofs.formulas import step_bounds
from proofs.formulas.half_turns import cospi, sinpi
from proofs.formulas.height_fields import HEIGHT_FIELDS, HeightField
from proofs.formulas.symbols import u as along_u
from proofs.formulas.symbols import v as along_v
from renderer.generate.kernels import function_of
from renderer.kernels import FIELDS
from renderer.operations import floor, maximum, minimum, rint, where

UNIT = 2.0**-53
THREE_ROUNDINGS = 2 * UNIT
"""Where the span is rounded as well: 2 · 2μ + (2μ)² is above (3μ + μ²)/(1 − μ), as the theorem has it for that case."""
HEIGHT_ERROR = 3 * 2.0**-52
"""What a height is off by: a sine of a product is good to 2 ulp, as verify/ measures; two of them and their product."""
ARGUMENT_ERROR = 2.0**-53
"""What rounding u + ε moves it by."""
TERMS = ("truncation", "rounded argument", "rounded value", "crease, seam or pole")

truncation_bound, clamped_bound, rounding_bound, crease_bound, slope_bound = map(function_of, step_bounds.BOUNDS)


def is_covered(field: HeightField) -> bool:
    """Return whether the theorems bound a field's differences.

    They do if h, or its absolute value, is a product of at most one sine or cosine of πau and one of πbv, a and b the
    field's wave numbers, and if it is creased where a factor of the absolute value is zero and nowhere else.
    """
    if field.wave_numbers is None:
        return False
    folded = isinstance(field.expression, Abs)
    factors = Mul.make_args(field.expression.args[0] if folded else field.expression)
    allowed = [{f(w * c) for f in (sinpi, cospi)} for w, c in zip(field.wave_numbers, (along_u, along_v), strict=True)]
    known = all(any(factor in pair for pair in allowed) for factor in factors)
    once = all(len(pair & {*factors}) <= 1 for pair in allowed) and len({*factors}) == len(factors)
    return known and once and {*field.creases} == ({*factors} if folded else set())


def bounds_of(field: HeightField) -> Callable | None:
    """Return the function (u, v, k_u, k_v, ε) → (bound, leading, a bound for each of TERMS) of a field, or None.

    They are those of the slope, h_u or h_v, whose error may be larger, by the central difference. The bound is their
    sum; `leading` is the number of the largest, counted from 1. Raises no error; None where nothing is proved.
    """
    if field.wave_numbers is None or not is_covered(field):
        return None
    in_v = sinpi(field.wave_numbers[1] * along_v)
    wave_numbers = FIELDS[field.name]["wave_numbers"]
    is_odd = in_v in field.expression.atoms(sinpi)

    def clear(rate, coordinate, epsilon):
        """Return whether no crease lies within ε along a coordinate."""
        met = rate * coordinate
        return abs(met - rint(met)) >= rate * epsilon if field.creases else rate >= 0.0

    def rounded(rate, half_span, unit):
        steepest = slope_bound(rate)
        value = rounding_bound(half_span, steepest, unit, HEIGHT_ERROR, 0.0)
        return rounding_bound(half_span, steepest, unit, HEIGHT_ERROR, ARGUMENT_ERROR) - value, value

    def terms(rate, half_span, unit, is_smooth, truncation):
        """Return the terms of one slope: 2πk at most, whatever lies within ε; none where h does not depend on it."""
        most, (argument, value) = crease_bound(rate), rounded(rate, half_span, unit)
        found = where(is_smooth, minimum(most, truncation), 0.0), argument, value, where(is_smooth, 0.0, most)
        return [where(rate > 0.0, term, 0.0) for term in found]

    def bounds(u, v, k_u, k_v, epsilon):
        a, b = (abs(0.0 * u + rate) for rate in wave_numbers(k_u, k_v))
        whole_periods = 0.5 * a == floor(0.5 * a)  # then the seam is none
        seamless = ((u - epsilon >= 0.0) & (u + epsilon < 1.0)) | whole_periods
        in_u = terms(a, epsilon, UNIT, clear(a, u, epsilon) & seamless, truncation_bound(epsilon, a))
        inside = clear(b, v, epsilon) & (v - epsilon >= 0.0) & (v + epsilon <= 1.0)
        clamped = ~inside & (v < epsilon) & (v + epsilon <= 1.0)  # at the pole, where h has to be odd
        clamped = clamped & (b * (v + epsilon) <= 1.0) if field.creases else clamped
        clamped = clamped & (b >= 0.0 if is_odd else b < 0.0)
        truncation = where(inside, truncation_bound(epsilon, b), clamped_bound(epsilon, v, b))
        half_span = 0.5 * (minimum(1.0, v + epsilon) - maximum(0.0, v - epsilon))
        in_v = terms(b, half_span, THREE_ROUNDINGS, inside | clamped, truncation)
        return _larger(in_u, in_v)

    bounds.__name__ = f"bounds_{field.name}"
    return bounds


def _larger(one, other):
    """Return (sum, number of the largest, terms) of the terms whose sum is larger."""
    sums = [(terms[0] + terms[1]) + (terms[2] + terms[3]) for terms in (one, other)]
    terms = [where(sums[0] > sums[1], *pair) for pair in zip(one, other, strict=True)]
    leading, largest = 1.0, terms[0]
    for number, term in enumerate(terms[1:], start=2):
        leading, largest = where(term > largest, float(number), leading), where(term > largest, term, largest)
    return where(sums[0] > sums[1], *sums), leading, *terms


BOUNDS = {name: bounds for name, field in HEIGHT_FIELDS.items() if (bounds := bounds_of(field))}
"""{field: its bounds}, of those that the theorems cover."""
