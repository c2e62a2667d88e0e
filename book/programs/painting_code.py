"""The code that paints planes as a canvas's bytes, for any of LLVM's targets: `picture.views` by table.

A level, of sRGB or of a scale of colours, begins at a threshold. A table says which level holds where a cell of numbers
begins; cells are so small that at most one threshold lies inside. One pixel is painted after another, as an int32:
red is its lowest byte, and it is opaque.
"""

from collections.abc import Callable, Iterable

import llvmlite.ir as ir

from renderer.machines.forms import COLORS
from renderer.machines.traced import BYTE, WHOLE, Tracer, Value
from renderer.operations import maximum, minimum, rint

PAINTING = ("columns", "first_row", "last_row", "pitch", "pixels", "level_at", "threshold", "palette", "numbers",
            "plane", *COLORS, *(f"other_{color}" for color in COLORS))  # fmt: skip
"""The names of the code's arguments, in an array of int64 as `drawing_code.arguments` are. level_at: uint8, threshold:
float64, palette: int32, by level. plane: float64. numbers: float64, by NUMBERS."""
NUMBERS = ("gain", "largest", "squares")
"""The gain is read; the largest difference of a channel, and the sum of their squares, are written."""
SRGB_CELLS = 2**12  # equal parts of [0, 1]
SIZE_BITS = 16  # of a float64's upper ones: a cell is a sixteenth of an octave
PIXEL = ir.IntType(32)
OPAQUE = WHOLE(255 << 24)


class Pixel:
    """The pixel that is painted: its place among the planes, and the tables. Whole numbers are int64."""

    def __init__(self, tracer: Tracer, at: ir.Value):
        self.tracer, self.builder, self.arguments, self.at = tracer, tracer.builder, tracer.arguments, at

    def load(self, plane: str) -> Value:
        """Return a plane's number."""
        return self.tracer.load(self.arguments[plane], self.at)

    def number(self, name: str) -> tuple[ir.Value, ir.Value]:
        """Return where one of NUMBERS is: an array, and a place in it."""
        return self.arguments["numbers"], WHOLE(NUMBERS.index(name))

    def integer(self, argument: str, at: ir.Value, kind: ir.Type = PIXEL) -> ir.Value:
        """Return a whole number of an array."""
        return self.builder.zext(self.builder.load(self.tracer.place(self.arguments[argument], at, kind)), WHOLE)

    def level(self, number: Value, cell: ir.Value) -> ir.Value:
        """Return the level of a number in a cell of the table."""
        level = self.integer("level_at", cell, BYTE)
        above = number >= self.tracer.load(self.arguments["threshold"], self.builder.add(level, WHOLE(1)))
        return self.builder.add(level, self.builder.zext(above.vector, WHOLE))

    def scaled(self, number: Value, share: float) -> ir.Value:
        """Return a number times the gain, at most `share`, as the nearest of 255 levels."""
        product = minimum(number * self.tracer.load(*self.number("gain")), share)
        return self.tracer.integer(rint(product * (255 / share)))

    def packed(self, levels: Iterable[ir.Value]) -> ir.Value:
        """Return the pixel of red, green and blue."""
        pixel = OPAQUE
        for channel, level in enumerate(levels):
            pixel = self.builder.or_(pixel, self.builder.shl(level, WHOLE(8 * channel)))
        return pixel

    def apart(self) -> tuple[list[Value], Value]:
        """Return the sizes of the three differences and the largest of them, and take them into the account."""
        red, green, blue = sizes = [abs(self.load(color) - self.load(f"other_{color}")) for color in COLORS]
        largest = maximum(maximum(red, green), blue)
        before, total = (self.tracer.load(*self.number(name)) for name in NUMBERS[1:])
        self.tracer.store(maximum(before, largest), *self.number("largest"))
        self.tracer.store(total + red * red + green * green + blue * blue, *self.number("squares"))
        return sizes, largest


def colors(pixel: Pixel) -> ir.Value:
    """Return the colours as sRGB."""
    channels = map(pixel.load, COLORS)
    return pixel.packed(pixel.level(linear, pixel.tracer.integer(linear * SRGB_CELLS)) for linear in channels)


def difference_logarithmic(pixel: Pixel) -> ir.Value:
    """Return the largest difference of a channel, in the palette's colours by level; 0 is black."""
    (_, largest), builder = pixel.apart(), pixel.builder
    cell = builder.lshr(builder.bitcast(largest.vector, WHOLE), WHOLE(64 - SIZE_BITS))
    return builder.select((largest > 0.0).vector, pixel.integer("palette", pixel.level(largest, cell)), OPAQUE)


def difference_linear(pixel: Pixel) -> ir.Value:
    """Return the differences of the channels times the gain."""
    sizes, _ = pixel.apart()
    return pixel.packed(pixel.scaled(size, 1.0) for size in sizes)


def levels(pixel: Pixel) -> ir.Value:
    """Return a plane times the gain as a level, at most 255, in the palette's colours."""
    return pixel.integer("palette", pixel.scaled(pixel.load("plane"), 255.0))


def flags(pixel: Pixel) -> ir.Value:
    """Return the pixel that is there, dimmed to a third; white where the plane is 1."""
    builder, there = pixel.builder, pixel.integer("pixels", pixel.at)
    bytes_there = (builder.and_(builder.lshr(there, WHOLE(8 * channel)), WHOLE(255)) for channel in range(3))
    dimmed = pixel.packed(builder.udiv(level, WHOLE(3)) for level in bytes_there)
    return builder.select((pixel.load("plane") > 0.0).vector, WHOLE(-1), dimmed)


PAINTERS = {
    f"paint_{painter.__name__}": painter
    for painter in (colors, difference_logarithmic, difference_linear, levels, flags)
}


def emit_painter(module: ir.Module, name: str, painter: Callable[[Pixel], ir.Value]) -> None:
    """Emit the function `name` that paints some columns of some rows, its one parameter the address of PAINTING."""
    tracer = Tracer(module, name, 1, PAINTING)
    builder, arguments = tracer.builder, tracer.arguments
    with tracer.rows() as (row, begin, end):
        row_begin = builder.mul(row, arguments["pitch"])
        with tracer.loop(begin, end) as column:
            at = builder.add(row_begin, column)
            painted = builder.trunc(painter(Pixel(tracer, at)), PIXEL)
            builder.store(painted, tracer.place(arguments["pixels"], at, PIXEL))
    builder.ret_void()
