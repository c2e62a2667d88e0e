"""Every way to take the gradient of the sine field, each with its parameter: the rows of the work-precision diagram.

A method's function takes the points' (u, v), or for the algebraic form cos θ, sin θ, cos φ, sin φ, and returns arrays.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec

import numpy as np

from proofs.formulas.finite_difference import central, central4, forward
from proofs.formulas.height_fields import gradient
from verify.benchmark.methods import peers
from verify.benchmark.methods.compiled import compiled_loop
from verify.benchmark.methods.peers import FIELD, KU, KV
from verify.evaluate.programs import algebraic_gradient, central6, naive_gradient, richardson

WAVES = {"k_u": KU, "k_v": KV}
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
        """Whether its library is installed."""
        return self.module is None or find_spec(self.module) is not None


@cache
def _filled(count, value):
    return np.full(count, value)


def _difference(program):
    """Return eps → the difference: ε is read beside the points, so that all steps run the same code."""
    return lambda eps: lambda u, v: compiled_loop(program(FIELD), **WAVES)(u, v, _filled(len(u), eps))


def _compiled(program, kind=np.float64):
    return lambda _: compiled_loop(program, kind, **WAVES)


ALGEBRAIC = algebraic_gradient(FIELD, KU, KV)
METHODS = (
    Method("forward", _difference(forward), "ε", STEPS),
    Method("central", _difference(central), "ε", STEPS),
    Method("central, 4th order", _difference(central4), "ε", STEPS),
    Method("central, 6th order", _difference(central6), "ε", STEPS),
    Method("Richardson, 8th order", _difference(richardson), "ε", STEPS),
    Method("exact, naive argument", _compiled(naive_gradient(FIELD))),
    Method("exact, reduced argument", _compiled(gradient(FIELD)), ours=True),
    Method("exact, algebraic", _compiled(ALGEBRAIC), ours=True, angles=True),
    Method("exact, algebraic, float32", _compiled(ALGEBRAIC, np.float32), ours=True, angles=True),
    Method("SymPy, NumPy", peers.sympy_numpy),
    Method("complex step", peers.complex_step, "step", tuple(10.0**-n for n in range(1, 21))),
    Method("dual numbers", peers.dual_numbers),
    Method("autograd", peers.autograd, module="autograd"),
    Method("JAX", peers.jax, module="jax"),
    Method("scipy.differentiate", peers.scipy_differentiate, "order", (2, 4, 6, 8, 10, 12),
           timed_once=False, points=1000, module="scipy"),
    Method("numdifftools", peers.numdifftools, "order", (2, 4, 6, 8, 10),
           timed_once=False, points=1000, module="numdifftools"),
    Method("mpmath", peers.in_mpmath, "digits", (5, 10, 15, 20, 30, 50), timed_once=False, points=100),
)  # fmt: skip


CLEAR = (0.35, 0.65)
"""Where u and v of the sample lie: no step leaves the chart from there."""


def sample(points: int, seed: int = 3) -> tuple[np.ndarray, np.ndarray]:
    """Return (u, v) at random, in CLEAR."""
    return tuple(np.random.default_rng(seed).uniform(*CLEAR, (2, points)))
