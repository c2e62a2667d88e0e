"""The code that runs one kernel over points: a loop around its traced function, for any of LLVM's targets."""

import inspect
from collections.abc import Callable

import llvmlite.ir as ir

from renderer.machines.traced import FLOAT, WHOLE, Tracer, Value


def inputs_of(kernel: Callable) -> tuple[str, ...]:
    """Return the names of what a kernel takes at each point: its parameters, but those that only a name can give."""
    return tuple(p.name for p in inspect.signature(kernel).parameters.values() if p.kind != p.KEYWORD_ONLY)


def emit_points(module: ir.Module, name: str, kernel: Callable, lanes: int, number: ir.Type = FLOAT) -> int:
    """Emit the function `name`, its one parameter the address of int64 numbers: how many points, then addresses.

    The addresses are of arrays of float64 (or another `number`): the kernel's inputs, then its outputs. The arrays are
    whole groups long. Returns how many outputs there are.
    """
    tracer = Tracer(module, name, lanes, number=number)
    builder = tracer.builder

    def place(array, at):
        pointer = builder.gep(builder.inttoptr(tracer.argument(1 + array), number.as_pointer()), [at])
        return builder.bitcast(pointer, tracer.vector.as_pointer())

    inputs = range(len(inputs_of(kernel)))
    with tracer.loop(WHOLE(0), tracer.argument(0), lanes) as at:
        found = kernel(*(Value(tracer, builder.load(place(array, at), align=8)) for array in inputs))
        outputs = found if isinstance(found, tuple) else (found,)
        for array, output in enumerate(outputs, start=len(inputs)):
            builder.store(tracer.value(output).vector, place(array, at), align=8)
    builder.ret_void()
    return len(outputs)
