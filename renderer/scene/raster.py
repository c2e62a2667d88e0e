"""The raster: its size, the part of it that is drawn, and the image point of every pixel."""

from dataclasses import dataclass

import numpy as np

from renderer.checks import check_items, check_whole, not_allowed
from renderer.kernels import image_extent, image_x, image_y
from renderer.scene.scene import Geometry, Scene

MAX_SIDE = 2**24
Crop = tuple[int, int, int, int]
"""(left, top, width, height) of a part of a raster."""


@dataclass(frozen=True)
class Raster:
    """A raster of width × height pixels, of which the crop (left, top, width, height) is drawn; None is all of it.

    Raises ValueError on a side outside 1 … 2**24, a crop not inside the raster.
    """

    width: int
    height: int
    crop: tuple | None = None

    def __post_init__(self):
        width = check_whole("width", self.width, MAX_SIDE)
        height = check_whole("height", self.height, MAX_SIDE)
        object.__setattr__(self, "width", width)
        object.__setattr__(self, "height", height)
        object.__setattr__(self, "crop", self._checked_crop(width, height))

    def _checked_crop(self, width, height):
        if self.crop is None:
            return (0, 0, width, height)
        allowed = f"(left, top, width, height), whole numbers, inside the raster of {width} x {height}"
        try:
            left, top, wide, high = crop = tuple(
                check_whole("crop", number, MAX_SIDE, low=0) for number in check_items("crop", self.crop, allowed)
            )
            if left < left + wide <= width and top < top + high <= height:
                return crop
        except (TypeError, ValueError):
            pass
        raise not_allowed("crop", self.crop, allowed)

    @property
    def shape(self) -> tuple[int, int]:
        """(rows, columns) that are drawn."""
        return (self.crop[3], self.crop[2])  # type: ignore[index]  # checked above

    def image_points(self, scene: Scene | Geometry) -> tuple[np.ndarray, np.ndarray]:
        """Return (x of each drawn column, y of each drawn row): image points of the centres."""
        left, top, wide, high = self.crop  # type: ignore[misc]  # checked above
        half = image_extent(scene.eye, scene.radius)
        columns, rows = np.arange(left, left + wide, dtype=np.float64), np.arange(top, top + high, dtype=np.float64)
        return image_x(columns, float(self.width), float(self.height), half), image_y(rows, float(self.height), half)
