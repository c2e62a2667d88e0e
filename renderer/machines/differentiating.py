"""Numbers with slopes, of a machine around another one: a number of the inner machine, and its slopes by a scene's.

The machine is `renderer.machines.differentiating_machine`.

The inner machine's values stay as they are, to the last bit. It may be the enclosing machine: then each slope has a
bound. A slope that is the float 0.0 is 0 wherever the number is, and costs nothing; a number without slopes has none.

Where a selection jumps, the slope is that of the selected side. With bounds, the slopes of both sides lie within the
bound where the mask is open, and at a tie: where the compared numbers are exactly equal, and their slopes are not.
"""

import math
import operator
import sys
from collections.abc import Callable
from itertools import chain, repeat, zip_longest
from typing import Any

from renderer import kernels, operations
from renderer.machines import enclosing
from renderer.machines.bounded import is_zero, plus, times
from renderer.machines.enclosing import Enclosed, either, enclosed
from renderer.operations import pi, where as inner_where


def _sum(*slopes):
    return tuple(plus(*each) for each in zip_longest(*slopes, fillvalue=0.0))


def _scaled(size, slopes):
    return tuple(times(size, slope) for slope in slopes)


def _joined(join):
    """Return the method by which two conditions become one."""
    return lambda self, other: Mask(
        join(self.inner, other.inner), tuple(either(*each) for each in zip_longest(self.ties, other.ties))
    )


class Mask:
    """A condition of numbers: the inner machine's, and for each slope a mask of where there is a tie, or None."""

    def __init__(self, inner: Any, ties: tuple = ()):
        self.inner, self.ties = inner, ties

    __and__ = _joined(operator.and_)
    __or__ = _joined(operator.or_)

    def __invert__(self):
        return Mask(~self.inner, self.ties)

    def select(self, slope: Any, other: Any, tie: Any) -> Any:
        """Return a slope of one of two numbers; at a tie within the bounds of both."""
        if is_zero(slope) and is_zero(other):
            return 0.0
        mask = self.inner if tie is None else enclosing.Mask(self.inner.holds, either(self.inner.open, tie))
        return inner_where(mask, slope, other)


def _ties(a, b):
    """Return for each slope where two numbers tie: they are exactly equal, and the slope is not. Without bounds ()."""
    if not any(isinstance(number.value, Enclosed) for number in (a, b)):
        return ()
    equal = enclosed(a.value).value == enclosed(b.value).value
    apart = [plus(abs(slope.value), slope.error) for slope in map(enclosed, (a - b).slopes)]
    return tuple((equal if size else None) if isinstance(size, float) else equal & ~(size == 0.0) for size in apart)


def _comparison(compare):
    """Return the method by which two Sloped are compared: a Mask."""

    def compared(self, other):
        if self is other:  # x = x, which asks for NaN
            return Mask(compare(self.value, self.value))
        other = sloped(other)
        return Mask(compare(self.value, other.value), _ties(self, other))

    return compared


class Sloped:
    """A number of the inner machine, and its slopes."""

    __hash__ = None  # type: ignore[assignment]

    def __init__(self, value: Any, slopes: tuple = ()):
        self.value, self.slopes = value, () if all(map(is_zero, slopes)) else slopes

    @classmethod
    def of(cls, number: Any) -> "Sloped":
        """Return a number as Sloped: a constant, unless it is one already."""
        return number if isinstance(number, Sloped) else cls(number)

    def __add__(self, other):
        other = sloped(other)
        return Sloped(self.value + other.value, _sum(self.slopes, other.slopes))

    def __neg__(self):
        return Sloped(-self.value, _scaled(-1.0, self.slopes))

    def __sub__(self, other):
        return self + -sloped(other)

    def __rsub__(self, other):
        return sloped(other) - self

    def product_slopes(self, other: "Sloped") -> tuple:
        """Return the slopes of a product."""
        return _sum(_scaled(other.value, self.slopes), _scaled(self.value, other.slopes))

    def __mul__(self, other):
        other = sloped(other)
        return Sloped(self.value * other.value, self.product_slopes(other))

    def __truediv__(self, other):
        other = sloped(other)
        quotient = self.value / other.value
        slopes = _sum(self.slopes, _scaled(-quotient, other.slopes))
        return Sloped(quotient, slopes and _scaled(1.0 / other.value, slopes))

    def __rtruediv__(self, other):
        return sloped(other) / self

    def __abs__(self):
        return Sloped(abs(self.value), self.slopes and where(self < 0.0, -self, self).slopes)

    __radd__, __rmul__ = __add__, __mul__
    __lt__ = _comparison(operator.lt)
    __le__ = _comparison(operator.le)
    __gt__ = _comparison(operator.gt)
    __ge__ = _comparison(operator.ge)
    __eq__ = _comparison(operator.eq)
    __ne__ = _comparison(operator.ne)


