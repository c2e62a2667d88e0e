"""Numbers with bounds, of a machine around another one: a number of the inner machine, and how far it may be off.

The machine is `renderer.machines.enclosing_machine`.

The bound encloses the value of the same formula in real arithmetic, at the exact numbers that a scene gives. The
inner machine's values stay as they are, to the last bit. A mask says where a condition holds, and where the bounds
leave it open; a selection whose mask is open covers both of its sides. The bound of an exact number is the float 0.0,
and costs nothing.

A bound is stored as a count of roundings, of 2⁻⁵³ each: the rounding of a result then adds at most its size. The counts
are computed in float64 too, and each operation may leave its count too small, by a share of less than 2⁻⁴⁹. Along a
chain of operations these shares add up. A pixel's longest chain has fewer than 2²⁸ operations, so ROUNDING, the unit
that turns a count into a bound, exceeds 2⁻⁵³ by the share 2⁻²⁰ > 2²⁸ · 2⁻⁴⁹, wherever a bound is read, compared, or
multiplied by another bound. The elementary functions read bounds, and each makes up for its own roundings by SLACK.
Theorem enclosing_rules states this, and Coq proves it of sums, products, quotients, roots, floor, rint, selections,
sinpi, cospi, atan2pi, exp, log and power as written here, not of `add_half_turns`; and so of every program of these.

Underflow loses less than LEAST, as a count less than LEAST_COUNT. A bound that is NaN decides nothing.
"""

import math
import operator
import sys
from contextvars import ContextVar
from functools import partial
from itertools import product
from typing import Any

from renderer import kernels, operations
from renderer.machines.bounded import Bounded, is_zero, plus, times
from renderer.operations import UNIT, Constant, where as inner_where

LEAST, LEAST_NORMAL = 2.0**-1060, 2.0**-1022
KEPT = 2.0**-900  # a product above it is the sum of its two parts
VANISHING = 2.0**-1020  # more than exp(−708), below which exp and power may be 0
SLACK = 1.0 + 2.0**-49
ROUNDING = UNIT * (1.0 + 2.0**-20)
LEAST_COUNT = LEAST / UNIT
ROOT_OF_ROUNDING = 2.0**26 * 1.4142136  # more than 1/√UNIT
at_work: ContextVar[Any] = ContextVar("at_work")  # the machine whose steps an operation is one of


def _scales(number):
    """Return whether a number is a literal power of two, which changes no bit of a factor."""
    return type(number.value) is float and abs(math.frexp(number.value)[0]) == 0.5


def _least(*factors):
    """Return the count that bounds a product's underflow: 0 where a factor is an exact 0 that is to stay exact."""
    least = LEAST_COUNT
    for factor in factors:
        if type(factor.value) is float:
            least = least if factor.value else 0.0
        elif factor.stays_exact:
            least = inner_where(factor.is_zero, 0.0, least)
    return least


class Mask:
    """A condition of numbers: where it `holds` as computed, and where the bounds leave it `open` (None: nowhere)."""

    def __init__(self, holds: Any, open_: Any = None):
        self.holds, self.open = holds, open_

    @property
    def maybe(self) -> Any:
        """The mask of where it may hold."""
        return self.holds if self.open is None else self.holds | self.open

    def __and__(self, other):
        return Mask(self.holds & other.holds, either(_both(self.open, other.maybe), _both(other.open, self.maybe)))

    def __or__(self, other):
        return ~(~self & ~other)

    def __invert__(self):
        return Mask(~self.holds, self.open)


def _both(open_, mask):
    return None if open_ is None else open_ & mask


def either(one: Any, other: Any) -> Any:
    """Return where one of two masks holds, of which each may be None."""
    return other if one is None else one if other is None else one | other


def _comparison(compare):
    """Return the method by which two Enclosed are compared: a Mask, open where their bounds overlap."""

    def compared(self, other):
        if self is other:  # x = x, which asks for NaN
            return Mask(compare(self.value, self.value))
        other = enclosed(other)
        roundings = plus(self.error, other.error)
        holds = compare(self.value, other.value)
        if is_zero(roundings):
            return Mask(holds)
        apart = abs(self.value - other.value) > roundings * ROUNDING
        return Mask(holds, ~apart & ~(roundings == 0.0))

    return compared


