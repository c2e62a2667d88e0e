"""On an axis an image point is exact, and so is the side of a crease, of the seam and of a floor square."""

import numpy as np
import pytest

from proofs.engine.program import chain
from proofs.formulas.camera import image_extent, image_point
from proofs.formulas.symbols import x, y
from renderer import Scene, central, exact, render
from renderer.machines import rounded_inputs
from renderer.scene.raster import Raster
from verify.evaluate.arrays import distance, in_balls

POINT = chain("image_points", image_extent, image_point, outputs=(x, y))
RASTERS = ((61, 60, Scene()), (80, 20, Scene(eye=7.3, radius=0.1)), (33, 19, Scene(eye=1.001)))


def image_points():
    """Yield how far each coordinate of each raster's x and y is from the exact one, and its bound."""
    for width, height, scene in RASTERS:
        raster, numbers = Raster(width, height), np.arange(max(width, height))
        given = {"width": width, "height": height, "eye": scene.eye, "radius": scene.radius}
        true = in_balls(POINT, given | {"column": numbers, "row": numbers}).values()
        bounds = rounded_inputs.of_image_points(scene, raster)
        for points, balls, bound in zip(raster.image_points(scene), true, bounds, strict=True):
            yield distance(points, balls[: len(points)]), bound


def test_an_image_point_is_exact_where_it_is_0(monkeypatch):
    """The axis is 3/20 of the half-height above the middle: the third raster has no row there."""
    assert all((off <= bound).all() for off, bound in image_points())
    assert [np.count_nonzero(bound == 0) for _, bound in image_points()] == [1, 1, 0, 1, 1, 0]
    monkeypatch.setattr(rounded_inputs, "_on_grid", lambda coordinate, step: 0.0 * coordinate.bound)  # too coarse
    assert any((off > bound).any() for off, bound in image_points())


@pytest.mark.parametrize("method", [exact(), exact("general"), central(1e-3)])
def test_on_an_axis_nothing_is_open(method):
    """Of 61 × 60 pixels column 30 is x = 0, row 25 is y = 0; nor at the edge of a square, nor on the seam."""
    for place in ((40, 25), (2, 25), (20, 25), (30, 20)):
        frame = render(Scene(), 61, 60, method, (*place, 1, 1), bounds=True)
        assert not frame.open.any() and frame.bounds.max() < 1e-8
