"""Bounds of a difference's error at a point, term by term, by the theorems: pages and simulator show them.

Functions of float64 numbers, NumPy's arrays or traced values, as the kernels are (under `numpy.errstate`: a selection
computes both of its sides). Each number has ROOM for the rounding of the lines that compute it.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

from sympy import Abs, Expr, Mul

from proofs.engine.half_turns import cospi, sinpi
from proofs.formulas import step_bounds
from proofs.formulas.certified import PROVED, SINE
from proofs.formulas.height_fields import HEIGHT_FIELDS, HeightField
from proofs.formulas.step_bounds import TERMS
from proofs.formulas.symbols import u as along_u, v as along_v
from renderer import kernels
from renderer.generate.kernels import function_of
from renderer.generate.programs import field_programs
from renderer.operations import UNIT, Mask, Number, floor, inf, maximum, minimum, rint, where

ROOM = 1 + 2.0**-40
SINE_ROUNDINGS = float(SINE)
SHARED = UNIT * float(PROVED["of_product_relative"])  # of itself, of a factor that does not move: in both heights
ARGUMENT = TERMS.index("argument rounding")
TRUNCATION, STRADDLING, ONE_SIDED = (float(TERMS.index(term)) for term in ("truncation", "straddling", "one-sided"))

slope_bound, truncation_bound, forward_bound, fourth_bound, clamped_bound, crease_bound, tent_bound, rounding_bound = (
    map(
        function_of,
        (
            step_bounds.slope_bound,
            step_bounds.truncation_bound,
            step_bounds.forward_bound,
            step_bounds.fourth_bound,
            step_bounds.clamped_bound,
            step_bounds.crease_bound,
            step_bounds.tent_bound,
            step_bounds.rounding_bound,
        ),
    )
)
TWO_ROUNDINGS = function_of(step_bounds.two_roundings)(UNIT)
THREE_ROUNDINGS = function_of(step_bounds.three_roundings)(UNIT)


class Rule(NamedTuple):
    """A difference: by how many steps it moves at most, and the numbers that its bounds have.

    smooth: the truncation's bound. apart, jump: how far quotient and slope may be apart, over 2πk; and by a jump, over
    that over a step. span: of the samples, in steps. share, excess: of the central difference's rounding errors, and
    of its quotient's roundings.
    """

    reach: float
    smooth: Callable
    apart: float
    jump: float
    span: float
    share: float = 1.0
    excess: float = TWO_ROUNDINGS


RULES = {
    "forward": Rule(1.0, forward_bound, 1.0, 1.0, 1.0),
    "central": Rule(1.0, truncation_bound, 1.0, 0.5, 2.0),
    "central4": Rule(2.0, fourth_bound, 4 / 3, 0.75, 2.0, 1.5, 10 / 9 * ((1 + UNIT) ** 5 - 1)),
}
"""Theorems: roundoff_bound, forward_and_fourth_order. Fourth order has weights (8, 8, 1, 1)/12: 3/2 of the
errors that two samples 2ε apart have, five roundings, and a quotient of at most 5/3 πk."""


class Side(NamedTuple):
    """One coordinate of a point, and the factor of h that depends on it: sin πkx, cos πkx, or None where h does not.

    rate: k ≥ 0, in half-turns per unit. folded: whether the field is the absolute value, creased where the factor is 0.
    """

    factor: Expr | None
    folded: bool
    rate: Number
    at: Number

    @property
    def is_sine(self) -> bool:
        """True where the factor is a sine: odd about 0."""
        return isinstance(self.factor, sinpi)

    def height(self, at: Number) -> Number:
        """Return the factor somewhere, or its absolute value if the field is one."""
        if self.factor is None:
            return 1.0
        value = (kernels.sinpi if self.is_sine else kernels.cospi)(*kernels.two_product(self.rate, at))
        return abs(value) if self.folded else value

    def slope(self) -> Number:
        """Return the size of the factor's derivative over πk at the point; on either side, if that is a crease."""
        return abs((kernels.cospi if self.is_sine else kernels.sinpi)(*kernels.two_product(self.rate, self.at)))

    def crease(self, epsilon: Number, rule: Rule, nearest_to: Callable) -> tuple[Mask, Number]:
        """Return (whether the nearest zero lies between the samples, the central difference's tent bound).

        The bound is infinite where a second zero may lie there, and for the other differences. nearest_to: the function
        from the point's half-turns to the zero's.
        """
        product, error = kernels.two_product(self.rate, self.at)
        distance = abs((product - nearest_to(product)) + error) / ROOM
        tent = tent_bound(epsilon, minimum(epsilon, distance / self.rate), self.rate)
        alone = (self.rate * epsilon + distance) * ROOM <= 1.0
        tent = where(alone, tent, inf) if rule is RULES["central"] else inf
        return distance < self.rate * rule.reach * epsilon, tent


