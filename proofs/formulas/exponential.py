"""Our own exp, log and power for float64: from + − × ÷, selections and two operations on the bits.

As in `elementary`, every constant is an exact rational that float64 holds, and a line that must round in a given order
is a line of its own. A short part has so few bits that its products are exact. Theorem: elementary_functions.
"""

from sympy import And, Eq, Expr, Function, Integer, Piecewise, Rational, factorial, log, nan, oo, sqrt

from proofs.engine.half_turns import rint
from proofs.engine.program import chain
from proofs.engine.vectors import real, where
from proofs.formulas.elementary import (
    a,
    a_high,
    b,
    b_high,
    b_low,
    float64,
    polynomial,
    product,
    product_error,
    two_product,
)

binary_exponent, power_of_two = (Function(name, real=True) for name in ("binary_exponent", "power_of_two"))
"""⌊log₂|x|⌋ of a normal float64 (of 0 and what is below the normal range −1023, of inf and NaN 1024), and 2ⁿ for a
whole n from −1022 to 1023 (of other n float64 makes another number, or none)."""

OVERFLOW, UNDERFLOW = 709, -708
LARGEST = Integer(2) ** 1024 - 2**971
EXPONENTIAL_TERMS = 14  # the first left out, (ln 2 / 2)^14/14!, is below 2^-57
LOGARITHM_TERMS = 7  # the first left out, 2 q^15/15 with q < 0.06, is below 2^-59 of 2q
NODES = Rational(203, 256), Integer(1), Rational(323, 256)
NODE_1_FROM, NODE_1_BELOW = Rational(57, 64), Rational(9, 8)
SCALING = 200  # 2^200 times the least denormal is of the normal range
LIFT = 2**27  # a number below it that is added to it is rounded to a multiple of 2^-25


def _in_two(exact: Expr) -> tuple[Rational, Rational]:
    """Return (a real number rounded to 16 binary places, the float64 nearest to the rest)."""
    short = Rational(round(exact.evalf(60) * 2**16), 2**16)
    return short, float64(exact - short) if exact != short else short - exact


LN2_SHORT, LN2_REST = _in_two(log(2))


whole, away_high, away_low, away = real("whole away_high away_low away")
away_gained, away_error, away_squared, exponential_tail = real("away_gained away_error away_squared exponential_tail")
departure_low, departure, exponential_near, exponential = real("departure_low departure exponential_near exponential")

exponential_series = [float64(1 / factorial(n)) for n in range(2, EXPONENTIAL_TERMS)]
exponential_reduction = {
    whole: rint(float64(1 / log(2)) * product),
    away_high: product - LN2_SHORT * whole,
    away_low: LN2_REST * whole - product_error,
    away: away_high - away_low,
    away_gained: away_high - away,
    away_error: away_gained - away_low,
}
_even, _odd = (polynomial(away_squared, exponential_series[first::2]) for first in (0, 1))

exponential_of_sum = chain(
    "exponential_of_sum",
    exponential_reduction,
    {
        away_squared: away**2,
        exponential_tail: _even + away * _odd,
        departure_low: away_error + away_squared * exponential_tail,
        departure: away + departure_low,
        exponential_near: 1 + departure,
        exponential: Piecewise(
            (oo, product > OVERFLOW), (0, product < UNDERFLOW), (exponential_near * power_of_two(whole), True)
        ),
    },
)
"""exp(product + product_error), |product_error| < 2^-42: 2ⁿ exp(r) with |r| ≤ ln 2 / 2, by a Taylor polynomial of r.

r = away + away_error is known to some 2^-61: n times LN2_SHORT is exact, and so is the difference from the product.
Above 709 it is inf, which exp reaches at 709.8; below −708, where exp is 3 · 10^-308, it is 0; of NaN it is NaN."""

number, scaled_by, scaled, binary, mantissa, doublings = real("number scaled_by scaled binary mantissa doublings")
node, node_short, node_rest, above_node = real("node node_short node_rest above_node")
lifted, mantissa_short, mantissa_rest = real("lifted mantissa_short mantissa_rest")
sum_short, inverse = real("sum_short inverse")
undivided_near, undivided, quotient_rest, quotient, quotient_squared = real(
    "undivided_near undivided quotient_rest quotient quotient_squared"
)
log_tail, log_whole, log_whole_rest, log_quotient, log_rest = real(
    "log_tail log_whole log_whole_rest log_quotient log_rest"
)