class Enclosed(Bounded):
    """A number of the inner machine, and a bound on its distance from the exact one.

    stays_exact: whether exact results are detected, at some cost: a product with an exact 0, as on the picture's
    middle line, and a sum without rounding, as of whole numbers. Its `error` is a count of roundings.
    """

    def __init__(self, value: Any, bound: Any = 0.0, stays_exact: bool = False):
        super().__init__(value, times(1.0 / UNIT, bound))
        self.stays_exact = stays_exact

    @classmethod
    def counted(cls, value: Any, roundings: Any, stays_exact: bool = False) -> "Enclosed":
        """Return an Enclosed whose bound is so many roundings."""
        number = cls(value, stays_exact=stays_exact)
        number.error = roundings
        return number

    @property
    def bound(self) -> Any:
        """The bound, from the count."""
        return times(ROUNDING, self.error)

    @property
    def size(self) -> Any:
        """An upper bound of the exact number's size."""
        return plus(abs(self.value), self.bound)

    @property
    def is_zero(self) -> Any:
        """The mask of where it is an exact 0."""
        return plus(abs(self.value), self.error) == 0.0

    @classmethod
    def of(cls, number: Any) -> "Enclosed":
        """Return a number as Enclosed, unless it is one: exact, or a Constant with the error of its rounding."""
        if isinstance(number, Enclosed):
            return number
        if isinstance(number, Constant):
            return cls(float(number), number.error)
        literal = isinstance(number, int | float)
        return cls(float(number) if literal else number, stays_exact=literal)

    @classmethod
    def rounded(cls, value: Any, moved: Any, lost: tuple[Any, bool]) -> "Enclosed":
        """Return a result whose operands' errors move it by so much.

        lost: (the bound of its own rounding, whether it stays exact).
        """
        rounding, stays_exact = lost
        return cls.counted(value, plus(moved, rounding), stays_exact)

    def lost_in_sum(self, other: "Enclosed", total: Any) -> tuple[Any, bool]:
        """Return a bound of a sum's rounding error; where that may be 0 the error itself, by two more sums (Knuth)."""
        stays_exact = self.stays_exact and other.stays_exact
        if not (stays_exact or is_zero(plus(self.error, other.error))):
            return abs(total), False
        part = total - self.value
        return abs((self.value - (total - part)) + (other.value - part)) * (1.0 / UNIT), stays_exact

    def lost_in_product(self, other: "Enclosed", product: Any) -> tuple[Any, bool]:
        """Return a bound of a product's rounding error: 0 by a literal power of two, above the subnormal range."""
        stays_exact = self.stays_exact or other.stays_exact
        for literal, scaled in ((self, other), (other, self)):
            if _scales(literal):
                lost = 0.0 if abs(literal.value) >= 1.0 else _least(scaled)
                if scaled.stays_exact and not is_zero(lost):
                    lost = inner_where(abs(product) <= LEAST_NORMAL, lost, 0.0)  # to which it may be rounded up
                return lost, stays_exact
        return plus(abs(product), _least(self, other)), stays_exact

    def size_of_quotient(self, quotient: Any) -> Any:
        """Return a bound of a quotient's size before it was rounded."""
        return plus(abs(quotient), _least(self))

    def lost_in_quotient(self, size: Any) -> tuple[Any, bool]:
        """Return a bound of the rounding error of a quotient of that size."""
        return size, self.stays_exact

    def inverse(self) -> Any:
        """Return a bound of 1/|b| for every b within the bound of this number: infinite where b may be 0."""
        if is_zero(self.error):
            return 1.0 / abs(self.value)
        least = abs(self.value) - self.bound
        return inner_where(least > 0.0, 1.0 / least, math.inf)

    def __neg__(self):
        return Enclosed.counted(-self.value, self.error, self.stays_exact)

    def __abs__(self):
        return Enclosed.counted(abs(self.value), self.error, self.stays_exact)

    __lt__ = _comparison(operator.lt)
    __le__ = _comparison(operator.le)
    __gt__ = _comparison(operator.gt)
    __ge__ = _comparison(operator.ge)
    __eq__ = _comparison(operator.eq)
    __ne__ = _comparison(operator.ne)


enclosed = Enclosed.of


def _ends(number):
    """Return the ends of an interval around the exact number: one end where it is exact, else two."""
    if is_zero(number.bound):
        return (number.value,)
    reach = (number.bound + 2.0 * UNIT * abs(number.value)) * SLACK
    return number.value - reach, number.value + reach


