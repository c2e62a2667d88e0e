"""Our own sinpi, cospi and atan2pi for float64: exact argument reduction, then a Taylor polynomial.

Every constant is an exact rational that float64 holds. The polynomials are truncated alternating series, so the
error of truncation is below the first term left out. A line that must round in a given order is a line of its own.
Theorem: elementary_functions.
"""

from collections.abc import Sequence
from sys import float_info

from sympy import Abs, Expr, Max, Min, Piecewise, Rational, Symbol, atan, factorial, floor, pi

from proofs.engine.half_turns import rint
from proofs.engine.program import Program, chain
from proofs.engine.vectors import real, where

SINE_TERMS = 9  # the first left out, (π/4)^18/19!, is below 2^-62 of the sine
COSINE_TERMS = 9  # (π/4)^18/18! is below 2^-58
ARCTANGENT_TERMS = 16  # (5/16)^32/33 is below 2^-58
SPLITTER = 2**27 + 1


def float64(exact: Expr) -> Rational:
    """Return the float64 nearest to a real number of the normal range, as an exact rational."""
    as_many_digits_as_bits = exact.evalf(float_info.mant_dig)
    return Rational(float(str(as_many_digits_as_bits)))


def polynomial(variable: Symbol, coefficients: Sequence[Expr]) -> Expr:
    """Return Horner's form of Σ coefficients[i] · variable^i."""
    result = coefficients[-1]
    for coefficient in reversed(coefficients[:-1]):
        result = coefficient + variable * result
    return result


a, b, product, product_error = real("a b product product_error")
a_split, a_excess, a_high, a_low = real("a_split a_excess a_high a_low")
b_split, b_excess, b_high, b_low = real("b_split b_excess b_high b_low")
error_1, error_2, error_3 = real("error_1 error_2 error_3")

two_product = Program(
    "two_product",
    (a, b),
    {
        product: a * b,
        a_split: SPLITTER * a,
        a_excess: a_split - a,
        a_high: a_split - a_excess,
        a_low: a - a_high,
        b_split: SPLITTER * b,
        b_excess: b_split - b,
        b_high: b_split - b_excess,
        b_low: b - b_high,
        error_1: a_high * b_high - product,
        error_2: error_1 + a_high * b_low,
        error_3: error_2 + a_low * b_high,
        product_error: error_3 + a_low * b_low,
    },
    (product, product_error),
)
"""a b = product + product_error, exactly in float64 (Veltkamp 1968, Dekker 1971): without it a product k·u that
rounds to a whole number would pass for a crease (F9). In exact arithmetic product_error is 0."""

quarters, remainder, remainder_high, quadrant, z = real("quarters remainder remainder_high quadrant z")
sine_tail, sine_near, cosine_near, sine, cosine = real("sine_tail sine_near cosine_near sine cosine")

PI_HIGH = float64(pi)
PI_LOW = float64(pi - PI_HIGH)
sine_series = [float64((-1) ** n * pi ** (2 * n + 1) / factorial(2 * n + 1)) for n in range(1, SINE_TERMS)]
cosine_series = [float64((-1) ** n * pi ** (2 * n) / factorial(2 * n)) for n in range(1, COSINE_TERMS)]

reduction = {
    quarters: rint(2 * product),
    remainder_high: product - quarters / 2,
    remainder: remainder_high + product_error,
    quadrant: quarters - 4 * floor(quarters / 4),
    z: remainder**2,
    sine_tail: PI_LOW + z * polynomial(z, sine_series),
    sine_near: remainder * (PI_HIGH + sine_tail),
    cosine_near: 1 + z * polynomial(z, cosine_series),
}


def _by_quadrant(*values):
    *before, last = values
    return Piecewise(*((value, quadrant < Rational(2 * n + 1, 2)) for n, value in enumerate(before)), (last, True))


sine_of_half_turns = chain(
    "sine_of_half_turns", reduction, {sine: _by_quadrant(sine_near, cosine_near, -sine_near, -cosine_near)}
)
"""sin π(product + product_error). The argument is reduced, exactly, to a quarter of a half-turn: zeros are exact."""

cosine_of_half_turns = chain(
    "cosine_of_half_turns", reduction, {cosine: _by_quadrant(cosine_near, -sine_near, -cosine_near, sine_near)}
)
"""cos π(product + product_error), reduced in the same way."""

ordinate, abscissa, larger, smaller, steep, middle = real("ordinate abscissa larger smaller steep middle")
node, node_value, node_correction, ratio, ratio_squared = real("node node_value node_correction ratio ratio_squared")
denominator, arctangent_tail, first_octant, first_quadrant, half_plane, angle = real(
    "denominator arctangent_tail first_octant first_quadrant half_plane angle"
)
small_part = real("small_part")

_half = Rational(1, 2)
_value_at_half = float64(atan(_half) / pi)
_correction_at_half = float64(atan(_half) / pi - _value_at_half)
arctangent_series = [float64((-1) ** n / ((2 * n + 1) * pi)) for n in range(ARCTANGENT_TERMS)]
_inverse_pi_low = float64(1 / pi - arctangent_series[0])

angle_in_half_turns = Program(
    "angle_in_half_turns",
    (ordinate, abscissa),
    {
        larger: Max(Abs(abscissa), Abs(ordinate)),
        smaller: Min(Abs(abscissa), Abs(ordinate)),
        middle: where(smaller > 5 * larger / 16, 1, 0),
        steep: where(smaller > 3 * larger / 4, 1, 0),
        node: Piecewise((1, steep > 0), (_half, middle > 0), (0, True)),
        node_value: Piecewise((Rational(1, 4), steep > 0), (_value_at_half, middle > 0), (0, True)),
        node_correction: Piecewise((0, steep > 0), (_correction_at_half, middle > 0), (0, True)),
        denominator: larger + node * smaller,
        ratio: where(larger > 0, (smaller - node * larger) / denominator, 0),
        ratio_squared: ratio**2,
        arctangent_tail: _inverse_pi_low + ratio_squared * polynomial(ratio_squared, arctangent_series[1:]),
        small_part: node_correction + ratio * (arctangent_series[0] + arctangent_tail),
        first_octant: node_value + small_part,
        first_quadrant: where(Abs(ordinate) > Abs(abscissa), _half - first_octant, first_octant),
        half_plane: where(abscissa < 0, 1 - first_quadrant, first_quadrant),
        angle: where(ordinate < 0, -half_plane, half_plane),
    },
)
"""atan2(ordinate, abscissa)/π, and 0 at the origin: three nodes 0, 1/2 and 1, from which
the ratio's numerator is exact or nearly so; `ratio` stays below 5/16."""
