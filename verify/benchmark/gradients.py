"""The gradient alone, at chart points of the sine field, on one thread: ours, finite differences, and other libraries.

Every one starts from the same expression of `proofs.formulas.height_fields`. A library that is not installed is left
out.
"""

from functools import cache

import numpy as np
from sympy import lambdify

from proofs.formulas.half_turns import ordinary
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from proofs.formulas.symbols import k_u, k_v, u, v
from renderer import Scene, central, central4, exact, forward, gradient_at
from verify.benchmark.plan import Case
from verify.evaluate import Reference

SCENE = Scene(field="sine")
POINTS = 10**6
CHECKED = 4096  # of the points, at which the error is taken
DECADES = [10.0**-n for n in range(1, 11)]
FIELD = HEIGHT_FIELDS[SCENE.field]
WAVES = {k_u: int(SCENE.ku), k_v: int(SCENE.kv)}
HEIGHT = ordinary(FIELD.expression.subs(WAVES))
GRADIENT = tuple(ordinary(d.subs(WAVES)) for d in FIELD.gradient())


def ours(method):
    """Return the renderer's gradient by a method."""
    return lambda at_u, at_v: gradient_at(SCENE, at_u, at_v, method)


def sympy_lambdify():
    """Return SymPy's derivative as NumPy code."""
    return lambdify((u, v), GRADIENT, "numpy", cse=True)


def complex_step():
    """Return the imaginary part of h beside the real axis, in NumPy: no difference is taken."""
    height, step = lambdify((u, v), HEIGHT, "numpy"), 1e-100
    return lambda at_u, at_v: (height(at_u + step * 1j, at_v).imag / step, height(at_u, at_v + step * 1j).imag / step)


def autograd():
    """Return autograd's reverse mode on its NumPy."""
    import autograd.numpy
    from autograd import elementwise_grad

    height = lambdify((u, v), HEIGHT, [autograd.numpy])
    along_u, along_v = elementwise_grad(height, 0), elementwise_grad(height, 1)
    return lambda at_u, at_v: (along_u(at_u, at_v), along_v(at_u, at_v))


def jax():
    """Return JAX's grad, vectorised and compiled, in float64."""
    import jax

    jax.config.update("jax_enable_x64", True)
    compiled = jax.jit(jax.vmap(jax.grad(lambdify((u, v), HEIGHT, "jax"), (0, 1))))
    return lambda at_u, at_v: tuple(np.asarray(part) for part in compiled(at_u, at_v))


def scipy_differentiate():
    """Return SciPy's adaptive differences, one coordinate after the other."""
    from scipy.differentiate import derivative

    height = lambdify((u, v), HEIGHT, "numpy")
    return lambda at_u, at_v: (
        derivative(height, at_u, args=(at_v,)).df,
        derivative(lambda b, a: height(a, b), at_v, args=(at_u,)).df,
    )


def numdifftools():
    """Return numdifftools' extrapolated differences, one coordinate after the other."""
    from numdifftools import Derivative

    height = lambdify((u, v), HEIGHT, "numpy")
    return lambda at_u, at_v: (Derivative(lambda a: height(a, at_v))(at_u), Derivative(lambda b: height(at_u, b))(at_v))


@cache
def sample():
    """Return (u, v) of POINTS random chart points."""
    return tuple(np.random.default_rng(1).uniform(0, 1, (2, POINTS)))


@cache
def reference():
    """Return (h_u, h_v) at the first CHECKED points from the exact expression at 50 digits, rounded to float64."""
    exactly = Reference(gradient(FIELD))
    lines = [exactly({"u": a, "v": b, "k_u": SCENE.ku, "k_v": SCENE.kv}) for a, b in zip(*checked(), strict=True)]
    return tuple(np.array([float(line[name]) for line in lines]) for name in ("h_u", "h_v"))


def checked():
    """Return the points at which the error is taken."""
    return tuple(coordinate[:CHECKED] for coordinate in sample())


def largest_error(function):
    """Return the largest error of h_u or h_v over the checked points."""
    return max(
        float(np.abs(found - right).max()) for found, right in zip(function(*checked()), reference(), strict=True)
    )


def best_step(method):
    """Return the ε among the decades 1e-1 … 1e-10 with which the difference errs least."""
    return min(DECADES, key=lambda eps: largest_error(ours(method(eps))))


OURS = {"exact": lambda: ours(exact())} | {
    method.__name__: lambda method=method: ours(method(best_step(method))) for method in (forward, central, central4)
}
LIBRARIES = {f.__name__: f for f in (sympy_lambdify, complex_step, autograd, jax, scipy_differentiate, numdifftools)}
DISTRIBUTIONS = {"sympy_lambdify": "sympy", "scipy_differentiate": "scipy"}  # where the name is another
FEWER = {"scipy_differentiate": 10**4, "numdifftools": 10**4}  # points, for those that take microseconds each


def available():
    """Return ({name: gradient function}, [names of libraries that are not installed])."""
    functions, absent = {}, []
    for name, make in (OURS | LIBRARIES).items():
        try:
            functions[name] = make()
        except ImportError:
            absent.append(name)
    return functions, absent


def gradient_case(name, function):
    """Return the case of one method on its points."""
    points = FEWER.get(name, POINTS)

    def prepare():
        at_u, at_v = (coordinate[:points] for coordinate in sample())
        return lambda: function(at_u, at_v)

    return Case(name, prepare, 3)


def gradient_numbers(times, functions):
    """Return the nanoseconds a point and the largest error of each method, and the ratio of central to exact."""
    numbers = {"points": POINTS, "checked": CHECKED}
    for name, seconds in times.items():
        numbers |= {
            f"{name}_ns": 1e9 * seconds / FEWER.get(name, POINTS),
            f"{name}_error": largest_error(functions[name]),
        }
    numbers |= {f"{m.__name__}_eps": best_step(m) for m in (forward, central, central4) if m.__name__ in times}
    if {"central", "exact"} <= times.keys():
        numbers["central_to_exact"] = numbers["central_ns"] / numbers["exact_ns"]
    return numbers
