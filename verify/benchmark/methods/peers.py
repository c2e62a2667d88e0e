"""Other ways and other people's libraries, on the expression of one height field, in NumPy or their own arrays.

Each is given the value of its parameter, if it has one.
"""

from collections.abc import Callable

import mpmath
import numpy as np
from numpy.typing import ArrayLike
from sympy import lambdify

from proofs.formulas.half_turns import ordinary
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.symbols import k_u, k_v, u, v

FIELD, KU, KV = HEIGHT_FIELDS["sine"], 8.0, 4.0
EXPRESSION = ordinary(FIELD.expression.subs({k_u: int(KU), k_v: int(KV)}))
SLOPES = EXPRESSION.diff(u), EXPRESSION.diff(v)


class Dual:
    """A dual number a + b du + c dv over NumPy arrays: forward-mode automatic differentiation of products and sines."""

    def __init__(self, value: ArrayLike, by_u: ArrayLike = 0.0, by_v: ArrayLike = 0.0):
        self.value, self.by_u, self.by_v = value, by_u, by_v

    def __mul__(self, other):
        if not isinstance(other, Dual):
            return Dual(self.value * other, self.by_u * other, self.by_v * other)
        return Dual(
            self.value * other.value,
            self.by_u * other.value + self.value * other.by_u,
            self.by_v * other.value + self.value * other.by_v,
        )

    __rmul__ = __mul__

    def sin(self) -> "Dual":
        """Return sin of it, by the chain rule."""
        slope = np.cos(self.value)
        return Dual(np.sin(self.value), slope * self.by_u, slope * self.by_v)


def _height(modules="numpy"):
    """Return the height as a function of u and v, printed for `modules` by SymPy."""
    return lambdify((u, v), EXPRESSION, modules)


def sympy_numpy(_: None) -> Callable:
    """SymPy's derivative, printed for NumPy."""
    return lambdify((u, v), SLOPES, "numpy", cse=True)


def complex_step(step: float) -> Callable:
    """The imaginary part of h beside the real axis, over the step: no difference is taken (Squire and Trapp 1998)."""
    height = _height()
    return lambda a, b: (height(a + step * 1j, b).imag / step, height(a, b + step * 1j).imag / step)


def dual_numbers(_: None) -> Callable:
    """Dual numbers over NumPy arrays."""
    height = _height([{"sin": Dual.sin, "pi": np.pi}])

    def gradient(at_u, at_v):
        result = height(Dual(at_u, 1.0, 0.0), Dual(at_v, 0.0, 1.0))
        return result.by_u, result.by_v

    return gradient


def in_mpmath(digits: int) -> Callable:
    """The exact expression in mpmath, point by point, at a number of digits; mpf results."""
    slopes = lambdify((u, v), SLOPES, "mpmath")

    def gradient(at_u, at_v):
        with mpmath.workdps(digits):
            found = [slopes(mpmath.mpf(float(a)), mpmath.mpf(float(b))) for a, b in zip(at_u, at_v, strict=True)]
        return tuple(np.array(column, dtype=object) for column in zip(*found, strict=True))

    return gradient


def autograd(_: None) -> Callable:
    """autograd: reverse mode on its own NumPy."""
    import autograd.numpy
    from autograd import elementwise_grad

    along_u, along_v = (elementwise_grad(_height([autograd.numpy]), which) for which in (0, 1))
    return lambda a, b: (along_u(a, b), along_v(a, b))


def jax(_: None) -> Callable:
    """JAX: grad, vmap, jit, float64."""
    import jax

    jax.config.update("jax_enable_x64", True)
    compiled = jax.jit(jax.vmap(jax.grad(_height("jax"), (0, 1))))
    return lambda a, b: tuple(np.asarray(part) for part in compiled(a, b))


def scipy_differentiate(order: int) -> Callable:
    """scipy.differentiate.derivative: adaptive central differences of an order."""
    from scipy.differentiate import derivative

    height = _height()
    return lambda a, b: (
        derivative(height, a, args=(b,), order=order).df,
        derivative(lambda second, first: height(first, second), b, args=(a,), order=order).df,
    )


def numdifftools(order: int) -> Callable:
    """numdifftools.Derivative: extrapolated central differences of an order."""
    from numdifftools import Derivative

    height = _height()
    return lambda a, b: (
        Derivative(lambda at: height(at, b), order=order)(a),
        Derivative(lambda at: height(a, at), order=order)(b),
    )
