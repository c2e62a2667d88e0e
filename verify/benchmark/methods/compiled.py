"""A kernel or program as a compiled loop over points: one thread, no fast-math, float64 or float32."""

from collections.abc import Callable, Mapping
from functools import lru_cache, partial

import llvmlite.ir as ir
import numpy as np

from proofs.engine.program import Program
from renderer import kernels
from renderer.generate.kernels import function_of
from renderer.machines.native import machine_code
from renderer.machines.points_code import emit_points
from renderer.machines.traced import FLOAT

LANES: dict[type, int] = {np.float64: 16, np.float32: 32}
TYPES: dict[type, ir.Type] = {np.float64: FLOAT, np.float32: ir.FloatType()}
NAMES = vars(kernels) | {
    "sin": lambda value: value.machine.call("sin", value),
    "cos": lambda value: value.machine.call("cos", value),
}
"""What a program may call: our functions, and the platform's libm by LLVM's own."""


def loop_of(kernel: Callable, outputs: int, kind: type = np.float64) -> Callable:
    """Return a function of arrays (n,), one for each of a kernel's parameters → array (outputs, n).

    kernel: it is traced, as those of renderer/kernels.py can be. kind: of the numbers.
    """
    code, alive = machine_code(emit_points, kernel, LANES[kind], TYPES[kind])

    def run(*arrays):
        count = len(arrays[0])
        whole = -(-count // LANES[kind]) * LANES[kind]
        arrays = [np.ascontiguousarray(a if whole == count else np.resize(a, whole), kind) for a in arrays]
        filled = np.empty((outputs, whole), kind)
        given = np.array([whole, *(a.ctypes.data for a in (*arrays, *filled))], np.int64)
        code(given.ctypes.data)
        return filled[:, :count]

    run.kind, run.alive = kind, alive  # type: ignore[attr-defined]  # the kind of number that it takes without converting
    return run


@lru_cache
def _compiled(program, scalars, kind):
    points = [s for s in program.inputs if s.name not in dict(scalars)]
    last = [s for s in program.inputs if s.name in dict(scalars)]
    ordered = Program(program.name, (*points, *last), program.definitions, program.outputs)
    return loop_of(partial(function_of(ordered, names=NAMES), **dict(scalars)), len(program.outputs), kind)


def compiled_loop(program: Program, scalars: Mapping[str, float], kind: type = np.float64) -> Callable:
    """Return a function of arrays (the program's inputs, in order, without the scalars) → array (outputs, n).

    scalars: {input's name: value}, constants of the code; of those that are no inputs nothing is asked. kind: float32
    for a program that calls no function.
    """
    asked = {s.name for s in program.inputs}
    return _compiled(program, tuple((name, value) for name, value in scalars.items() if name in asked), kind)
