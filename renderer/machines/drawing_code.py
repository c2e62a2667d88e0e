"""The code that draws some rows of a picture: two loops around the traced shader, for any of LLVM's targets."""

from collections.abc import Sequence
from functools import cache
from typing import Any

import llvmlite.ir as ir

from renderer.machines.traced import BYTE, WHOLE, Tracer, Value
from renderer.operations import Number

BYTES = ("code", "open")
BEFORE = ("x", "y", "columns", "first_row", "last_row", "pitch", "scene", "lights", "light_count", "counts")


@cache
def arguments(planes: Sequence[str]) -> tuple[str, ...]:
    """Return the names of the code's arguments, addresses and whole numbers in an array of int64, in its order."""
    return (*BEFORE, *planes, "x_bound", "y_bound", "scene_bounds")


class Pixels:
    """The pixels of one group: their image points, and the frame's planes from `at` on."""

    def __init__(self, tracer: Tracer, x: Value, y: Value, at: ir.Value):
        self.x, self.y, self._tracer, self._at = x, y, tracer, at

    def _place(self, name):
        return self._tracer.arguments[name], self._at, BYTE if name in BYTES else None

    def load(self, name: str) -> Value:
        """Return a plane's numbers as a Value."""
        return self._tracer.load(*self._place(name))

    def store(self, name: str, value: Number) -> None:
        """Write a plane's numbers."""
        self._tracer.store(value, *self._place(name))


def emit(module: ir.Module, name: str, want: Any, lanes: int) -> None:
    """Emit the function `name` that draws rows of a want, its one parameter the address of its arguments."""
    shader = want.shader
    tracer = Tracer(module, name, lanes, arguments(shader.planes), shader=shader)
    builder, inputs = tracer.builder, tracer.arguments
    scene = tracer.numbers(inputs["scene"], shader.scene, WHOLE(0))
    with tracer.rows() as (row, begin, end):
        y, row_begin = tracer.everywhere(inputs["y"], row), builder.mul(row, inputs["pitch"])
        with tracer.loop(builder.and_(begin, WHOLE(-lanes)), end, lanes) as column:
            pixels = Pixels(tracer, tracer.load(inputs["x"], column), y, builder.add(row_begin, column))
            group = shader.group(tracer, scene, want, pixels)
            if want.bounds:
                from renderer.machines.enclosing_machine import (
                    enclosed_group,
                )  # what most pictures never need to import

                bounds = tracer.numbers(inputs["scene_bounds"], shader.scene, WHOLE(0))
                x_bound, y_bound = tracer.load(inputs["x_bound"], column), tracer.everywhere(inputs["y_bound"], row)
                group = enclosed_group(group, bounds, x_bound, y_bound)
            shader.around(group).draw()
    for number, kind in enumerate(shader.counted):
        count = builder.load(tracer.counts[kind])
        builder.store(count, tracer.place(inputs["counts"], WHOLE(number), WHOLE))
    builder.ret_void()
