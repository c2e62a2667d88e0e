"""What a kernel may call: on NumPy's arrays and numbers at once, on a traced value (`renderer.machines`) instructions.

`abs` and the operators are Python's own. Nothing is from libm.
"""

import math
from typing import Any

import numpy as np

pi, inf, nan = math.pi, math.inf, math.nan
Number = Any  # a float64, an array of them, or a traced value
Mask = Any  # for which of them something holds


def _operation(name, on_arrays):
    """Return the function that asks the machine of the first traced argument, and NumPy where none is traced."""

    def operation(*arguments):
        for argument in arguments:
            if hasattr(argument, "machine"):
                return getattr(argument.machine, name)(*arguments)
        return on_arrays(*arguments)

    operation.__name__ = name
    return operation


BIASED = 2.0**52 + 1023  # n + BIASED ends, as a float64, in the bits that stand for the exponent of 2ⁿ
EXPONENT_AT = 52  # the bit at which the exponent begins; 11 bits


def _bits(number):
    return np.asarray(number, np.float64).view(np.int64)


def _binary_exponent(number):
    return (_bits(number) >> EXPONENT_AT & 2047) - 1023.0


def _power_of_two(whole):
    return (_bits(whole + BIASED) << EXPONENT_AT).view(np.float64)


sqrt = _operation("sqrt", np.sqrt)
floor = _operation("floor", np.floor)
rint = _operation("rint", np.rint)
where = _operation("where", np.where)
binary_exponent = _operation("binary_exponent", _binary_exponent)
power_of_two = _operation("power_of_two", _power_of_two)


def maximum(a: Number, b: Number) -> Number:
    """Return the larger of two numbers."""
    return where(b > a, b, a)


def minimum(a: Number, b: Number) -> Number:
    """Return the smaller of two numbers."""
    return where(b < a, b, a)


def sign(a: Number) -> Number:
    """Return −1, 0 or 1."""
    return where(a > 0.0, 1.0, where(a < 0.0, -1.0, 0.0))
