"""Other ways and other people's libraries, on the same expression of the height field, in NumPy or their own arrays."""

import importlib

import mpmath
import numpy as np
from sympy import lambdify

from proofs.formulas.half_turns import ordinary
from proofs.formulas.symbols import k_u, k_v, u, v
from verify.benchmark.methods.dual import Dual, dual_gradient


def _with_waves(expression, ku, kv):
    return ordinary(expression.subs({k_u: int(ku), k_v: int(kv)}))


def lambdified(field, ku, kv, modules="numpy"):
    """Return h as a function of u and v, printed for `modules` by SymPy."""
    return lambdify((u, v), _with_waves(field.expression, ku, kv), modules)


def sympy_numpy(field, ku, kv, _):
    """SymPy's derivative, printed for NumPy."""
    return lambdify((u, v), tuple(_with_waves(d, ku, kv) for d in field.gradient()), "numpy", cse=True)


def complex_step(field, ku, kv, step):
    """The imaginary part of h beside the real axis, over the step: no difference is taken (Squire and Trapp 1998)."""
    height = lambdified(field, ku, kv)
    return lambda a, b: (height(a + step * 1j, b).imag / step, height(a, b + step * 1j).imag / step)


def dual_numbers(field, ku, kv, _):
    """Dual numbers over NumPy arrays."""
    return dual_gradient(lambdified(field, ku, kv, [{"sin": Dual.sin, "pi": np.pi}]))


def in_mpmath(field, ku, kv, digits):
    """The exact expression in mpmath, point by point, at a number of digits; mpf results."""
    slopes = lambdify((u, v), tuple(_with_waves(d, ku, kv) for d in field.gradient()), "mpmath")

    def gradient(at_u, at_v):
        with mpmath.workdps(digits):
            found = [slopes(mpmath.mpf(float(a)), mpmath.mpf(float(b))) for a, b in zip(at_u, at_v, strict=True)]
        return tuple(np.array(column, dtype=object) for column in zip(*found, strict=True))

    return gradient


def autograd(field, ku, kv, _):
    """autograd: reverse mode on its own NumPy."""
    import autograd.numpy
    from autograd import elementwise_grad

    height = lambdified(field, ku, kv, [autograd.numpy])
    along_u, along_v = elementwise_grad(height, 0), elementwise_grad(height, 1)
    return lambda a, b: (along_u(a, b), along_v(a, b))


def jax(field, ku, kv, _):
    """JAX: grad, vmap, jit, float64."""
    import jax

    jax.config.update("jax_enable_x64", True)
    compiled = jax.jit(jax.vmap(jax.grad(lambdified(field, ku, kv, "jax"), (0, 1))))
    return lambda a, b: tuple(np.asarray(part) for part in compiled(a, b))


def scipy_differentiate(field, ku, kv, order):
    """scipy.differentiate.derivative: adaptive central differences of an order."""
    from scipy.differentiate import derivative

    height = lambdified(field, ku, kv)
    return lambda a, b: (
        derivative(height, a, args=(b,), order=order).df,
        derivative(lambda second, first: height(first, second), b, args=(a,), order=order).df,
    )


def numdifftools(field, ku, kv, order):
    """numdifftools.Derivative: extrapolated central differences of an order."""
    from numdifftools import Derivative

    height = lambdified(field, ku, kv)
    return lambda a, b: (
        Derivative(lambda at: height(at, b), order=order)(a),
        Derivative(lambda at: height(a, at), order=order)(b),
    )


def installed(module):
    """Return whether a library can be imported."""
    return importlib.util.find_spec(module) is not None
