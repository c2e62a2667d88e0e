"""Pictures larger than memory: drawn in bands of rows, each written to the file before the next is drawn."""

from collections.abc import Callable, Iterable
from pathlib import Path

from renderer.checks import check_items, not_allowed
from renderer.files.pictures import write_npy
from renderer.picture.drawing import render
from renderer.scene.methods import GradientMethod
from renderer.scene.raster import Crop, Raster
from renderer.scene.scene import NUMBERS, Scene
from renderer.whole_files import checked_target

BAND_PIXELS = 2**20  # a band's planes and their copy for the file: about 60 MB


def stream(
    scene: Scene,
    width: int,
    height: int,
    path: str | Path,
    gradient: GradientMethod | None = None,
    crop: Crop | None = None,
    threads: int | None = None,
    samples: int = 1,
    derivatives: Iterable[str] = (),
    progress: Callable[[list], Iterable] = iter,
) -> tuple[int, int]:
    """Draw `scene` on a raster of width × height pixels into a `.npy`, with a band of its rows in memory at a time.

    scene, …, samples: as for `render`, whose limit on the number of pixels holds for one row. derivatives: one name, by
    which slopes are written, and no colours. progress: wraps the list of the bands' first rows. The file has the
    numbers of `render`, (height, width, 3) float64: numpy.load(path, mmap_mode="r") opens it. It appears whole or not
    at all.

    Returns the picture's (rows, columns). Raises ValueError on what is not allowed, OSError if the file cannot be
    written.
    """
    path = checked_target(path, (".npy",))
    raster = Raster(width, height, crop)
    left, top, columns, rows = raster.crop  # type: ignore[misc]  # checked by Raster
    band, by = max(1, BAND_PIXELS // columns), check_items("derivatives", derivatives, NUMBERS)
    if len(by) > 1:
        raise not_allowed("derivatives", by, "one name: a .npy holds one picture, and a frame's .npz each of several")

    def drawn(first):
        part = left, top + first, columns, min(band, rows - first)
        frame = render(scene, width, height, gradient, part, threads, derivatives=by, samples=samples)
        return frame.derivatives[by[0]] if by else frame.rgb

    write_npy(path, raster.shape, map(drawn, progress([*range(0, rows, band)])))
    return raster.shape
