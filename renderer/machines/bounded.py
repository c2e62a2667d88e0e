"""Propagation of error bounds through sums, products and quotients.

Each subclass of Bounded says how much rounding adds. The error of an exact number is the float 0.0, and costs nothing.
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
    """Return a size times a bound, 0.0 where that is."""
    return 0.0 if is_zero(bound) else size * bound


class Bounded:
    """A value, and as `error` a bound on its distance from the exact one, in the unit of its kind.

    A kind of them has `of`, which makes one of any number; `size`, which no exact number exceeds; `inverse`, which no
    inverse of one exceeds; `size_of_quotient`, the same of a quotient as computed; and `rounded`, which is given a
    result's value, how far it is moved, and the value of `lost_in_sum`, `lost_in_product` or `lost_in_quotient` for its
    rounding.
    """

    __hash__ = None  # type: ignore[assignment]

    def __init__(self, value: Any, error: Any = 0.0):
        self.value, self.error = value, error

    def __add__(self, other):
        other = self.of(other)
        total = self.value + other.value
        return self.rounded(total, plus(self.error, other.error), self.lost_in_sum(other, total))

    def __sub__(self, other):
        return self + -self.of(other)

    def __rsub__(self, other):
        return self.of(other) - self

    def product_moves(self, other: Any) -> Any:
        """Return how far the product of two Bounded is moved: |ab − a'b'| ≤ |a| |b − b'| + |b'| |a − a'|."""
        return plus(times(abs(self.value), other.error), times(other.size, self.error))

    def __mul__(self, other):
        other = self.of(other)
        product = self.value * other.value
        return self.rounded(product, self.product_moves(other), self.lost_in_product(other, product))

    def __truediv__(self, other):
        """Return the quotient: |a/b − a'/b'| ≤ (|a − a'| + |a/b| |b − b'|)/|b'|."""
        other = self.of(other)
        quotient = self.value / other.value
        size = self.size_of_quotient(quotient)
        moved = plus(self.error, times(size, other.error))
        moved = moved if is_zero(moved) else moved * other.inverse()
        return self.rounded(quotient, moved, self.lost_in_quotient(size))

    def __rtruediv__(self, other):
        return self.of(other) / self

    __radd__, __rmul__ = __add__, __mul__
