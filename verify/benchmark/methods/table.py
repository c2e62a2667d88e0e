"""Every way to take the gradient of the sine field, each with its parameter: the rows of the work-precision diagram.

A method's function takes the points' (u, v), or for the algebraic form cos θ, sin θ, cos φ, sin φ, and returns arrays.
Other people's libraries get the expression, and the value of the parameter if there is one.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, partial
from importlib.util import find_spec

import mpmath
import numpy as np
from numpy.typing import ArrayLike
from sympy import lambdify

from proofs.engine.half_turns import ordinary
from proofs.engine.program import Program
from proofs.formulas.finite_difference import central, central4
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from proofs.formulas.symbols import k_u, k_v, u, v
from renderer.generate.kernels import function_of
from renderer.machines.native import over_points
from verify.evaluate.programs import algebraic_gradient, richardson

FIELD, KU, KV = HEIGHT_FIELDS["sine"], 8.0, 4.0
WAVES = {"k_u": KU, "k_v": KV}
EXPRESSION = ordinary(FIELD.expression.subs({k_u: int(KU), k_v: int(KV)}))
SLOPES = EXPRESSION.diff(u), EXPRESSION.diff(v)
STEPS = tuple(10.0 ** (-n / 4) for n in range(4, 45))
SINGLE, FULL = (None,), 2**16


@dataclass(frozen=True)
class Method:
    """One way: make(value of its parameter) → function of the points.

    ours: it is what this project draws with. angles: it takes the angles. timed_once: the parameter does not change
    what is computed, only with which number. points: how many to time it on. module: a library that it needs.
    """

    name: str
    make: Callable
    parameter: str = ""
    values: tuple = SINGLE
    ours: bool = False
    angles: bool = False
    timed_once: bool = True
    points: int = FULL
    module: str | None = None

    @property
    def available(self) -> bool:
        """True where its library is installed."""
        return self.module is None or find_spec(self.module) is not None


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


def complex_step(step: float) -> Callable:
    """Return the imaginary part of h beside the real axis, over the step: no difference (Squire and Trapp 1998)."""
    height = _height()
    return lambda a, b: (height(a + step * 1j, b).imag / step, height(a, b + step * 1j).imag / step)


def dual_numbers(_: None) -> Callable:
    """Return the gradient by dual numbers over NumPy arrays."""
    height = _height([{"sin": Dual.sin, "pi": np.pi}])

    def gradient(at_u, at_v):
        result = height(Dual(at_u, 1.0, 0.0), Dual(at_v, 0.0, 1.0))
        return result.by_u, result.by_v

    return gradient


def in_mpmath(digits: int) -> Callable:
    """Return the exact expression in mpmath, point by point, at a number of digits; mpf results."""
    slopes = lambdify((u, v), SLOPES, "mpmath")

    def gradient(at_u, at_v):
        with mpmath.workdps(digits):
            pairs = [slopes(mpmath.mpf(float(a)), mpmath.mpf(float(b))) for a, b in zip(at_u, at_v, strict=True)]
        return tuple(np.array(column, dtype=object) for column in zip(*pairs, strict=True))

    return gradient


def jax(_: None) -> Callable:
    """Return the gradient by JAX: grad, vmap, jit, float64."""
    import jax

    jax.config.update("jax_enable_x64", True)
    compiled = jax.jit(jax.vmap(jax.grad(_height("jax"), (0, 1))))
    return lambda a, b: tuple(np.asarray(part) for part in compiled(a, b))


@cache
def compiled(program: Program) -> Callable:
    """Return a program as a compiled loop over points: a function of arrays, or numbers, for its inputs in order.

    The wave numbers are constants of its code; no fast-math.
    """
    inputs = sorted(program.inputs, key=lambda s: s.name in WAVES)  # those that only a name gives come last
    ordered = Program(program.name, inputs, program.definitions, program.outputs)
    waves = {s.name: WAVES[s.name] for s in inputs if s.name in WAVES}
    return partial(over_points, partial(function_of(ordered), **waves))


def _difference(program):
    """Return eps → the difference: all steps run the same code."""

    def make(eps):
        loop = compiled(program(FIELD))  # here, or a call would be timed with the program's making
        return lambda u, v: loop(u, v, eps)

    return make


def _compiled(program):
    return lambda _: compiled(program)


ALGEBRAIC = algebraic_gradient(FIELD, KU, KV)
METHODS = (
    Method("central", _difference(central), "ε", STEPS),
    Method("central, 4th order", _difference(central4), "ε", STEPS),
    Method("Richardson, 8th order", _difference(richardson), "ε", STEPS),
    Method("exact, reduced argument", _compiled(gradient(FIELD)), ours=True),
    Method("exact, algebraic", _compiled(ALGEBRAIC), ours=True, angles=True),
    Method("SymPy, NumPy", lambda _: lambdify((u, v), SLOPES, "numpy", cse=True)),
    Method("complex step", complex_step, "step", tuple(10.0**-n for n in range(1, 21))),
    Method("dual numbers", dual_numbers),
    Method("JAX", jax, module="jax"),
    Method("mpmath", in_mpmath, "digits", (5, 10, 15, 20, 30, 50), timed_once=False, points=100),
)  # fmt: skip


CLEAR = (0.35, 0.65)
"""The range of u and v of the sample: no step leaves the chart from there."""


def sample(points: int, seed: int = 3) -> tuple[np.ndarray, np.ndarray]:
    """Return (u, v) at random, in CLEAR."""
    return tuple(np.random.default_rng(seed).uniform(*CLEAR, (2, points)))
