"""The code that paints planes as a canvas's bytes, for any of LLVM's targets: what `picture.views` does, by table.

A level, of sRGB or of a scale of colours, begins at a threshold. A table says which level holds where a cell of numbers
begins; cells are so small that at most one threshold lies inside. One pixel is painted after another, as an int32:
red is its lowest byte, and it is opaque.
"""

from collections.abc import Callable, Mapping, Sequence

import llvmlite.ir as ir

from renderer.machines.traced import BYTE, FLOAT, WHOLE, Tracer, Value
from renderer.shader.shader import COLORS

OTHERS = tuple(f"other_{color}" for color in COLORS)
PAINTING = ("columns", "first_row", "last_row", "pitch", "pixels", "level_at", "threshold", "palette", "numbers",
            "plane", *COLORS, *OTHERS)  # fmt: skip
"""What the code is given, one array of int64: as in `drawing_code.ARGUMENTS`. level_at: uint8, threshold: float64,
palette: int32, by level. plane: float64. numbers: float64, by NUMBERS."""
NUMBERS = ("gain", "largest", "squares")
"""The gain is given; what is found is the largest difference of a channel, and the sum of their squares."""
SRGB_CELLS = 2**12  # equal parts of [0, 1]
SIZE_BITS = 16  # of a float64's upper ones: a cell is a sixteenth of an octave
PIXEL = ir.IntType(32)
OPAQUE = ir.Constant(PIXEL, 255 << 24)


class Pixel:
    """The pixel that is painted: its place among the planes, and the tables."""

    def __init__(self, tracer: Tracer, given: Mapping[str, ir.Value], at: ir.Value):
        self.tracer, self.builder, self._given, self._at = tracer, tracer.builder, given, at

    def _place(self, argument, kind, at):
        return self.builder.gep(self.builder.inttoptr(self._given[argument], kind.as_pointer()), [at])

    def load(self, plane: str) -> ir.Value:
        """Return a plane's number, float64."""
        return self.builder.load(self._place(plane, FLOAT, self._at))

    def number(self, name: str) -> ir.Value:
        """Return the address of one of NUMBERS."""
        return self._place("numbers", FLOAT, WHOLE(NUMBERS.index(name)))

    @property
    def place(self) -> ir.Value:
        """The address of the pixel."""
        return self._place("pixels", PIXEL, self._at)

    def call(self, name: str, number: ir.Value) -> ir.Value:
        """Return what one of LLVM's own functions makes of a number."""
        vector = self.builder.bitcast(number, self.tracer.vector)
        return self.builder.bitcast(self.tracer.call(name, Value(self.tracer, vector)).vector, FLOAT)

    def larger(self, number: ir.Value, than: ir.Value) -> ir.Value:
        """Return the larger one of two numbers."""
        return self.builder.select(self.builder.fcmp_ordered(">", number, than), number, than)

    def least(self, number: ir.Value, most: float) -> ir.Value:
        """Return the smaller one of a number and a literal."""
        return self.builder.select(self.builder.fcmp_ordered("<", number, FLOAT(most)), number, FLOAT(most))

    def level(self, number: ir.Value, cell: ir.Value) -> ir.Value:
        """Return the level, an int32, of a number in a cell of the table."""
        builder = self.builder
        level = builder.zext(builder.load(self._place("level_at", BYTE, cell)), PIXEL)
        following = builder.add(builder.zext(level, WHOLE), WHOLE(1))
        above = builder.fcmp_ordered(">=", number, builder.load(self._place("threshold", FLOAT, following)))
        return builder.add(level, builder.zext(above, PIXEL))

    def colour(self, level: ir.Value) -> ir.Value:
        """Return the palette's pixel of a level."""
        return self.builder.load(self._place("palette", PIXEL, self.builder.zext(level, WHOLE)))

    def packed(self, levels: Sequence[ir.Value]) -> ir.Value:
        """Return the pixel of red, green and blue, int32."""
        pixel = OPAQUE
        for channel, level in enumerate(levels):
            pixel = self.builder.or_(pixel, self.builder.shl(level, PIXEL(8 * channel)))
        return pixel

    def scaled(self, number: ir.Value, share: float) -> ir.Value:
        """Return a number times the gain, at most `share`, as the nearest of 255 levels, int32."""
        product = self.least(self.builder.fmul(number, self.builder.load(self.number("gain"))), share)
        return self.builder.fptoui(self.call("rint", self.builder.fmul(product, FLOAT(255 / share))), PIXEL)

    def apart(self) -> tuple[list[ir.Value], ir.Value]:
        """Return the sizes of the three differences and the largest of them, and take them into the account."""
        builder = self.builder
        pairs = ((self.load(one), self.load(other)) for one, other in zip(COLORS, OTHERS, strict=True))
        sizes = [self.call("fabs", builder.fsub(one, other)) for one, other in pairs]
        largest = sizes[0]
        for size in sizes[1:]:
            largest = self.larger(size, largest)
        found = self.larger(largest, builder.load(self.number("largest")))
        builder.store(found, self.number("largest"))
        total = builder.load(self.number("squares"))
        for size in sizes:
            total = builder.fadd(total, builder.fmul(size, size))
        builder.store(total, self.number("squares"))
        return sizes, largest


