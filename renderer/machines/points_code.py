"""The code that runs one kernel over points: a loop around its traced function, for any of LLVM's targets.

And the code that writes numbers as levels, by table.
"""

import inspect
from collections.abc import Callable, Collection

import llvmlite.ir as ir

from renderer.machines.traced import BYTE, FLOAT, WHOLE, Tracer
from renderer.operations import maximum, minimum

LEVELS = ("numbers", "levels", "begins", "level_at", "rows", "columns",
          "numbers_row", "numbers_column", "levels_row", "levels_column")  # fmt: skip
"""The names of the arguments of `emit_levels`: addresses, a shape, and steps in bytes."""


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
    with tracer.loop(WHOLE(0), given["rows"]) as row, tracer.loop(WHOLE(0), given["columns"]) as column:

        def place(array):
            steps = builder.mul(row, given[f"{array}_row"]), builder.mul(column, given[f"{array}_column"])
            return builder.add(given[array], builder.add(*steps))

        number = tracer.load(place("numbers"), WHOLE(0))
        cell = tracer.integer(minimum(1.0, maximum(0.0, number)) * cells)  # of NaN, the first
        level = builder.load(tracer.place(given["level_at"], cell, BYTE))
        reached = number >= tracer.load(given["begins"], builder.zext(level, WHOLE))
        level = builder.add(level, builder.zext(reached.vector, BYTE))
        builder.store(level, tracer.place(place("levels"), WHOLE(0), BYTE))
    builder.ret_void()
