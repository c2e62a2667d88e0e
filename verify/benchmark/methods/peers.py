"""Other ways and other people's libraries, on the same expression of the height field, in NumPy or their own arrays."""

from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np
from numpy.typing import ArrayLike
from sympy import Expr, lambdify

from proofs.formulas.symbols import u, v


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


def lambdified(h: Expr, modules: Any = "numpy") -> Callable:
    """Return h as a function of u and v, printed for `modules` by SymPy."""
    return lambdify((u, v), h, modules)


def sympy_numpy(h: Expr, _: None) -> Callable:
    """SymPy's derivative, printed for NumPy."""
    return lambdify((u, v), (h.diff(u), h.diff(v)), "numpy", cse=True)


def complex_step(h: Expr, step: float) -> Callable:
    """The imaginary part of h beside the real axis, over the step: no difference is taken (Squire and Trapp 1998)."""
    height = lambdified(h)
    return lambda a, b: (height(a + step * 1j, b).imag / step, height(a, b + step * 1j).imag / step)


def dual_numbers(h: Expr, _: None) -> Callable:
    """Dual numbers over NumPy arrays."""
    height = lambdified(h, [{"sin": Dual.sin, "pi": np.pi}])

    def gradient(at_u, at_v):
        result = height(Dual(at_u, 1.0, 0.0), Dual(at_v, 0.0, 1.0))
        return result.by_u, result.by_v

    return gradient


def in_mpmath(h: Expr, digits: int) -> Callable:
    """The exact expression in mpmath, point by point, at a number of digits; mpf results."""
    slopes = lambdify((u, v), (h.diff(u), h.diff(v)), "mpmath")

    def gradient(at_u, at_v):
        with mpmath.workdps(digits):
            found = [slopes(mpmath.mpf(float(a)), mpmath.mpf(float(b))) for a, b in zip(at_u, at_v, strict=True)]
        return tuple(np.array(column, dtype=object) for column in zip(*found, strict=True))

    return gradient


def autograd(h: Expr, _: None) -> Callable:
    """autograd: reverse mode on its own NumPy."""
    import autograd.numpy
    from autograd import elementwise_grad

    height = lambdified(h, [autograd.numpy])
    along_u, along_v = elementwise_grad(height, 0), elementwise_grad(height, 1)
    return lambda a, b: (along_u(a, b), along_v(a, b))


def jax(h: Expr, _: None) -> Callable:
    """JAX: grad, vmap, jit, float64."""
    import jax

    jax.config.update("jax_enable_x64", True)
    compiled = jax.jit(jax.vmap(jax.grad(lambdified(h, "jax"), (0, 1))))
    return lambda a, b: tuple(np.asarray(part) for part in compiled(a, b))


def scipy_differentiate(h: Expr, order: int) -> Callable:
    """scipy.differentiate.derivative: adaptive central differences of an order."""
    from scipy.differentiate import derivative

    height = lambdified(h)
    return lambda a, b: (
        derivative(height, a, args=(b,), order=order).df,
        derivative(lambda second, first: height(first, second), b, args=(a,), order=order).df,
    )


def numdifftools(h: Expr, order: int) -> Callable:
    """numdifftools.Derivative: extrapolated central differences of an order."""
    from numdifftools import Derivative

    height = lambdified(h)
    return lambda a, b: (
        Derivative(lambda at: height(at, b), order=order)(a),
        Derivative(lambda at: height(a, at), order=order)(b),
    )
