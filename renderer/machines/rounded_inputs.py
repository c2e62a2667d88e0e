"""What is rounded before the shader begins, and how far off it is: image points, A's reach, some colours."""

from functools import lru_cache
from itertools import repeat
from types import SimpleNamespace

import numpy as np

from renderer.kernels import ambient_term, floor_albedo, image_extent, image_x, image_y, silhouette_of_a
from renderer.machines.enclosing import SLACK, UNIT, Enclosed, enclosed
from renderer.operations import Number, where
from renderer.scene.methods import exact
from renderer.scene.raster import Raster
from renderer.scene.scene import Scene
from renderer.shader.numbers import flat, of_form, read_only, scene_numbers


def _lengths(scene):
    return np.float64(scene.eye), np.float64(scene.radius)


def bound_of_x(column: Number, width: Number, height: Number, eye: Number, radius: Number) -> Number:
    """Return a bound of the error of an image point's x, of a raster's column."""
    half = image_extent(Enclosed(eye), Enclosed(radius))
    return _on_grid(image_x(Enclosed(column), enclosed(width), enclosed(height), half), half.value / height)


def bound_of_y(row: Number, height: Number, eye: Number, radius: Number) -> Number:
    """Return the same of its y."""
    half = image_extent(Enclosed(eye), Enclosed(radius))
    return _on_grid(image_y(Enclosed(row), enclosed(height), half), half.value / (20 * height))


def of_image_points(scene: Scene, raster: Raster) -> tuple[np.ndarray, np.ndarray]:
    """Return bounds of the errors of `Raster.image_points`: (columns,) and (rows,) float64."""
    left, top, wide, high = raster.crop  # type: ignore[misc]  # checked
    columns, rows = (np.arange(first, first + n, dtype=np.float64) for first, n in ((left, wide), (top, high)))
    width, height = float(raster.width), float(raster.height)
    return bound_of_x(columns, width, height, *_lengths(scene)), bound_of_y(rows, height, *_lengths(scene))


def _on_grid(coordinate, step):
    """Return the bounds of coordinates that are whole multiples of a step: next to 0 none is but 0 itself."""
    size = abs(coordinate.value)
    return where(size + coordinate.bound < 0.5 * step, size, coordinate.bound)


@np.errstate(all="ignore")
def of_scene(scene: Scene, numbers: SimpleNamespace) -> SimpleNamespace:
    """Return bounds of the errors of the scene's numbers (`scene_numbers`) by name: 0 of what is exact."""
    silhouette = silhouette_of_a(*map(Enclosed, _lengths(scene)))
    square = silhouette * silhouette
    off = abs(numbers.reach_of_a - square.value)
    floors = (floor_albedo(Enclosed(np.float64(dark)), Enclosed(np.float64(scene.floor_tint))) for dark in (0.0, 1.0))
    light, dark = (tuple(float(part.bound) for part in floor) for floor in floors)
    own = {
        "reach_of_a": float((square.bound + off + UNIT * off) * SLACK),
        "ambient": tuple(float(ambient_term(Enclosed(scene.ka), channel).bound) for channel in scene.ambient),
        "floor_light": light,
        "floor_dark": dark,
    }
    return SimpleNamespace(**vars(of_form(numbers, repeat(0.0))) | own)


@lru_cache(maxsize=16)
def input_bounds(scene: Scene, raster: Raster, wide: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return a Job's `bounds`: of x, (wide,) with 0 beyond the raster, of y, and of the scene's numbers."""
    of_x, of_y = of_image_points(scene, raster)
    padded = np.zeros(wide)
    padded[: len(of_x)] = of_x
    of_numbers = np.array(flat(of_scene(scene, scene_numbers(scene, exact()))))
    read_only(padded, of_y, of_numbers)
    return padded, of_y, of_numbers
