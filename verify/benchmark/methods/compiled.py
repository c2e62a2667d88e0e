"""A kernel or program as a compiled loop over points: one thread, no fast-math."""

from collections.abc import Callable
from functools import lru_cache, partial

import numpy as np

from proofs.engine.program import Program
from renderer import kernels
from renderer.generate.kernels import function_of
from renderer.machines.native import machine_code
from renderer.machines.points_code import emit_points
from renderer.machines.traced import FLOAT

LANES = 16
NAMES = vars(kernels) | {
    "sin": lambda value: value.machine.call("sin", value),
    "cos": lambda value: value.machine.call("cos", value),
}
"""The functions that a program may call: ours, and the platform's libm by LLVM's own."""


def loop_of(kernel: Callable, outputs: int) -> Callable:
    """Return a function of arrays (n,), one for each of a kernel's parameters → array (outputs, n) float64.

    kernel: it is traced, as those of renderer/kernels.py can be.
    """
    code, alive = machine_code(emit_points, kernel, LANES, FLOAT)

    def run(*arrays):
        count = len(arrays[0])
        padded = -(-count // LANES) * LANES
        arrays = [np.ascontiguousarray(a if padded == count else np.resize(a, padded), np.float64) for a in arrays]
        filled = np.empty((outputs, padded))
        pointers = np.array([padded, *(a.ctypes.data for a in (*arrays, *filled))], np.int64)
        code(pointers.ctypes.data)
        return filled[:, :count]

    run.alive = alive  # type: ignore[attr-defined]
    return run


@lru_cache
def compiled_loop(program: Program, **scalars: float) -> Callable:
    """Return a function of arrays (the program's inputs, in order, without the scalars) → array (outputs, n).

    scalars: constants of the code; those that are no inputs are ignored.
    """
    inputs = sorted(program.inputs, key=lambda s: s.name in scalars)  # those that only a name gives come last
    ordered = Program(program.name, inputs, program.definitions, program.outputs)
    constants = {s.name: scalars[s.name] for s in inputs if s.name in scalars}
    return loop_of(partial(function_of(ordered, names=NAMES), **constants), len(program.outputs))