sloped = Sloped.of


def where(mask: Mask, value: Any, otherwise: Any) -> Sloped:
    """Return the selected side, with its slopes."""
    value, otherwise = sloped(value), sloped(otherwise)
    sides = zip_longest(value.slopes, otherwise.slopes, fillvalue=0.0)
    slopes = (mask.select(*each, tie) for each, tie in zip(sides, chain(mask.ties, repeat(None)), strict=False))
    return Sloped(inner_where(mask.inner, value.value, otherwise.value), tuple(slopes))


def floor(a: Sloped) -> Sloped:
    """Return ⌊a⌋, whose slope is 0 except at its jumps."""
    return Sloped(operations.floor(a.value))


def rint(a: Sloped) -> Sloped:
    """Return the whole number nearest to a, whose slope is 0 except at its jumps."""
    return Sloped(operations.rint(a.value))


def sign(a: Any) -> Sloped:
    """Return −1, 0 or 1, with slope 0; with bounds, the slope's bound is infinite where a crosses an exact 0."""
    a = sloped(a)
    jumps = (0.0 if tie is None else Enclosed(0.0, inner_where(tie, math.inf, 0.0)) for tie in _ties(a, Sloped(0.0)))
    return Sloped(operations.sign(a.value), tuple(jumps))


def two_product(a: Any, b: Any) -> tuple[Sloped, Sloped]:
    """Return a product in two parts, value and rounding error; the first has the slopes."""
    a, b = sloped(a), sloped(b)
    product, rest = kernels.two_product(a.value, b.value)
    return Sloped(product, a.product_slopes(b)), Sloped(rest)


def add_half_turns(a: Any, b: Any) -> tuple[Sloped, Sloped]:
    """Return a sum of half-turns in two parts, value and rounding error; the first has the slopes."""
    a, b = sloped(a), sloped(b)
    total, lost = operations.add_half_turns(a.value, b.value)
    return Sloped(total, _sum(a.slopes, b.slopes)), Sloped(lost)


def _function(kernel: Callable, slope: Callable) -> Callable[..., Sloped]:
    """Return a function of a number that may come in two parts.

    slope: (the function's value, the parts' values) → its derivative.
    """

    def function(number: Any, *rest: Any) -> Sloped:
        parts = [part.value for part in map(sloped, (number, *rest))]
        result, slopes = kernel(*parts), sloped(number).slopes
        return Sloped(result, slopes and _scaled(slope(result, *parts), slopes))

    return function


# At 0 a root's slope is taken for 0, as is an angle's at the pole: a NaN would spoil every sum over a picture.
sqrt = _function(operations.sqrt, lambda root, _: inner_where(root > 0.0, 0.5 / root, 0.0))
exp = _function(kernels.exp, lambda result, _: result)
log = _function(kernels.log, lambda _, a: 1.0 / a)
sinpi = _function(kernels.sinpi, lambda _, *parts: pi * kernels.cospi(*parts))
cospi = _function(kernels.cospi, lambda _, *parts: -pi * kernels.sinpi(*parts))


def atan2pi(ordinate: Any, abscissa: Any) -> Sloped:
    """Return atan2(y, x)/π."""
    y, x = sloped(ordinate), sloped(abscissa)
    slopes, square = (
        _sum(_scaled(x.value, y.slopes), _scaled(-y.value, x.slopes)),
        x.value * x.value + y.value * y.value,
    )
    inverse = slopes and inner_where(square > 0.0, 1.0 / (pi * square), 0.0)
    return Sloped(kernels.atan2pi(y.value, x.value), _scaled(inverse, slopes))


def power(number: Any, exponent: Any) -> Sloped:
    """Return a^p, whose slope where a is not positive is 0."""
    number, exponent = sloped(number), sloped(exponent)
    a, p = number.value, exponent.value
    result = kernels.power(a, p)
    slopes = number.slopes and _scaled(inner_where(a > 0.0, p * result / a, 0.0), number.slopes)
    return of_whole_power(Sloped(result, slopes), number, exponent)


def of_whole_power(result: Sloped, base: Any, exponent: Any) -> Sloped:
    """Return a power that repeated squaring gave, with its slope by the exponent added."""
    exponent, a = sloped(exponent), sloped(base).value
    moved = exponent.slopes and inner_where(a > 0.0, result.value * kernels.log(a), 0.0)
    return Sloped(result.value, _sum(result.slopes, _scaled(moved, exponent.slopes)))


Mask.machine = Sloped.machine = sys.modules[__name__]  # type: ignore[attr-defined]  # `renderer.operations` asks it
