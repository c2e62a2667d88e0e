"""The code that paints planes as a canvas's bytes, for any of LLVM's targets: what `picture.views` does, by table.

A level, of sRGB or of a scale of colours, begins at a threshold. A table says which level holds where a cell of numbers
begins; cells are so small that at most one threshold lies inside. One pixel is painted after another, as an int32:
red is its lowest byte, and it is opaque. Until it is stored it is a float64, which holds every whole number of 32 bits.
"""

from collections.abc import Callable, Iterable
from itertools import pairwise

import llvmlite.ir as ir

from renderer.machines.traced import BYTE, WHOLE, Tracer, Value
from renderer.operations import floor, maximum, minimum, rint, where
from renderer.shader.shader import COLORS

PAINTING = ("columns", "first_row", "last_row", "pitch", "pixels", "level_at", "threshold", "palette", "numbers",
            "plane", *COLORS, *(f"other_{color}" for color in COLORS))  # fmt: skip
"""What the code is given, one array of int64: as in `drawing_code.ARGUMENTS`. level_at: uint8, threshold: float64,
palette: int32, by level. plane: float64. numbers: float64, by NUMBERS."""
NUMBERS = ("gain", "largest", "squares")
"""The gain is given; what is found is the largest difference of a channel, and the sum of their squares."""
SRGB_CELLS = 2**12  # equal parts of [0, 1]
SIZE_BITS = 16  # of a float64's upper ones: a cell is a sixteenth of an octave
PIXEL = ir.IntType(32)
OPAQUE = 255.0 * 2**24


class Pixel:
    """The pixel that is painted: its place among the planes, and the tables."""

    def __init__(self, tracer: Tracer, at: ir.Value):
        self.tracer, self.given, self.at = tracer, tracer.given, at

    def load(self, plane: str) -> Value:
        """Return a plane's number."""
        return self.tracer.load(self.given[plane], self.at)

    def number(self, name: str) -> tuple[ir.Value, ir.Value]:
        """Return where one of NUMBERS is: an array, and a place in it."""
        return self.given["numbers"], WHOLE(NUMBERS.index(name))

    def level(self, number: Value, cell: ir.Value) -> Value:
        """Return the level of a number in a cell of the table."""
        level = self.tracer.load(self.given["level_at"], cell, BYTE)
        threshold = self.tracer.load(self.given["threshold"], self.tracer.whole(level + 1.0))
        return where(number >= threshold, level + 1.0, level)

    def colour(self, level: Value) -> Value:
        """Return the palette's pixel of a level."""
        return self.tracer.load(self.given["palette"], self.tracer.whole(level), PIXEL)

    def scaled(self, number: Value, share: float) -> Value:
        """Return a number times the gain, at most `share`, as the nearest of 255 levels."""
        return rint(minimum(number * self.tracer.load(*self.number("gain")), share) * (255 / share))

    def apart(self) -> tuple[list[Value], Value]:
        """Return the sizes of the three differences and the largest of them, and take them into the account."""
        red, green, blue = sizes = [abs(self.load(color) - self.load(f"other_{color}")) for color in COLORS]
        largest = maximum(maximum(red, green), blue)
        found, total = (self.tracer.load(*self.number(name)) for name in NUMBERS[1:])
        self.tracer.store(maximum(found, largest), *self.number("largest"))
        self.tracer.store(total + red * red + green * green + blue * blue, *self.number("squares"))
        return sizes, largest


def packed(levels: Iterable[Value]) -> Value:
    """Return the pixel of red, green and blue."""
    red, green, blue = levels
    return red + green * 2.0**8 + blue * 2.0**16 + OPAQUE


def colors(pixel: Pixel) -> Value:
    """The colours, as sRGB."""
    channels = map(pixel.load, COLORS)
    return packed(pixel.level(linear, pixel.tracer.whole(linear * SRGB_CELLS)) for linear in channels)


def difference_logarithmic(pixel: Pixel) -> Value:
    """The largest difference of a channel, in the palette's colours by level; 0 is black."""
    (_, largest), builder = pixel.apart(), pixel.tracer.builder
    cell = builder.lshr(builder.bitcast(largest.vector, WHOLE), WHOLE(64 - SIZE_BITS))
    return where(largest > 0.0, pixel.colour(pixel.level(largest, cell)), OPAQUE)


def difference_linear(pixel: Pixel) -> Value:
    """The differences of the channels times the gain."""
    sizes, _ = pixel.apart()
    return packed(pixel.scaled(size, 1.0) for size in sizes)


def levels(pixel: Pixel) -> Value:
    """A plane times the gain as a level, at most 255, in the palette's colours."""
    return pixel.colour(pixel.scaled(pixel.load("plane"), 255.0))


def flags(pixel: Pixel) -> Value:
    """What is there, dimmed to a third; white where the plane is 1."""
    there = pixel.tracer.load(pixel.given["pixels"], pixel.at, PIXEL)
    bytes_from = [floor(there * 2.0**-shift) for shift in (0, 8, 16, 24)]
    dimmed = (floor((byte - 256.0 * above) / 3.0) for byte, above in pairwise(bytes_from))
    return where(pixel.load("plane") > 0.0, 2.0**32 - 1.0, packed(dimmed))


PAINTERS = {
    f"paint_{painter.__name__}": painter
    for painter in (colors, difference_logarithmic, difference_linear, levels, flags)
}


def emit_painter(module: ir.Module, name: str, painter: Callable[[Pixel], Value]) -> None:
    """Emit the function `name` that paints some columns of some rows, its one parameter the address of PAINTING."""
    tracer = Tracer(module, name, 1, PAINTING)
    with tracer.rows() as (row, begin, end):
        row_begin = tracer.builder.mul(row, tracer.given["pitch"])
        with tracer.loop(begin, end) as column:
            pixel = Pixel(tracer, tracer.builder.add(row_begin, column))
            tracer.store(painter(pixel), tracer.given["pixels"], pixel.at, PIXEL)
    tracer.builder.ret_void()
