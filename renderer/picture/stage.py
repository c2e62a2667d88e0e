"""The stage: the chambers of a scene on a raster, and the colours off sphere A, which no bump changes.

Chambers depend on neither the height field, β, ε nor the gradient method (theorem bump_moves_no_boundary), so a
`Stage` serves every such change. It takes 1 byte a pixel, and 24 bytes a pixel more once it is drawn from.
"""

from collections import deque
from collections.abc import Callable
from contextlib import suppress
from functools import lru_cache
from typing import Any

import numpy as np

from renderer.checks import not_allowed
from renderer.machines import Job, compiling, machine
from renderer.shader.numbers import Shot, reach_of_a, read_only
from renderer.shader.shader import COLORS, WORK
from renderer.threads import run_bands

SURFACE_BITS = 3
PITCH = 16  # rows of planes are as long as whole groups of pixels, whatever the machine's lanes
MAX_DRAWN = 2**28
MOST_BANDS = 16
SMALLEST_BAND = 2**13  # pixels: below that, starting on a band costs more than drawing it
MOST_KEPT = 2**29  # bytes: the colours of 4096², or ten slopes of 1024²
_spare: deque[np.ndarray] = deque(maxlen=3)  # a picture's colours, their bounds, and slopes


class _Lent:
    """Memory as NumPy asks for it; it is spare again when the last array that lies in it is gone."""

    def __init__(self, block: np.ndarray):
        self._block, self.__array_interface__ = block, block.__array_interface__

    def __del__(self, spare: deque = _spare, most: int = MOST_KEPT) -> None:
        if self._block.nbytes <= most:
            give_back(most - self._block.nbytes, spare)
            spare.append(self._block)


def give_back(keep: int = 0, spare: deque = _spare) -> None:
    """Give the system what is more than some bytes of the memory of pictures that are gone, kept for the next ones.

    Without this at most MOST_KEPT bytes are kept.

    >>> from renderer import Scene, render
    >>> from renderer.picture.stage import give_back
    >>> shape = render(Scene(), 16, 16).shape  # its memory waits for another picture
    >>> give_back()
    """
    with suppress(IndexError):  # another thread took the last
        while sum(block.nbytes for block in tuple(spare)) > keep:
            spare.popleft()


def lent(shape: tuple[int, ...]) -> np.ndarray:
    """Return an uninitialised array of float64, reused if one is spare: the system clears fresh memory first."""
    with suppress(IndexError):  # another thread took it
        for _ in range(len(_spare)):
            block = _spare.popleft()
            if block.shape == shape:
                return np.asarray(_Lent(block))
            _spare.append(block)
    return np.asarray(_Lent(np.empty(shape)))


@lru_cache(maxsize=16)
def _prepared(geometry, raster):
    """Return (x of the columns and NaN up to whole groups, y of the rows, all columns, columns that A may be in)."""
    x, y = raster.image_points(geometry)
    wide = np.full(-(-len(x) // PITCH) * PITCH, np.nan)
    wide[: len(x)] = x
    everywhere = np.tile(np.array([0, len(x)], np.int64), (len(y), 1))
    square = reach_of_a(geometry.eye, geometry.radius) * (1 + 1e-9) - y * y
    half = np.where(square < 0.0, -np.inf, np.sqrt(np.maximum(square, 0.0)))
    of_a = np.stack([x.searchsorted(-half), x.searchsorted(half, "right")], axis=1).astype(np.int64)
    return wide, y, everywhere, of_a


def band_rows(rows: int, columns: int) -> int:
    """Return how many rows a band has: MOST_BANDS bands, unless they would be smaller than SMALLEST_BAND."""
    return min(rows, max(-(-rows // MOST_BANDS), -(-SMALLEST_BAND // columns)))


class Stage:
    """The chambers of a shot, shared by every gradient method, field, β and ε.

    chambers: (height, width) uint8. Bits 0–1 are the surface (0 none, 1 A, 2 B, 3 floor), bit 2 + i says that light i
    is occluded by another body (0 for a light that is off), bit 7 that the floor square is dark. x: (width,) image
    points of the columns, y: (height,) of the rows. Frames share all of these: they are read-only.
    """

    def __init__(self, shot: Shot):
        """Prepare the planes; they are filled by drawing. Raises ValueError on more than 2**28 drawn pixels."""
        self.geometry, self.raster = shot.geometry, shot.raster
        rows, columns = self.raster.shape
        if rows * columns > MAX_DRAWN:
            raise not_allowed("width * height", rows * columns, f"at most {MAX_DRAWN} drawn pixels")
        self._x, self._y, self._everywhere, self._columns_of_a = _prepared(self.geometry, self.raster)
        self._codes = self.new_plane(np.uint8)
        self.x, self.y, self.chambers = self._x[:columns], self._y[:], self._codes[:, :columns]
        read_only(self.x, self.y, self.chambers)
        self._elsewhere: tuple[Any, Any] = (None, None)

    def __repr__(self) -> str:
        return f"Stage({self.raster}, {self.geometry})"

    def new_plane(self, kind: type = np.float64, channels: int | None = None) -> np.ndarray:
        """Return memory for a plane, or for several of float64, with rows as long as whole groups."""
        shape = len(self._y), len(self._x)
        return np.empty(shape, kind) if channels is None else lent((channels, *shape))

    def job(self, numbers: tuple[np.ndarray, np.ndarray], planes: Job, of_a: bool = False) -> Job:
        """Return the Job of a drawing (`renderer.machines`) by a shot's numbers, of all columns or of those with A."""
        scene, lights = numbers
        raster_data = {"x": self._x, "y": self._y, "columns": self._columns_of_a if of_a else self._everywhere}
        return raster_data | {"scene": scene, "lights": lights, "code": self._codes} | planes

    def draw(
        self,
        shot: Shot,
        threads: int | None,
        planes: Job,
        before: Callable[[slice], None] | None = None,
        **changes: Any,
    ) -> list[int]:
        """Draw a shot's want (`renderer.shader.numbers.Want`), with some changes, into planes, by bands.

        Return the counts, in the order of WORK. before: a function that is called with the rows of a band (a slice)
        before that is drawn.
        """
        want = shot.want._replace(**changes) if changes else shot.want
        job = self.job(shot.numbers, planes, of_a=want.surfaces == "a")
        if want.bounds:
            with compiling:
                from renderer.shader.rounded_inputs import input_bounds  # what most pictures never need to import

            job |= input_bounds(shot, len(self._x))
        draw_rows = machine().drawer(want, job)

        def draw_band(band):
            if before:
                before(band)
            return draw_rows(band)

        counts = run_bands(draw_band, len(self.y), band_rows(*self.chambers.shape), threads)
        return [*map(sum, zip(*counts, strict=True))]

    def elsewhere(self, shot: Shot, threads: int) -> tuple[np.ndarray, list[int]]:
        """Return (the colours off A, undefined on A; the counts): drawn when a shading first needs them."""
        if self._elsewhere[0] == shot.shading:
            return self._elsewhere[1], [0] * len(WORK)
        rgb = self.new_plane(channels=3)
        planes = dict(zip(COLORS, rgb, strict=True))
        counts = self.draw(shot, threads, planes, chambers_known=True, surfaces="elsewhere")
        self._elsewhere = (shot.shading, rgb)
        return rgb, counts

    def serves(self, shot: Shot) -> bool:
        """Return whether these are the chambers of the shot."""
        return (self.geometry, self.raster) == (shot.geometry, shot.raster)

    @property
    def on_a(self) -> np.ndarray:
        """(height, width) bool: the pixels of sphere A."""
        return (self.chambers & SURFACE_BITS) == 1
