"""The code that draws some rows of a picture: two loops around the traced shader, for any of LLVM's targets."""

from collections.abc import Mapping

import llvmlite.ir as ir

from renderer.machines.stills import MOVING, Stills, vectors
from renderer.machines.traced import BYTE, FLOAT, WHOLE, Tracer, Value
from renderer.operations import Number
from renderer.shader.numbers import SCENE_FORM, of_form
from renderer.shader.shader import BOUNDS, CHART, COLORS, ON_A, WORK, Group, Want

PLANES = (*COLORS, "code", *ON_A, *CHART, *BOUNDS, "open")
BYTES = ("code", "open")
INPUT_BOUNDS = ("x_bound", "y_bound", "scene_bounds")
ARGUMENTS = ("x", "y", "columns", "first_row", "last_row", "pitch", "scene", "lights", "light_count", "counts",
             "stills", *PLANES, *INPUT_BOUNDS)  # fmt: skip
"""What the code is given: addresses and whole numbers, one array of int64. `columns` is (rows, 2) int64; stills: a
row of vectors for each group of pixels."""


class Pixels:
    """The pixels of one group: their image points, and the frame's planes from `at` on."""

    def __init__(self, tracer: Tracer, x: Value, y: Value, planes: Mapping[str, ir.Value], at: ir.Value):
        self.x, self.y, self._tracer, self._planes, self._at = x, y, tracer, planes, at

    def _place(self, name):
        """Return (the address of a plane's numbers, the type of them all, the bytes of one)."""
        kind, size = (BYTE, 1) if name in BYTES else (FLOAT, 8)
        vector, builder = ir.VectorType(kind, self._tracer.lanes), self._tracer.builder
        return builder.bitcast(builder.gep(self._planes[name], [self._at]), vector.as_pointer()), vector, size

    def load(self, name: str) -> Value:
        """Return a plane's numbers as a Value."""
        (address, _, size), builder = self._place(name), self._tracer.builder
        loaded = builder.load(address, align=size)
        number = builder.uitofp(loaded, self._tracer.vector) if name in BYTES else loaded
        return Value(self._tracer, number, still=None if name in COLORS else self._tracer.still_input(name))

    def store(self, name: str, value: Number) -> None:
        """Write a plane's numbers."""
        (address, vector, size), builder = self._place(name), self._tracer.builder
        stored = self._tracer.value(value).vector
        builder.store(builder.fptoui(stored, vector) if name in BYTES else stored, address, align=size)


def emit(module: ir.Module, name: str, want: Want, lanes: int, stills: Stills | None = None) -> None:
    """Emit the function `name` that draws rows of what is wanted, its one parameter the address of ARGUMENTS.

    stills: those of the functions that are wanted with `stills`.
    """
    tracer = Tracer(module, name, lanes, WORK)
    tracer.stills, tracer.storing = stills if want.stills else None, want.stills == "stored"
    builder = tracer.builder
    given = {argument: tracer.argument(number) for number, argument in enumerate(ARGUMENTS)}

    def address(argument, kind):
        return builder.inttoptr(given[argument], kind.as_pointer())

    def vector_at(argument, at):
        return builder.bitcast(builder.gep(address(argument, FLOAT), [at]), tracer.vector.as_pointer())

    y, columns = (address(argument, kind) for argument, kind in (("y", FLOAT), ("columns", WHOLE)))
    planes = {plane: address(plane, BYTE if plane in BYTES else FLOAT) for plane in PLANES}
    scene = of_form(SCENE_FORM, tracer.numbers(address("scene", FLOAT), SCENE_FORM))
    for moving in MOVING:
        vars(scene)[moving].still = None
    if want.bounds:
        from renderer.machines.enclosing_machine import enclosing_group  # what most pictures never need to import

        bounds = of_form(SCENE_FORM, tracer.numbers(address("scene_bounds", FLOAT), SCENE_FORM))
    tracer.light_numbers, tracer.light_count = address("lights", FLOAT), given["light_count"]
    kept, group = address("stills", tracer.vector), tracer.reserve(WHOLE)
    size = builder.add(WHOLE(vectors(0)), builder.mul(given["light_count"], WHOLE(vectors(1) - vectors(0))))
    builder.store(WHOLE(0), group)
    with tracer.rows(given, columns) as (row, begin, end):
        y_of_row = tracer.everywhere(builder.load(builder.gep(y, [row])), tracer.still_input("y"))
        row_begin = builder.mul(row, given["pitch"])
        with tracer.loop(builder.and_(begin, WHOLE(-lanes)), end, lanes) as column:
            x_of_group = vector_at("x", column)
            at = builder.add(row_begin, column)
            number = builder.load(group)
            tracer.kept_at = builder.gep(kept, [builder.mul(number, size)])
            builder.store(builder.add(number, WHOLE(1)), group)
            x_here = Value(tracer, builder.load(x_of_group, align=8), still=tracer.still_input("x"))
            pixels = Pixels(tracer, x_here, y_of_row, planes, at)
            if want.bounds:
                loaded = builder.load(vector_at("x_bound", column), align=8)
                y_bound = tracer.everywhere(builder.load(builder.gep(address("y_bound", FLOAT), [row])))
                enclosing_group(tracer, scene, bounds, want, pixels, Value(tracer, loaded), y_bound).draw()
            else:
                Group(tracer, scene, want, pixels).draw()
    for number, kind in enumerate(WORK):
        count = builder.gep(address("counts", WHOLE), [WHOLE(number)])
        builder.store(builder.load(tracer.counts[kind]), count)
    builder.ret_void()