logarithm_series = [float64(Rational(2, 2 * n + 1)) for n in range(1, LOGARITHM_TERMS)]
nodes_short, nodes_rest = zip(*(_in_two(log(one)) for one in NODES), strict=True)


def _by_node(low, middle, high):
    return Piecewise((low, mantissa < NODE_1_FROM), (middle, mantissa < NODE_1_BELOW), (high, True))


logarithm_reduction = {
    scaled_by: where(number < 1, SCALING, -SCALING),
    scaled: number * power_of_two(scaled_by),
    binary: binary_exponent(float64(sqrt(2)) * scaled),
    mantissa: scaled * power_of_two(-binary),
    doublings: binary - scaled_by,
    node: _by_node(*NODES),
    node_short: _by_node(*nodes_short),
    node_rest: _by_node(*nodes_rest),
    above_node: mantissa - node,
    lifted: mantissa + LIFT,
    mantissa_short: lifted - LIFT,
    mantissa_rest: mantissa - mantissa_short,
    sum_short: mantissa_short + node,
    inverse: 1 / (mantissa + node),
    a: above_node * inverse,
    **dict(two_product.keep(a_high).definitions),
    undivided_near: above_node - a_high * sum_short,
    undivided: undivided_near - a_high * mantissa_rest,
    quotient_rest: undivided * inverse,
}
logarithm_in_three = chain(
    "logarithm_in_three",
    logarithm_reduction,
    {
        quotient: a_high + quotient_rest,
        quotient_squared: quotient**2,
        log_tail: quotient * quotient_squared * polynomial(quotient_squared, logarithm_series),
        log_whole: LN2_SHORT * doublings + node_short,
        log_whole_rest: LN2_REST * doublings + node_rest,
        log_quotient: 2 * a_high,
        log_rest: log_tail + 2 * quotient_rest + log_whole_rest,
    },
)
"""ln(number) = log_whole + log_quotient + log_rest for a number above 0, the first two exact and of 26 bits each.

number = 2ⁿ m with √½ ≤ m < √2, n = doublings, and ln(m/node) = 2 artanh(q), q = (m − node)/(m + node), for the nearest
of three nodes; |q| < 0.06. q is the sum of a_high, of 26 bits, and the quotient of what that leaves undivided."""

log_sum, log_lost, log_sum_rest, log_low, log_near = real("log_sum log_lost log_sum_rest log_low log_near")
logarithm = real("logarithm")
natural_logarithm = chain(
    "natural_logarithm",
    logarithm_in_three,
    {
        log_sum: log_whole + log_quotient,
        log_lost: log_whole - log_sum,
        log_sum_rest: log_lost + log_quotient,
        log_low: log_sum_rest + log_rest,
        log_near: log_sum + log_low,
        logarithm: Piecewise(
            (log_near, And(number > 0, number <= LARGEST)), (oo, number > LARGEST), (-oo, Eq(number, 0)), (nan, True)
        ),
    },
)
"""ln(number): −inf at 0, inf at inf, NaN below 0 and of NaN."""

exponent, of_whole, of_quotient, product_near, product_lost = real(
    "exponent of_whole of_quotient product_near product_lost"
)
product_near_rest, product_rest, product_gained, power = real("product_near_rest product_rest product_gained power")
raised = chain(
    "raised",
    logarithm_in_three,
    {b: exponent},
    two_product.keep(b_high, b_low),
    {
        of_whole: b_high * log_whole,
        of_quotient: b_high * log_quotient,
        product_near: of_whole + of_quotient,
        product_lost: of_whole - product_near,
        product_near_rest: product_lost + of_quotient,
        product_rest: product_near_rest + b_low * log_whole + b_low * log_quotient + exponent * log_rest,
        product: product_near + product_rest,
        product_gained: product - product_near,
        product_error: product_rest - product_gained,
    },
    exponential_of_sum,
    {power: where(number <= 0, 0, exponential)},
)
"""number^exponent = exp(exponent · ln(number)), the product to some 60 bits, for an exponent from 5·10^-4 to 10^6.

0 at 0 and below it, 1 at 1; what is below e^-708 is 0, what is above e^709 inf."""
