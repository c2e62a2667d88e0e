"""The code that runs one kernel over points: a loop around its traced function, for any of LLVM's targets.

And the code that writes numbers as levels, by table.
"""

import inspect
from collections.abc import Callable, Collection

import llvmlite.ir as ir

from renderer.machines.traced import BYTE, FLOAT, WHOLE, Tracer
from renderer.operations import where

LEVELS = ("numbers", "begins", "level_at", "levels", "rows", "columns", "channels", "row", "column", "channel")
"""The names of the arguments of `emit_levels`: addresses, an array's shape, and its steps in bytes."""


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
    kind: ir.Type | None = None,
) -> int:
    """Emit the function `name`, its one parameter the address of int64 numbers: how many points, then addresses.

    The addresses are of arrays of float64 (or another `number`, or a `kind` of whole ones): the kernel's inputs, then
    its outputs. The arrays are whole groups long. everywhere: which inputs are one number for all points. Returns how
    many outputs there are.
    """
    tracer, inputs = Tracer(module, name, lanes, number=number), len(inputs_of(kernel))
    with tracer.loop(WHOLE(0), tracer.argument(0), lanes) as at:
        given = ((n in everywhere, tracer.argument(1 + n)) for n in range(inputs))
        result = kernel(*(tracer.everywhere(a, WHOLE(0)) if one else tracer.load(a, at, kind) for one, a in given))
        outputs = result if isinstance(result, tuple) else (result,)
        for array, output in enumerate(outputs, start=1 + inputs):
            tracer.store(output, tracer.argument(array), at, kind)
    tracer.builder.ret_void()
    return len(outputs)


def emit_levels(module: ir.Module, name: str, cells: int) -> None:
    """Emit the function `name` that is `numpy_rows.write_levels`, its one parameter the address of LEVELS."""
    tracer = Tracer(module, name, 1, LEVELS)
    builder, given = tracer.builder, tracer.arguments
    loops = (tracer.loop(WHOLE(0), given[count]) for count in ("rows", "channels", "columns"))
    with next(loops) as row, next(loops) as channel, next(loops) as column:
        address = given["numbers"]
        for step, times in zip(LEVELS[-3:], (row, column, channel), strict=True):
            address = builder.add(address, builder.mul(given[step], times))
        number = tracer.load(address, WHOLE(0))
        cell = tracer.integer(where(number > 0.0, where(number < 1.0, number, 1.0), 0.0) * cells)
        level = builder.zext(builder.load(tracer.place(given["level_at"], cell, BYTE)), WHOLE)
        reached = number >= tracer.load(given["begins"], level)
        at = builder.add(
            builder.mul(builder.add(builder.mul(row, given["columns"]), column), given["channels"]), channel
        )
        level = builder.trunc(builder.add(level, builder.zext(reached.vector, WHOLE)), BYTE)
        builder.store(level, tracer.place(given["levels"], at, BYTE))
    builder.ret_void()
