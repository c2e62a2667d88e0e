"""The code that runs one kernel over points: a loop around its traced function, for any of LLVM's targets."""

import inspect
from collections.abc import Callable, Collection

import llvmlite.ir as ir

from renderer.machines.traced import FLOAT, WHOLE, Tracer


def inputs_of(kernel: Callable) -> tuple[str, ...]:
    """Return the names of a kernel's inputs at each point: its parameters that are not keyword-only."""
    return tuple(p.name for p in inspect.signature(kernel).parameters.values() if p.kind != p.KEYWORD_ONLY)


def emit_points(
    module: ir.Module,
    name: str,
    kernel: Callable,
    lanes: int,
    number: ir.Type = FLOAT,
    everywhere: Collection[int] = (),
) -> int:
    """Emit the function `name`, its one parameter the address of int64 numbers: how many points, then addresses.

    The addresses are of arrays of float64 (or another `number`): the kernel's inputs, then its outputs. The arrays are
    whole groups long. everywhere: which inputs are one number for all points. Returns how many outputs there are.
    """
    tracer, inputs = Tracer(module, name, lanes, number=number), len(inputs_of(kernel))
    with tracer.loop(WHOLE(0), tracer.argument(0), lanes) as at:
        arrays = enumerate(map(tracer.argument, range(1, 1 + inputs)))
        result = kernel(*(tracer.everywhere(a, WHOLE(0)) if n in everywhere else tracer.load(a, at) for n, a in arrays))
        outputs = result if isinstance(result, tuple) else (result,)
        for array, output in enumerate(outputs, start=1 + inputs):
            tracer.store(output, tracer.argument(array), at)
    tracer.builder.ret_void()
    return len(outputs)
