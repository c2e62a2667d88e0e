"""A straight-line program as a compiled loop over points: one thread, no fast-math, float64 or float32."""

import math
from functools import lru_cache
from typing import ClassVar

import numpy as np
from numba import njit

from renderer import kernels
from renderer.generate.printers import NumbaPrinter


class _LibmPrinter(NumbaPrinter):
    """sin, cos and the rest by the platform's libm."""

    _libm: ClassVar = {"sin": "math.sin", "cos": "math.cos"}

    def _print_Function(self, expr):
        return self._call(self._libm[type(expr).__name__], expr.args)


class _Float32Printer(NumbaPrinter):
    """Every literal is a float32, so that nothing is done in float64."""

    pi = "pi_32"

    def literal(self, rational):
        return f"float32({float(rational)!r})"


_PRINTERS = {"ours": NumbaPrinter, "libm": _LibmPrinter, "float32": _Float32Printer}
_SCOPE = {**vars(kernels), "math": math, "np": np, "float32": np.float32, "pi_32": np.float32(math.pi)}


@lru_cache
def _loop(program, scalars, functions):
    """Return (the compiled loop, how many arrays it takes, how many it fills); `scalars`: inputs that are numbers."""
    printer = _PRINTERS[functions]()
    points = [s.name for s in program.inputs if s.name not in scalars]
    results = [f"{s.name}_out" for s in program.outputs]
    body = [f"{name} = {name}_in[i]" for name in points]
    body += [f"{s.name} = {printer.doprint(e)}" for s, e in program.definitions]
    body += [f"{result}[i] = {s.name}" for s, result in zip(program.outputs, results, strict=True)]
    arguments = ", ".join([*(f"{name}_in" for name in points), *scalars, *results])
    lines = "\n        ".join(body)
    scope = dict(_SCOPE)
    exec(f"def loop({arguments}):\n    for i in range({points[0]}_in.shape[0]):\n        {lines}\n", scope)
    return njit(error_model="numpy")(scope["loop"]), len(results)


def compiled_loop(program, scalars, functions="ours"):
    """Return a function of arrays (the program's inputs, in order, without the scalars) → tuple of output arrays.

    scalars: {input's name: value}. functions: "ours" (reduced in half-turns), "libm", or "float32" (no function).
    """
    kind = np.float32 if functions == "float32" else np.float64
    names = tuple(s.name for s in program.inputs if s.name in scalars)
    loop, outputs = _loop(program, names, functions)
    values = [kind(scalars[name]) for name in names]

    def run(*arrays):
        arrays = [np.ascontiguousarray(a, kind) for a in arrays]
        filled = tuple(np.empty((outputs, *arrays[0].shape), kind))
        loop(*arrays, *values, *filled)
        return filled

    run.kind = kind  # of number that it takes without converting
    return run
