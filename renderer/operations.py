"""What a kernel may call: on NumPy's arrays and numbers at once, on a traced value (`renderer.machines`) instructions.

`abs` and the operators are Python's own. Nothing is from libm but `power`, for a shininess that is not whole.
"""

import math
from typing import Any

import numpy as np

pi, inf = math.pi, math.inf
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


def _power(base, exponent):
    """By the C library's pow, an element at a time: NumPy's own may differ in the last bit."""
    return np.frompyfunc(math.pow, 2, 1)(base, exponent).astype(np.float64)


sqrt = _operation("sqrt", np.sqrt)
floor = _operation("floor", np.floor)
rint = _operation("rint", np.rint)
where = _operation("where", np.where)
power = _operation("power", _power)


def maximum(a: Number, b: Number) -> Number:
    """Return the larger of two numbers."""
    return where(b > a, b, a)


def minimum(a: Number, b: Number) -> Number:
    """Return the smaller of two numbers."""
    return where(b < a, b, a)


def sign(a: Number) -> Number:
    """Return −1, 0 or 1."""
    return where(a > 0.0, 1.0, where(a < 0.0, -1.0, 0.0))