def factors_of(field: HeightField) -> tuple[Expr | None, Expr | None] | None:
    """Return the factors of u and of v that a field, or what it is the absolute value of, is the product of.

    None for one that is missing, and in place of both for a field whose differences no theorem bounds. The theorems do
    where the factors are one sine or cosine of πau and one of πbv, a and b the wave numbers; an absolute value is
    creased where one of them is 0.
    """
    if field.wave_numbers is None:
        return None
    folded = isinstance(field.expression, Abs)
    factors = Mul.make_args(field.expression.args[0] if folded else field.expression)
    waves = [w * c for w, c in zip(field.wave_numbers, (along_u, along_v), strict=True)]
    of_u, of_v = (next((f for f in factors if w != 0 and f in (sinpi(w), cospi(w))), None) for w in waves)
    return (of_u, of_v) if {of_u, of_v} - {None} == {*factors} else None


def half_unit(number: Number) -> Number:
    """Return half a unit in the last place of a float64, from its unit in the first place by three roundings.

    Source: Rump, Ogita and Oishi, Accurate Floating-Point Summation Part I, 2008, algorithm 3.6.
    """
    large = (2.0**52 + 1) * number
    return UNIT * abs(large - (1 - UNIT) * large)


def moved_by(place: Number, step: Number, further: Number) -> Number:
    """Return by how much rounding moves place ± steps at most: not at all where all are exact, by Knuth's sum."""

    def exact(step):
        total = place + step
        other = total - place
        return (place - (total - other)) + (step - other) == 0.0

    near, far = (exact(each) & exact(-each) for each in (step, further))
    return where(near & far, 0.0, half_unit(place + further))


def _exact_in_u(side, epsilon, rule):
    """Return (kind, bound, jump) of the error in u in exact arithmetic; jump: by how much h jumps between the samples.

    Beside the seam a sine of odd k is, up to its sign, the absolute value: creased.
    """
    reach = rule.reach * epsilon
    wraps = (side.at - reach < 0.0) | (side.at + reach >= 1.0)
    jump = where(wraps, abs(side.height(0.0) - side.height(1.0)), 0.0)
    shift = 0.0 if side.is_sine else 0.5
    crossed, tent = side.crease(epsilon, rule, lambda product: rint(product - shift) + shift)
    if not side.folded:
        crossed = crossed & wraps & (0.5 * side.rate != floor(0.5 * side.rate))
    most = rule.apart * crease_bound(side.rate) + rule.jump * jump / epsilon
    bound = where(jump > 0.0, most, minimum(most, where(crossed, tent, rule.smooth(epsilon, side.rate))))
    return where(crossed | (jump > 0.0), STRADDLING, TRUNCATION), bound, jump


def _exact_in_v(side, epsilon, inside, rule):
    """Return (kind, bound, no jump) of the error in v in exact arithmetic. Zeros at the poles are no creases.

    Clamped at the pole v = 0, a sine keeps second order, but not where a factor that is folded is 0: at the pole itself
    its slope is 0 by the rule of creases. A factor that is clamped there, or at the other pole, has the crudest bound.
    """
    smooth, most = rule.smooth(epsilon, side.rate), rule.apart * crease_bound(side.rate)
    clamped = where(side.at + epsilon <= 1.0, clamped_bound(epsilon, side.at, side.rate), inf) if side.is_sine else inf
    bound, kind = where(inside, smooth, clamped), where(inside, TRUNCATION, ONE_SIDED)
    if side.folded:
        first = 1.0 if side.is_sine else 0.5
        last = first - 1.0 - floor(first - side.rate)  # the largest zero below k
        crossed, tent = side.crease(
            epsilon, rule, lambda product: minimum(maximum(rint(product - first) + first, first), last)
        )
        crossed = crossed & (last >= first)
        bound = where(crossed, where(inside, tent, inf), where((side.at > 0.0) & (side.at < 1.0), bound, inf))
        kind = where(crossed, STRADDLING, kind)
    return kind, minimum(most, bound), 0.0 * epsilon


