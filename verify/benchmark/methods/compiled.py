"""A kernel or program as a compiled loop over points: one thread, no fast-math, float64 or float32."""

from collections.abc import Callable
from functools import lru_cache, partial

import llvmlite.ir as ir
import numpy as np

from proofs.engine.program import Program
from renderer import kernels
from renderer.generate.kernels import function_of
from renderer.machines.native import machine_code
from renderer.machines.points_code import emit_points
from renderer.machines.traced import FLOAT

KINDS: dict[type, tuple[int, ir.Type]] = {np.float64: (16, FLOAT), np.float32: (32, ir.FloatType())}
"""{kind of number: (lanes, LLVM's type of it)}"""
NAMES = vars(kernels) | {
    "sin": lambda value: value.machine.call("sin", value),
    "cos": lambda value: value.machine.call("cos", value),
}
"""What a program may call: our functions, and the platform's libm by LLVM's own."""


def loop_of(kernel: Callable, outputs: int, kind: type = np.float64) -> Callable:
    """Return a function of arrays (n,), one for each of a kernel's parameters → array (outputs, n).

    kernel: it is traced, as those of renderer/kernels.py can be. kind: of the numbers.
    """
    lanes, number = KINDS[kind]
    code, alive = machine_code(emit_points, kernel, lanes, number)

    def run(*arrays):
        count = len(arrays[0])
        whole = -(-count // lanes) * lanes
        arrays = [np.ascontiguousarray(a if whole == count else np.resize(a, whole), kind) for a in arrays]
        filled = np.empty((outputs, whole), kind)
        given = np.array([whole, *(a.ctypes.data for a in (*arrays, *filled))], np.int64)
        code(given.ctypes.data)
        return filled[:, :count]

    run.kind, run.alive = kind, alive  # type: ignore[attr-defined]  # the kind of number that it takes without converting
    return run


@lru_cache
def compiled_loop(program: Program, kind: type = np.float64, **scalars: float) -> Callable:
    """Return a function of arrays (the program's inputs, in order, without the scalars) → array (outputs, n).

    scalars: constants of the code; of those that are no inputs nothing is asked. kind: float32 for a program that calls
    no function.
    """
    inputs = sorted(program.inputs, key=lambda s: s.name in scalars)  # those that only a name gives come last
    ordered = Program(program.name, inputs, program.definitions, program.outputs)
    constants = {s.name: scalars[s.name] for s in inputs if s.name in scalars}
    return loop_of(partial(function_of(ordered, names=NAMES), **constants), len(program.outputs), kind)
