"""Functions that a kernel may call: they compute on NumPy's arrays and numbers, and emit code on traced values.

`abs` and the operators are Python's own. Nothing is from libm.
"""

import math
from collections.abc import Callable
from functools import wraps
from typing import Any

import numpy as np

inf, nan = math.inf, math.nan
UNIT = 2.0**-53  # the largest relative error of rounding to float64
Number = Any  # a float64, an array of them, or a traced value
Mask = Any  # for which of them something holds


class Constant(float):
    """The float64 nearest to a constant of a formula, which float64 does not hold; `error` bounds how far it is off."""

    error: float

    def __new__(cls, value: float, error: float | None = None) -> "Constant":
        constant = super().__new__(cls, value)
        constant.error = math.ulp(value) / 2 + math.ulp(0.0) if error is None else error
        return constant

    def __neg__(self):
        return Constant(-float(self), self.error)

    def __mul__(self, other):
        """Return the product with a literal or another constant, its error added; else that with a float."""
        if type(other) not in (float, Constant):
            return NotImplemented if hasattr(other, "machine") else float(self) * other
        product, off = Constant(float(self) * float(other)), getattr(other, "error", 0.0)
        moved = (abs(other) + off) * self.error + abs(self) * off
        return Constant(product, moved * (1 + 2**-50) + product.error)

    __rmul__ = __mul__


pi = Constant(math.pi)


def elementary(kernel: Callable) -> Any:
    """Return a function that calls the argument's machine where that has a method of the name, else `kernel`."""

    @wraps(kernel)
    def asked(*arguments):
        for argument in arguments:
            method = getattr(getattr(argument, "machine", None), kernel.__name__, None)
            if method:
                return method(*arguments)
        return kernel(*arguments)

    asked.kernel = kernel  # type: ignore[attr-defined]
    return asked


BIT_OPERATIONS = {"shl": np.left_shift, "lshr": np.right_shift, "and_": np.bitwise_and, "or_": np.bitwise_or}
BIASED = 2.0**52 + 1023  # n + BIASED ends, as a float64, in the bits that stand for the exponent of 2ⁿ

sqrt, floor, rint, where = map(elementary, (np.sqrt, np.floor, np.rint, np.where))  # type: ignore[arg-type]


@elementary
def bits(number: Number, operation: str, other: int) -> Number:
    """Return the float64 of an operation, as LLVM names it, on a float64's bits and a whole number."""
    integer = np.asarray(number, np.float64).view(np.uint64)
    return BIT_OPERATIONS[operation](integer, np.uint64(other)).view(np.float64)


def power_of_two(n: Number) -> Number:
    """Return 2ⁿ for a whole n from −1022 to 1023."""
    return bits(n + BIASED, "shl", 52)


def binary_exponent(number: Number) -> Number:
    """Return ⌊log₂|x|⌋ of a number of the normal range: its exponent's 11 bits become the last ones of 2^52."""
    return bits(bits(bits(number, "lshr", 52), "and_", 2047), "or_", 0x433 << 52) - BIASED


def maximum(a: Number, b: Number) -> Number:
    """Return the larger of two numbers."""
    return where(b > a, b, a)


def minimum(a: Number, b: Number) -> Number:
    """Return the smaller of two numbers."""
    return where(b < a, b, a)


@elementary
def add_half_turns(a: Number, b: Number) -> tuple[Number, Number]:
    """Return a sum less whole turns, rounded, and its rounding error (Knuth)."""
    a, b = (number - 2.0 * rint(0.5 * number) for number in (a, b))
    total = a + b
    part = total - a
    return total, (a - (total - part)) + (b - part)


def sum_of_half_turns(*parts: tuple[Number, Number]) -> tuple[Number, Number]:
    """Return such a sum of numbers in two parts each: only their small parts' sum is rounded."""
    (total, rest), *others = parts
    for number, small in others:
        total, lost = add_half_turns(total, number)
        rest = rest + small + lost
    return add_half_turns(total, rest)


@elementary
def sign(a: Number) -> Number:
    """Return −1, 0 or 1."""
    return where(a > 0.0, 1.0, where(a < 0.0, -1.0, 0.0))


@elementary
def of_whole_power(result: Number, base: Number, exponent: Number) -> Number:
    """Return base^exponent as repeated squaring gave it: a machine may add how it moves with the exponent."""
    return result