def _terms(side, still, epsilon, span, excess, moved, exact, rule):
    """Return a bound for each of TERMS of one slope.

    still: the Side that the step does not move. excess: of the quotient's roundings. moved: by how much rounding moves
    an argument at most. exact: (kind, bound, jump) of the error in exact arithmetic.
    """
    if side.factor is None:
        return [0.0 * epsilon for _ in TERMS]
    (kind, bound, jump), fixed = exact, abs(still.height(still.at))
    reach = where(jump > 0.0, 1.0, slope_bound(side.rate) * (rule.reach * epsilon + moved))  # nothing is past a jump
    steepest = slope_bound(side.rate) * fixed * minimum(1.0, side.slope() + reach)
    largest = minimum(1.0, abs(side.height(side.at)) + reach)
    height = minimum(SINE_ROUNDINGS * UNIT, SHARED * largest) * fixed
    if still.factor is not None:
        height, excess = height + UNIT * largest * fixed, excess + SHARED + excess * SHARED
    argument = rule.share * rounding_bound(span, steepest, 0.0, 0.0, moved)
    value = rule.share * rounding_bound(span, steepest + jump / span, excess, height, 0.0)
    terms = [where(kind == float(number), bound, 0.0) for number in range(len(TERMS))]
    terms[1:3] = argument, value
    far = rule.reach * epsilon
    lost = (side.at + far == side.at) & (side.at - far == side.at)  # one height for all: the error is the slope
    slope = slope_bound(side.rate) * fixed * side.slope()
    lost_terms = (where(lost, slope if number == ARGUMENT else 0.0, term) for number, term in enumerate(terms))
    return [where(side.rate > 0.0, ROOM * term, 0.0) for term in lost_terms]


def slope_terms(field: HeightField, method: str = "central") -> Any:
    """Return the function (u, v, k_u, k_v, ε) → (a bound for each of TERMS of h_u, the same of h_v), or None.

    They bound a difference's error. u in [0, 1), v in [0, 1], 0 < ε ≤ 1/2. None where no theorem covers the field.
    """
    if (factors := factors_of(field)) is None:
        return None
    folded, wave_numbers = isinstance(field.expression, Abs), function_of(field_programs(field)["wave_numbers"])

    def terms(u, v, k_u, k_v, epsilon):
        rates = (abs(0.0 * epsilon + rate) for rate in wave_numbers(k_u, k_v))
        in_u, in_v = map(Side, factors, (folded, folded), rates, (u, v))

        def of_u(rule):
            reach = rule.reach * epsilon
            wraps = (u - reach < 0.0) | (u + reach >= 1.0)  # and is rounded once more
            moved, exact = moved_by(u, epsilon, reach) + where(wraps, UNIT / 2, 0.0), _exact_in_u(in_u, epsilon, rule)
            return _terms(in_u, in_v, epsilon, rule.span * epsilon, rule.excess, moved, exact, rule)

        def of_v(rule, inside):
            span = where(inside, rule.span * epsilon, minimum(1.0, v + epsilon) - maximum(0.0, v - epsilon))
            excess, exact = where(inside, rule.excess, THREE_ROUNDINGS), _exact_in_v(in_v, epsilon, inside, rule)
            return _terms(in_v, in_u, epsilon, span, excess, moved_by(v, epsilon, rule.reach * epsilon), exact, rule)

        rule = RULES[method]
        near, far = ((v - reach >= 0.0) & (v + reach <= 1.0) for reach in (epsilon, 2.0 * epsilon))
        if method == "central4":  # is central where a far sample would leave the chart
            pairs = zip(of_v(rule, far), of_v(RULES["central"], near), strict=True)
            return of_u(rule), [where(far, *pair) for pair in pairs]
        return of_u(rule), of_v(rule, near if method == "central" else v >= 0.0)  # forward turns round at a pole

    return terms


def bounds_of(field: HeightField, method: str = "central") -> Callable | None:
    """Return the function (u, v, k_u, k_v, ε) → (bound, leading, bound of h_u, bound of h_v) of a field, or None.

    Each bound is the sum of its terms. The first is the larger; `leading` its largest term's place in TERMS, from 1 on.
    """
    if (terms := slope_terms(field, method)) is None:
        return None

    def bounds(u, v, k_u, k_v, epsilon):
        pairs = terms(u, v, k_u, k_v, epsilon)
        of_u, of_v = (sum(part[1:], part[0]) for part in pairs)
        leading, largest = 0.0, 0.0
        for number, pair in enumerate(zip(*pairs, strict=True), start=1):
            term = where(of_u > of_v, *pair)
            leading, largest = where(term > largest, float(number), leading), maximum(largest, term)
        return maximum(of_u, of_v), leading, of_u, of_v

    bounds.__name__ = f"bounds_{field.name}_{method}"
    return bounds


COVERED = {name: field for name, field in HEIGHT_FIELDS.items() if factors_of(field)}
SLOPE_TERMS = {name: slope_terms(field) for name, field in COVERED.items()}
"""{field: what bounds its central difference}, of the fields that the theorems cover."""
BOUNDS = {(name, method): bounds_of(field, method) for name, field in COVERED.items() for method in RULES}
"""{(field, method): what bounds it}"""
