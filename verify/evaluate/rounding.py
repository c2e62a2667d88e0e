"""Running error analysis: a float64 result as the set of values that it should have, and how far off it can be.

A `Rounded` goes through the printed text of a straight-line program in place of a float. Each operation adds what it
inherits and half a unit in the last place of the largest result that it can have: round to nearest, no underflow.
"""

from collections.abc import Iterable, Mapping
from types import CodeType
from typing import Any, ClassVar

from flint import arb

from renderer.machines.bounded import Bounded
from verify.evaluate import ANY_NUMBERS

ZERO, TINY = arb(0), arb(2) ** -100


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


class Running(Bounded):
    """A number of a running error analysis; `error`: at least how far the computed number is from the exact one."""

    names: ClassVar = ANY_NUMBERS | {"rational": lambda p, q: p / q}
    """What the text calls: constants that float64 holds, and nothing but arithmetic."""

    @classmethod
    def of(cls, number: Any) -> Any:
        """Return a number as one of this kind."""
        return number if isinstance(number, cls) else cls(number)

    @property
    def size(self) -> Any:
        """How large the float64 number can be."""
        return abs(self.value) + self.error

    @staticmethod
    def size_of_quotient(quotient: Any) -> Any:
        """Return the size of a quotient."""
        return abs(quotient)

    def __neg__(self):
        return type(self)(-self.value, self.error)


class Rounded(Running):
    """`value`: a ball around what exact arithmetic gives; `error`: an upper bound of |computed − exact|."""

    def __init__(
        self, value: arb | float, moved: arb = ZERO, rounds: bool = False, ends: tuple[arb, arb] | None = None
    ):
        """moved: what is inherited; rounds: whether half a unit is added to it; ends: of `value`, if not the ball's.

        A ball's radius has 30 bits, so that its ends may lie beyond the power of two at which a range ends.
        """
        super().__init__(arb(value), arb(moved).upper())
        self.moved, self.rounds = self.error, rounds
        low, high = map(arb, ends or (value, value))
        self.largest = max(low.abs_upper(), high.abs_upper())
        self.smallest = ZERO if self.value.contains(0) else min(low.abs_lower(), high.abs_lower())
        if rounds and not self.largest.is_zero():
            self.error = (self.moved + half_a_unit(self.largest, self.moved)).upper()

    def known_as(self, low: arb, high: arb, apart: arb = ZERO) -> "Rounded":
        """Return the number as an approximation of one in [low, high], from which exact arithmetic is `apart`."""
        return Rounded(between(low, high), self.moved + apart, self.rounds, ends=(low, high))

    def ulps(self) -> arb:
        """Return the error in ulps of the float64 nearest to the exact number: below 2^e and next to it, of 2^e."""
        nearest = self.smallest * (1 + arb(2) ** -54 * (1 - arb(2) ** -30))
        return (self.error / unit_in_the_last_place(nearest.lower())).upper()

    def computed(self) -> arb:
        """Return a ball around the float64 number."""
        return self.value + arb(0, self.error)

    def rounded(self, value: arb, moved: arb, rounds: bool) -> "Rounded":
        """Return a result."""
        return Rounded(value, moved, rounds)

    def lost_in_sum(self, other: "Rounded", _: arb) -> bool:
        """Return whether a sum rounds."""
        return not (_cancels(self, other) or self.computed().is_zero() or other.computed().is_zero())

    def lost_in_product(self, other: "Rounded", _: arb) -> bool:
        """Return whether a product does: not by 0, nor by a power of two."""
        return not any(n.computed().is_exact() and abs(int(n.value.man_exp()[0])) <= 1 for n in (self, other))

    def lost_in_quotient(self, _: arb) -> bool:
        """Return whether a quotient does."""
        return True

    def inverse(self) -> arb:
        """Return how large the inverse of the float64 number can be. Raises Undecided where that may be 0."""
        least = self.computed().abs_lower()
        if not least > 0:
            raise Undecided("a division by what may be zero")
        return 1 / least

    def __gt__(self, other):
        mine, others = self.computed(), self.of(other).computed()
        if mine > others:
            return True
        if mine <= others:
            return False
        raise Undecided("a comparison")


def _cancels(a, b):
    """Return whether a + b is exact by Sterbenz's lemma: opposite signs, and neither more than twice the other."""
    first, second = a.computed(), -b.computed()
    if not (first > 0 and second > 0):
        first, second = -first, -second
    return first > 0 and second > 0 and first <= 2 * second and second <= 2 * first


def run(
    code: Iterable[tuple[str, CodeType]], values: dict, known: Mapping[str, tuple] | None = None, kind: Any = Rounded
) -> dict:
    """Run the lines on {name: number of a kind}, and return it with theirs.

    known: what `known_as` is told, by name.
    """
    for name, line in code:
        value = kind.of(eval(line, {**kind.names, "value": values}))
        values[name] = value.known_as(*known[name]) if known and name in known else value
    return values