def colors(pixel: Pixel) -> ir.Value:
    """The colours, as sRGB."""
    builder, levels = pixel.builder, []
    for color in COLORS:
        linear = pixel.load(color)
        cell = builder.fptoui(builder.fmul(linear, FLOAT(SRGB_CELLS)), WHOLE)
        levels.append(pixel.level(linear, cell))
    return pixel.packed(levels)


def difference_logarithmic(pixel: Pixel) -> ir.Value:
    """The largest difference of a channel, in the palette's colours by level; 0 is black."""
    builder, (_, largest) = pixel.builder, pixel.apart()
    cell = builder.lshr(builder.bitcast(largest, WHOLE), WHOLE(64 - SIZE_BITS))
    colour = pixel.colour(pixel.level(largest, cell))
    return builder.select(builder.fcmp_ordered(">", largest, FLOAT(0.0)), colour, OPAQUE)


def difference_linear(pixel: Pixel) -> ir.Value:
    """The differences of the channels times the gain."""
    sizes, _ = pixel.apart()
    return pixel.packed([pixel.scaled(size, 1.0) for size in sizes])


def levels(pixel: Pixel) -> ir.Value:
    """A plane times the gain as a level, at most 255, in the palette's colours."""
    return pixel.colour(pixel.scaled(pixel.load("plane"), 255.0))


def flags(pixel: Pixel) -> ir.Value:
    """What is there, dimmed to a third; white where the plane is 1."""
    builder, there = pixel.builder, pixel.builder.load(pixel.place)
    bytes_there = [builder.and_(builder.lshr(there, PIXEL(8 * channel)), PIXEL(255)) for channel in range(3)]
    dimmed = pixel.packed([builder.udiv(level, PIXEL(3)) for level in bytes_there])
    return builder.select(builder.fcmp_ordered(">", pixel.load("plane"), FLOAT(0.0)), PIXEL(-1), dimmed)


PAINTERS = {
    f"paint_{painter.__name__}": painter
    for painter in (colors, difference_logarithmic, difference_linear, levels, flags)
}


def emit_painter(module: ir.Module, name: str, painter: Callable[[Pixel], ir.Value]) -> None:
    """Emit the function `name` that paints some columns of some rows, its one parameter the address of PAINTING."""
    tracer = Tracer(module, name, 1)
    builder = tracer.builder
    given = {argument: tracer.argument(number) for number, argument in enumerate(PAINTING)}
    with tracer.rows(given, builder.inttoptr(given["columns"], WHOLE.as_pointer())) as (row, begin, end):
        row_begin = builder.mul(row, given["pitch"])
        with tracer.loop(begin, end) as column:
            pixel = Pixel(tracer, given, builder.add(row_begin, column))
            builder.store(painter(pixel), pixel.place)
    builder.ret_void()