def _rarely(mask, value, otherwise):
    """Return `value()` where a mask holds; it is not called for a group in which the mask holds nowhere."""
    machine = getattr(mask, "machine", None)
    if not hasattr(machine, "when"):
        return inner_where(mask, value(), otherwise)
    chosen = machine.variable(otherwise)
    machine.when(mask, lambda: chosen.set(value(), mask))
    return chosen.value


def where(mask: Mask, value: Any, otherwise: Any) -> Enclosed:
    """Return the selected side; where the mask is open, within the bounds of both."""
    if not isinstance(mask, Mask):
        mask = Mask(mask)
    value, otherwise = enclosed(value), enclosed(otherwise)
    chosen = inner_where(mask.holds, value.value, otherwise.value)
    exact = is_zero(value.error) and is_zero(otherwise.error)
    roundings = 0.0 if exact else inner_where(mask.holds, value.error, otherwise.error)
    if mask.open is not None:
        apart = abs(value.value - otherwise.value) * (1.0 / UNIT)
        roundings = inner_where(mask.open, plus(apart, value.error, otherwise.error), roundings)
    return Enclosed.counted(chosen, roundings, value.stays_exact and otherwise.stays_exact)


def sqrt(number: Enclosed) -> Enclosed:
    """Return √a: |√a − √b| ≤ |a − b|/√a, and where |a − b| exceeds a, also ≤ √|a − b|, which is less."""
    root, moved = operations.sqrt(number.value), 0.0
    if not is_zero(number.error):
        near_zero = ~(number.error < number.value * (1.0 / UNIT))
        moved = _rarely(near_zero, lambda: operations.sqrt(number.error) * ROOT_OF_ROUNDING, number.error / root)
    return Enclosed.counted(root, plus(moved, root), number.stays_exact)


def _integer(number, integer, away):
    """Return an integer with its bound: ⌊the argument's⌋, and 1 more where that reaches a jump, which is `away`."""
    if is_zero(number.error):
        return Enclosed(integer, stays_exact=True)
    reaches = (away <= number.bound * SLACK) & (number.error > 0.0)
    further = operations.floor(number.bound)
    return Enclosed(integer, inner_where(reaches, 1.0 + further, further), True)


def floor(number: Enclosed) -> Enclosed:
    """Return ⌊a⌋; a whole number within the bound of `a` may be on either side of it."""
    away = abs(number.value - operations.rint(number.value))
    return _integer(number, operations.floor(number.value), away)


def rint(number: Enclosed) -> Enclosed:
    """Return the whole number nearest to a; a half within the bound of `a` may be on either side of it."""
    nearest = operations.rint(number.value)
    return _integer(number, nearest, abs(abs(number.value - nearest) - 0.5))


def two_product(a: Any, b: Any) -> tuple[Enclosed, Enclosed]:
    """Return a product in two parts, for sinpi and cospi: their sum is exact, unless it underflows."""
    a, b = enclosed(a), enclosed(b)
    product, rest = kernels.two_product(a.value, b.value)
    stays_exact, lost = a.stays_exact or b.stays_exact, 0.0
    if stays_exact:
        lost = inner_where((abs(product) < KEPT) & (operations.minimum(a.size, b.size) > 0.0), LEAST_COUNT, 0.0)
    return Enclosed.counted(product, a.product_moves(b), stays_exact), Enclosed.counted(rest, lost, True)


def add_half_turns(a: Any, b: Any) -> tuple[Enclosed, Enclosed]:
    """Return a sum of half-turns in two parts, for sinpi and cospi: the second is the first's rounding error."""
    a, b = enclosed(a), enclosed(b)
    total, lost = operations.add_half_turns(a.value, b.value)
    return Enclosed.counted(total, plus(a.error, b.error), a.stays_exact and b.stays_exact), Enclosed(lost, 0.0, True)


def _of_half_turns(kernel: Any, turns: Any, rest: Any = 0.0) -> Enclosed:
    """Return sin πx or cos πx of a number in two parts: its slope is at most π, and it moves by 2 at most."""
    turns, rest = enclosed(turns), enclosed(rest)
    moved = times(ROUNDING, plus(turns.error, rest.error))
    result = kernel(turns.value, rest.value)
    rounding = kernels.ROUNDINGS[kernel.__name__] * UNIT * abs(result) + LEAST
    if turns.stays_exact:  # a result 0 is exact: underflow of the parts is counted in their errors
        rounding = inner_where(result == 0.0, 0.0, rounding)
    if is_zero(moved):
        return Enclosed(result, rounding * SLACK)
    turned = math.pi * SLACK * moved
    return Enclosed(result, (inner_where(turned < 2.0, turned, 2.0) + rounding) * SLACK)


