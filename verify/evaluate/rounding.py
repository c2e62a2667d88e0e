"""Running error analysis: a float64 result as the set of values that it should have, and how far off it can be.

A `Rounded` goes through the printed text of a straight-line program in place of a float. Each operation adds what it
inherits and half a unit in the last place of the largest result that it can have: round to nearest, no underflow.
"""

from collections.abc import Iterable, Mapping
from types import CodeType

from flint import arb

from verify.evaluate import ANY_NUMBERS

ZERO, TINY = arb(0), arb((1, -100))


def between(low: arb, high: arb) -> arb:
    """Return a ball around [low, high]."""
    return arb(low).union(arb(high))


class Undecided(ArithmeticError):
    """A comparison that the enclosures do not decide."""


def unit_in_the_last_place(magnitude: arb) -> arb:
    """Return ulp(x) of float64 for an exact positive arb x of the normal range: 2^(e − 52) where 2^e ≤ x < 2^(e+1)."""
    mantissa, exponent = magnitude.man_exp()
    return arb((1, int(exponent) + int(mantissa).bit_length() - 53))


def half_a_unit(magnitude: arb, inherited: arb) -> arb:
    """Return an upper bound of what rounding adds where |exact| ≤ magnitude and |unrounded − exact| ≤ inherited.

    Half an ulp of the largest binade that `exact` reaches, its upper end 2^e included (2^e needs no rounding). If
    what is inherited, at most an ulp there, lifts a value over 2^e, it is rounded back to 2^e, toward the exact one.
    """
    below = (magnitude * (1 - TINY)).lower()
    unit = unit_in_the_last_place(below)
    if not inherited <= unit:
        unit = unit_in_the_last_place((magnitude + inherited).upper())
    return unit / 2 + magnitude * TINY


def _is_power_of_two(value):
    return value.is_exact() and not value.is_zero() and abs(int(value.man_exp()[0])) == 1


class Rounded:
    """`exact`: a ball around what exact arithmetic gives; `error`: an upper bound of |computed − exact|."""

    __slots__ = ("error", "exact", "inherited", "largest", "least", "rounds")

    def __init__(
        self, exact: arb | float, error: arb = ZERO, rounds: bool = False, ends: tuple[arb, arb] | None = None
    ):
        """error: what is inherited; rounds: whether half a unit is added to it; ends: of `exact`, if not the ball's.

        A ball's radius has 30 bits, so that its ends may lie beyond the power of two at which a range ends.
        """
        self.exact, self.inherited, self.rounds = arb(exact), arb(error).upper(), rounds
        if ends:
            low, high = map(arb, ends)
            self.largest = max(low.abs_upper(), high.abs_upper())
            self.least = ZERO if self.exact.contains(0) else min(low.abs_lower(), high.abs_lower())
        else:
            self.largest, self.least = self.exact.abs_upper(), self.exact.abs_lower()
        self.error = self.inherited
        if rounds and not self.largest.is_zero():
            self.error = (self.inherited + half_a_unit(self.largest, self.inherited)).upper()

    def known_as(self, low: arb, high: arb, apart: arb = ZERO) -> "Rounded":
        """Return the number as an approximation of one in [low, high], from which exact arithmetic is `apart`."""
        return Rounded(between(low, high), self.inherited + apart, self.rounds, ends=(low, high))

    def ulps(self) -> arb:
        """Return the error in ulps of the float64 nearest to the exact number: below 2^e and next to it, of 2^e."""
        nearest = self.least * (1 + arb((1, -54)) * (1 - arb((1, -30))))
        return (self.error / unit_in_the_last_place(nearest.lower())).upper()

    def computed(self) -> arb:
        """Return a ball around the float64 number."""
        return self.exact + arb(0, self.error)

    def __add__(self, other):
        other = _rounded(other)
        exact, inherited = self.exact + other.exact, self.error + other.error
        plain = _cancels(self, other) or self.is_zero() or other.is_zero()
        return Rounded(exact, inherited, rounds=not plain)

    def __mul__(self, other):
        other = _rounded(other)
        inherited = self.exact.abs_upper() * other.error + (other.exact.abs_upper() + other.error) * self.error
        plain = any(n.is_zero() or (n.error.is_zero() and _is_power_of_two(n.exact)) for n in (self, other))
        return Rounded(self.exact * other.exact, inherited, rounds=not plain)

    def __truediv__(self, other):
        other = _rounded(other)
        exact, least = self.exact / other.exact, (other.exact.abs_lower() - other.error).lower()
        if not least > 0:
            raise Undecided("a division by what may be zero")
        return Rounded(exact, (self.error + exact.abs_upper() * other.error) / least, rounds=True)

    def __neg__(self):
        return Rounded(-self.exact, self.error)

    def __sub__(self, other):
        return self + -_rounded(other)

    def __rsub__(self, other):
        return -self + other

    __radd__, __rmul__ = __add__, __mul__

    def is_zero(self) -> bool:
        """Return whether the float64 number is certainly 0."""
        return self.exact.is_zero() and self.error.is_zero()

    def __gt__(self, other):
        mine, others = self.computed(), _rounded(other).computed()
        if mine > others:
            return True
        if mine <= others:
            return False
        raise Undecided("a comparison")


def _rounded(value):
    return value if isinstance(value, Rounded) else Rounded(value)


def _cancels(a, b):
    """Return whether a + b is exact by Sterbenz's lemma: opposite signs, and neither more than twice the other."""
    first, second = a.computed(), -b.computed()
    if not (first > 0 and second > 0):
        first, second = -first, -second
    return first > 0 and second > 0 and first <= 2 * second and second <= 2 * first


ROUNDED = ANY_NUMBERS | {"rational": lambda p, q: p / q}
"""What the text calls: constants that float64 holds, and nothing but arithmetic."""


def run(code: Iterable[tuple[str, CodeType]], values: dict, known: Mapping[str, tuple] | None = None) -> dict:
    """Run the lines on {name: Rounded}, and return it with theirs; `known` has what `known_as` is told, by name."""
    for name, line in code:
        value = _rounded(eval(line, {**ROUNDED, "value": values}))
        values[name] = value.known_as(*known[name]) if known and name in known else value
    return values
