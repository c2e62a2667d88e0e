"""Pictures larger than memory: drawn block by block, each written to the file before the next is drawn."""

from collections.abc import Callable, Iterable
from itertools import zip_longest
from pathlib import Path

from renderer.checks import check_kind, not_allowed
from renderer.files.pictures import STREAM_SUFFIXES, TILE, write_npy, write_tiff
from renderer.picture import views
from renderer.picture.drawing import render
from renderer.scene.methods import GradientMethod
from renderer.scene.raster import Crop, Raster
from renderer.scene.scene import Scene
from renderer.whole_files import checked_target

BLOCK_PIXELS = 2**20  # a block's planes and their copy for the file: about 60 MB


def blocks(crop: Crop, rows: int) -> list[Crop]:
    """Return the crops (left, top, width, height) that make up `crop`: `rows` rows each, whole if they have at most
    BLOCK_PIXELS pixels, else cut at multiples of TILE columns; from left to right, then downwards."""
    left, top, width, height = crop
    wide = width if rows * width <= BLOCK_PIXELS else max(TILE, BLOCK_PIXELS // rows // TILE * TILE)
    return [
        (left + x, top + y, min(wide, width - x), min(rows, height - y))
        for y in range(0, height, rows)
        for x in range(0, width, wide)
    ]


def stream(
    scene: Scene,
    width: int,
    height: int,
    path: str | Path,
    gradient: GradientMethod | None = None,
    crop: Crop | None = None,
    threads: int | None = None,
    progress: Callable[[list], Iterable] = iter,
) -> tuple[int, int]:
    """Draw `scene` on a raster of width × height pixels into a file, in memory that does not depend on its size.

    scene, width, height, gradient, crop, threads: as for `render`, without its limit on the number of pixels.
    path: what its suffix says. `.npy`: (height, width, 3) float64, linear light, the very numbers of `render`; open
    it with numpy.load(path, mmap_mode="r"). `.tif`, `.tiff`: the picture for the eye, a BigTIFF of deflated tiles of
    256 × 256 pixels, (height, width, 3) sRGB bytes, the very bytes of a PNG (viewers that page through big pictures
    expect these; linear light belongs in the .npy). progress: wraps the list of blocks to draw.

    The file appears whole or not at all. Raises ValueError on what is not allowed, OSError if the file cannot be
    written, ModuleNotFoundError where a TIFF is wanted without the extra `tiff`. Returns the picture's (rows, columns).
    """
    path = checked_target(path, STREAM_SUFFIXES)
    check_kind("progress", progress, Callable, "a function of a list")  # type: ignore[type-abstract,arg-type]
    raster = Raster(width, height, crop)

    def frames(rows):
        wanted = blocks(raster.crop, rows)
        for block, its in zip_longest(progress(wanted) or (), wanted):
            if block != its:
                raise not_allowed("progress", progress, "a function that hands every block of a list on")
            yield render(scene, width, height, gradient, block, threads)

    if path.suffix.lower() == ".npy":
        write_npy(path, raster.shape, (frame.rgb for frame in frames(max(1, BLOCK_PIXELS // raster.shape[1]))))
    else:
        write_tiff(path, raster.shape, map(views.image_view, frames(TILE)))
    return raster.shape