sinpi = partial(_of_half_turns, kernels.sinpi)
cospi = partial(_of_half_turns, kernels.cospi)


def atan2pi(ordinate: Any, abscissa: Any) -> Enclosed:
    """Return atan2(y, x)/π. The angle moves by arcsin s, s = (|x| Δy + |y| Δx)/r(r − Δx − Δy), below 1/4 within 1.02 s.

    Where the bounds reach over the cut, y = 0 and x < 0, or s is 1/4 or more, the angle may be any. On an axis it is
    exact.
    """
    y, x = enclosed(ordinate), enclosed(abscissa)
    angle = kernels.atan2pi(y.value, x.value)
    rounding = kernels.ROUNDINGS["atan2pi"] * UNIT * abs(angle) + LEAST
    moved = plus(y.bound, x.bound)
    if is_zero(moved):
        return Enclosed(angle, rounding * SLACK)
    radius = operations.sqrt(x.value * x.value + y.value * y.value)
    across = plus(times(abs(x.value), y.bound), times(abs(y.value), x.bound))
    sine = across / (radius * (radius - moved))
    near = (moved < 0.5 * radius) & (sine < 0.249)
    bound = inner_where(near, sine * (1.02 / math.pi) * SLACK, 2.0) + rounding
    over_the_cut = (x.value < 0.0) & (abs(y.value) <= y.bound * SLACK)
    bound = inner_where(over_the_cut, 2.0, bound) * SLACK
    if not (x.stays_exact and y.stays_exact):
        return Enclosed(angle, bound)
    on_axis = (y.is_zero & (abs(x.value) > x.bound)) | (x.is_zero & (abs(y.value) > y.bound))
    return Enclosed(angle, inner_where(on_axis, 0.0, bound), True)


def _monotone(kernel, roundings, result, arguments, vanishing=0.0):
    """Return `result` with its bound: the function is monotone in each argument, so furthest at some ends of these.

    The roundings are charged at that end, and for `result` again: with SLACK an end may be off by up to 8 more.
    """

    def rounding_of(value):
        return roundings(value) * UNIT * abs(value) + vanishing

    moved, furthest = plus(*(argument.bound for argument in arguments)), 0.0
    if is_zero(moved):
        return Enclosed(result, 2.0 * rounding_of(result) * SLACK)
    for ends in product(*map(_ends, arguments)):
        end = kernel(*ends)
        away = abs(end - result) + rounding_of(end)
        furthest = inner_where(away > furthest, away, furthest)
    return Enclosed(result, (inner_where(moved < math.inf, furthest, math.inf) + rounding_of(result)) * SLACK)


def exp(product: Any, factor: Any = 1.0) -> Enclosed:
    """Return exp ab."""
    a, b = enclosed(product), enclosed(factor)
    result = kernels.exp(*kernels.two_product(a.value, b.value))
    return _monotone(kernels.exp, lambda _: kernels.ROUNDINGS["exp"], result, [a * b], VANISHING)


def log(number: Enclosed) -> Enclosed:
    """Return log a: −∞ where a may be 0."""

    def of_positive(end):
        return kernels.log(operations.maximum(0.0, end))

    return _monotone(of_positive, lambda _: kernels.ROUNDINGS["log"], kernels.log(number.value), [number])


def power(number: Any, exponent: Any) -> Enclosed:
    """Return a^p: 0 for a number that is certainly not positive."""
    number, exponent = enclosed(number), enclosed(exponent)

    def roundings(result):
        return inner_where(result < kernels.SMALL_POWER, kernels.ROUNDINGS["small_power"], kernels.ROUNDINGS["power"])

    result = kernels.power(number.value, exponent.value)
    vanishing = inner_where(_ends(number)[-1] > 0.0, VANISHING, 0.0)
    return _monotone(kernels.power, roundings, result, [number, exponent], vanishing)


def sign(number: Any) -> Enclosed:
    """Return −1, 0 or 1. A gradient asks for it at a crease: where its side is open, so is the pixel."""
    at_work.get().leave_open((number > 0.0).open)
    return operations.sign.kernel(number)


Mask.machine = Enclosed.machine = sys.modules[__name__]  # type: ignore[attr-defined]  # `renderer.operations` asks it
