"""How bounds propagate: how far a sum, a product or a quotient is off, where what it is made of is off.

What rounding adds is for a kind of numbers to say. A bound that is the float 0.0 is of an exact number, and costs
nothing.
"""

from typing import Any


def is_zero(bound: Any) -> bool:
    """Return whether a bound is the float 0.0."""
    return type(bound) is float and bound == 0.0


def plus(*bounds: Any) -> Any:
    """Return a sum of bounds, of which those that are 0 are left out."""
    total: Any = 0.0
    for bound in bounds:
        total = bound if is_zero(total) else total if is_zero(bound) else total + bound
    return total


def times(size: Any, bound: Any) -> Any:
    """Return a bound times what it is of."""
    return 0.0 if is_zero(bound) else size * bound


class Bounded:
    """A value, and a bound on its distance from the exact one.

    A kind of them has `of`, which makes one of any number; `least`, below which no exact number's size can be;
    `rounded`, which is given a result's value, how far it is moved, and what `lost_in_sum`, `lost_in_product` or
    `lost_in_quotient` says of its rounding.
    """

    __hash__ = None  # type: ignore[assignment]

    def __init__(self, value: Any, bound: Any = 0.0):
        self.value, self.bound = value, bound

    def __neg__(self):
        return type(self)(-self.value, self.bound)

    def __add__(self, other):
        other = self.of(other)
        total = self.value + other.value
        return self.rounded(total, plus(self.bound, other.bound), self.lost_in_sum(other, total))

    def __sub__(self, other):
        return self + -self.of(other)

    def __rsub__(self, other):
        return self.of(other) - self

    def product_moves(self, other: Any) -> Any:
        """Return how far the product of two Bounded is moved, its second-order term included."""
        both = 0.0 if is_zero(self.bound) else times(self.bound, other.bound)
        return plus(times(abs(self.value), other.bound), times(abs(other.value), self.bound), both)

    def __mul__(self, other):
        other = self.of(other)
        product = self.value * other.value
        return self.rounded(product, self.product_moves(other), self.lost_in_product(other, product))

    def __truediv__(self, other):
        other = self.of(other)
        quotient = self.value / other.value
        moved = plus(self.bound, times(abs(quotient), other.bound))
        moved = moved if is_zero(moved) else moved / other.least()
        return self.rounded(quotient, moved, self.lost_in_quotient(quotient))

    def __rtruediv__(self, other):
        return self.of(other) / self

    __radd__, __rmul__ = __add__, __mul__
