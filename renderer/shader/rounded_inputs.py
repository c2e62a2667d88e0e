"""Bounds of the errors of the shader's inputs that are rounded: image points, A's reach, some colours."""

from functools import lru_cache
from types import SimpleNamespace

import numpy as np

from renderer.kernels import image_extent, image_x, image_y, silhouette_of_a
from renderer.machines import Job
from renderer.machines.enclosing import SLACK, UNIT, Enclosed, enclosed
from renderer.machines.forms import flat, of_form
from renderer.operations import Number, where
from renderer.shader.numbers import Shot, scene_numbers


def _lengths(scene):
    return np.float64(scene.eye), np.float64(scene.radius)


def bound_of_x(column: Number, width: Number, height: Number, eye: Number, radius: Number) -> Number:
    """Return a bound of the error of an image point's x, of a raster's column."""
    half = image_extent(Enclosed(eye), Enclosed(radius))
    return _on_grid(image_x(Enclosed(column), enclosed(width), enclosed(height), half), half.value / height)


def bound_of_y(row: Number, height: Number, eye: Number, radius: Number) -> Number:
    """Return a bound of the error of an image point's y, of a raster's row."""
    half = image_extent(Enclosed(eye), Enclosed(radius))
    return _on_grid(image_y(Enclosed(row), enclosed(height), half), half.value / (20 * height))


def of_image_points(shot: Shot) -> tuple[np.ndarray, np.ndarray]:
    """Return bounds of the errors of `Raster.image_points`: (columns,) and (rows,) float64."""
    raster, lengths = shot.raster, _lengths(shot.scene)
    left, top, wide, high = raster.crop  # type: ignore[misc]  # checked
    columns, rows = (np.arange(first, first + n, dtype=np.float64) for first, n in ((left, wide), (top, high)))
    width, height = float(raster.width), float(raster.height)
    return bound_of_x(columns, width, height, *lengths), bound_of_y(rows, height, *lengths)


def _on_grid(coordinate, step):
    """Return the bounds of coordinates that are multiples of a step: one that may be 0 alone is off by its size."""
    size = abs(coordinate.value)
    return where(size + coordinate.bound < 0.5 * step, size, coordinate.bound)


@np.errstate(all="ignore")
def of_scene(shot: Shot) -> SimpleNamespace:
    """Return bounds of the errors of the scene's numbers (`scene_numbers`) by name: 0 of the exact ones."""
    numbers = scene_numbers(shot, Enclosed)
    bounds = of_form(numbers, (float(getattr(number, "bound", 0.0)) for number in flat(numbers)))
    silhouette = silhouette_of_a(*map(Enclosed, _lengths(shot.scene)))
    square = silhouette * silhouette
    off = abs(numbers.reach_of_a - square.value)
    bounds.reach_of_a = float((square.bound + off + UNIT * off) * SLACK)
    return bounds


@lru_cache(maxsize=16)
def input_bounds(shot: Shot, wide: int) -> Job:
    """Return the bounds that a Job has: of x (wide,), 0 beyond the raster; of y (rows,); of the scene's numbers."""
    of_x, of_y = of_image_points(shot)
    of_numbers = np.array(flat(of_scene(shot)))
    bounds = {"x_bound": np.pad(of_x, (0, wide - len(of_x))), "y_bound": of_y, "scene_bounds": of_numbers}
    return bounds
