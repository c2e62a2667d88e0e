"""Parts that figures share: the chapter's scene, its rasters, and renders that several figures look at."""

from functools import cache

import numpy as np
from numpy.typing import ArrayLike

from renderer import Scene, exact, render
from renderer.intervals import rounded_up
from renderer.picture.frame import Frame
from renderer.picture.views import image_view
from renderer.scene.methods import difference
from verify.accuracy.creases import crease_point

SCENE = Scene()
SIZE = 256  # the raster of every number on the default scene
TELLING_EPS = 1e-2  # a step at which the creases are plainly wrong to the eye
FIELD_NAMES = ("sine", "ridges", "rings")
FINE = 3  # samples to a side of a pixel where a picture is for the eye; what is counted has one


@cache
def symbolic(field: str = "ridges", size: int = SIZE) -> Frame:
    """Return the exact frame of a field on the chapter's scene, with its bounds."""
    return render(Scene(field=field), size, size, exact(), bounds=True)


@cache
def numeric(field: str = "ridges", size: int = SIZE, eps: float = TELLING_EPS, bounds: bool = False) -> Frame:
    """Return the central-difference frame of a field on the chapter's scene."""
    return render(
        Scene(field=field), size, size, difference("central", eps), stage=symbolic(field, size).stage, bounds=bounds
    )


def on_picture(frame: Frame, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return image points as columns and rows of a frame, not rounded."""
    columns, rows = frame.raster.image_points(SCENE)
    step = columns[1] - columns[0]
    return (x - columns[0]) / step, (rows[0] - y) / step


def place(frame: Frame, u: ArrayLike, v: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    """Return points of A's chart as columns and rows of a frame."""
    with np.errstate(divide="ignore", invalid="ignore"):  # a selection computes both of its sides
        return on_picture(frame, *crease_point(1.0, 0.0, u, v, SCENE.eye, SCENE.radius))


def certified_numbers(frame: Frame) -> dict[str, float]:
    """Return the bounds of a frame, to two digits: their median on A, the largest; and how many pixels are open."""
    ends = {"median_on_a": np.median(frame.bounds[frame.stage.on_a]), "bound": frame.bounds.max()}
    return {name: float(rounded_up(value, 2)) for name, value in ends.items()} | {"open": np.count_nonzero(frame.open)}


def averaged(picture: np.ndarray, times: int = FINE) -> np.ndarray:
    """Return a picture of bytes, (high, wide, channels), at a `times`-th of its size: the mean of every square."""
    high, wide, channels = picture.shape
    squares = picture.reshape(high // times, times, wide // times, times, channels)
    return np.rint(squares.mean(axis=(1, 3))).astype(np.uint8)


def smooth(frame: Frame) -> np.ndarray:
    """Return the picture of a frame of FINE samples to a side of a pixel."""
    return averaged(image_view(frame))


def enlarged(picture: np.ndarray, times: int) -> np.ndarray:
    """Return a picture whose every pixel is a square of `times` pixels."""
    return picture.repeat(times, axis=0).repeat(times, axis=1)
