"""What `render(..., bounds=True)` certifies is so: nowhere is a colour further from 256-bit balls than its bound."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from proofs.engine.program import chain
from proofs.formulas.camera import image_extent, image_point
from proofs.formulas.symbols import x, y
from renderer import Light, Scene, central, exact, render
from renderer.machines import enclosing, numpy_rows, rounded_inputs
from renderer.machines.enclosing import Enclosed, Mask
from renderer.picture import stage
from renderer.picture.frame import Frame
from renderer.scene.raster import Raster
from verify.enclosed_pixels import KINDS, errors, measure, wrong
from verify.evaluate.arrays import distance, in_balls

enclosed_bounds, where = Frame.bounds.fget, enclosing.where


@pytest.fixture
def by_rows(monkeypatch):
    """Let NumPy draw, so that nothing is compiled: its bounds are LLVM's to the last bit (tests/test_machines.py)."""
    monkeypatch.setattr(stage, "machine", lambda: SimpleNamespace(drawer=numpy_rows.drawer))


def test_no_error_is_above_its_bound(by_rows):
    """Nor bounds that say nothing, of any kind of picture."""
    found = measure(42, 0)["numbers"]
    assert (found["above_bound"], found["chambers_missed"]) == (0, 0)
    assert found["decided"] >= 0.95 * found["pixels"]
    assert all(found[f"median_ratio_{kind}"] <= 1000 for kind in KINDS)
    assert all(found[f"open_share_{kind}"] <= 1e-3 for kind in KINDS)


def test_a_bound_that_is_too_small_is_counted(monkeypatch, by_rows):
    monkeypatch.setattr(Frame, "bounds", property(lambda frame: 1e-3 * enclosed_bounds(frame)))
    assert measure(3, first=0)["numbers"]["above_bound"] > 0


def on_creases(numbers=range(1, 25)):
    """Return frames of one pixel each, which lies within a rounding of a crease of ridges."""
    scene = Scene(ball=False)
    u = render(scene, 64, 64).surface_data["u"][20, 25]
    crop = 25, 20, 1, 1
    return [render(replace(scene, ku=float(n / u)), 64, 64, exact("general"), crop, bounds=True) for n in numbers]


def test_the_side_of_a_crease_is_open():
    frames = on_creases()
    assert all(frame.open.all() and not wrong(frame, 0, 0) for frame in frames)
    assert max(errors(frame, 0, 0)[0].max() for frame in frames) > 1e-3  # on the wrong side


@pytest.mark.parametrize("radius", [1.0, 1e40])
def test_a_floor_without_squares_is_open(radius, by_rows):
    light = Light((3 * radius, -4 * radius, 6 * radius))
    frame = render(Scene(eye=4 * radius, radius=radius, ball=False, lights=(light,)), 16, 16, bounds=True)
    lit = frame.chambers & 7 == 3
    assert lit.any() and (frame.open[lit] == (radius > 1)).all()
    assert ((frame.bounds[lit].max(axis=1) > 1e-3) == (radius > 1)).all()


def one_sided(mask, value, otherwise):
    """Return a selection that covers the side alone that was computed."""
    return where(Mask(mask.holds), value, otherwise)


@pytest.mark.parametrize("broken, name, value", [
    (enclosing, "where", one_sided),
    (Mask, "__init__", lambda self, holds, open_=None: vars(self).update(holds=holds, open=None)),
    (Enclosed, "is_zero", property(lambda number: abs(number.value) < 1.0)),
])  # fmt: skip
def test_what_coq_does_not_prove_is_noticed_where_it_is_false(broken, name, value, monkeypatch, by_rows):
    """A selection of one side, a mask taken for decided, a number for an exact 0."""
    monkeypatch.setattr(broken, name, value)
    assert any(wrong(frame, 0, 0) for frame in on_creases())


# On an axis an image point is exact, and so is the side of a crease, of the seam and of a floor square

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
