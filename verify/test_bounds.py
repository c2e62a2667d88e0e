"""Bounds that `render(..., bounds=True)` certifies: nowhere is a colour further from 256-bit balls than its bound."""

import itertools
from dataclasses import replace
from operator import mul, truediv

import numpy as np
import pytest
from flint import arb, ctx

from proofs.engine.program import chain
from proofs.formulas.camera import image_extent, image_point
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.shading import LIGHT_MODELS
from proofs.formulas.symbols import x, y
from renderer import Light, Scene, central, exact, kernels, operations, render
from renderer.machines import enclosing
from renderer.machines.enclosing import Enclosed
from renderer.scene.raster import Raster
from renderer.shader import rounded_inputs
from renderer.shader.numbers import Shot
from verify.coq.recorded_pixel import PIXELS, SLOPES, SLOPES_OFF, SPREAD, scene_ranges
from verify.enclosed_pixels import BITS, KINDS, RANGE_BOUND, errors, measure, pixels_in_range, truth_of, wrong
from verify.evaluate.arrays import distance, in_balls
from verify.evaluate.balls import BALLS

pytestmark = pytest.mark.usefixtures("by_numpy")


@pytest.mark.parametrize("drawn", [(42, 0), pytest.param((840, 1000), marks=pytest.mark.long)])
def test_no_error_is_above_its_bound(drawn):
    """Of any kind of picture; and the median bound is not above 1,000 errors."""
    numbers = measure(*drawn)["numbers"]
    assert (numbers["above_bound"], numbers["chambers_missed"]) == (0, 0)
    assert numbers["decided"] >= 0.95 * numbers["pixels"]
    assert all(numbers[f"median_ratio_{kind}"] <= 1000 for kind in KINDS)
    assert all(numbers[f"open_share_{kind}"] <= 1e-3 for kind in KINDS)


@pytest.mark.parametrize("scene", [
    *(Scene(field=field, model=model) for model in LIGHT_MODELS for field in HEIGHT_FIELDS),
    Scene(bump="surface"),
    Scene(bump="surface", field="sine", model="blinn_gated", shininess=1.0, horizon=True),
])  # fmt: skip
def test_the_default_scene(scene):
    """At 256² nothing is open, and bounds are tight; so too with the surface's bump, and with the horizon."""
    frame, random = render(scene, 256, 256, bounds=True), np.random.default_rng(24)
    assert not frame.open.any()
    assert np.median(frame.bounds[(frame.chambers & 3) == 1]) <= 1e-12
    pixels = [errors(frame, *place) for place in random.integers(0, 256, (200, 2)).tolist()]
    share = np.median([share for off, bounds, _ in pixels for share in bounds[off > 0] / off[off > 0]])
    assert share <= (300 if scene == Scene() else 1000)


def test_the_ten_pixels_of_coq_are_in_ten_chambers_and_within_their_bound():
    frame = render(Scene(), 256, 256, bounds=True)
    codes, spread = ({frame.chambers[row, column] for column, row in places} for places in (PIXELS, SPREAD))
    assert len(codes & spread) == 10
    assert max(errors(frame, *place)[0].max() for place in PIXELS) <= 18e-14


def test_the_range_of_coq_holds_its_scenes():
    """Their numbers and slopes lie in the ranges that are printed for Coq, and their colours within its bound."""
    low, high, off = np.transpose(scene_ranges()[1])
    for frame in pixels_in_range(1):
        numbers = np.concatenate([*map(np.ravel, frame.shot.numbers)])
        bounds = rounded_inputs.input_bounds(frame.shot, 256)["scene_bounds"]
        inside = (low <= numbers) & (numbers <= high) | np.isinf(numbers)
        assert {*np.flatnonzero(~inside)} <= {30, 31}  # powers of the algebraic form, which slopes do without
        assert (bounds <= off[: bounds.size]).all()
        assert errors(frame, 0, 0)[0].max() <= RANGE_BOUND
        truth = truth_of(frame, 0, 0)
        assert not any(abs(truth[name] - frame.surface_data[name].item()) > SLOPES_OFF for name in SLOPES)  # off A none


def on_creases():
    """Return frames of one pixel each, which lies within a rounding of a crease of ridges."""
    scene = Scene(ball=False)
    u = render(scene, 64, 64).surface_data["u"][20, 25]
    crop = 25, 20, 1, 1
    return [render(replace(scene, ku=float(n / u)), 64, 64, exact("general"), crop, bounds=True) for n in range(1, 25)]


def test_the_side_of_a_crease_is_open():
    frames = on_creases()
    assert all(frame.open.all() and not wrong(frame, 0, 0) for frame in frames)
    assert max(errors(frame, 0, 0)[0].max() for frame in frames) > 1e-3  # on the wrong side


@pytest.mark.parametrize("radius", [1.0, 2.0**53, 1e40])
def test_a_floor_without_squares_is_open(radius):
    light = Light((3 * radius, -4 * radius, 6 * radius))
    frame = render(Scene(eye=4 * radius, radius=radius, ball=False, lights=(light,)), 16, 16, bounds=True)
    lit = frame.chambers & 7 == 3
    assert lit.any() and (frame.open[lit] == (radius > 1)).all()
    assert ((frame.bounds[lit].max(axis=1) > 1e-3) == (radius > 1)).all()


WIDE = (-50.0, 50.0)
OPERATIONS = {
    "product": (mul, mul, WIDE, WIDE),
    "quotient": (truediv, truediv, WIDE, WIDE),
    "selection": (
        lambda a, b: operations.where((a > b) & ~(a * a <= 9.0), 1.0, -1.0),
        lambda a, b: arb(1 if a > b and a * a > 9 else -1),
        WIDE,
        (3, 3),
    ),
    "sinpi": (kernels.sinpi, arb.sin_pi, WIDE),
    "cospi": (kernels.cospi, arb.cos_pi, WIDE),
    "atan2pi": (kernels.atan2pi, BALLS["atan2pi"], WIDE, WIDE),
    "exp": (kernels.exp, arb.exp, (-700.0, 700.0)),
    "log": (kernels.log, arb.log, (1.0, 50.0)),
    "power": (kernels.power, arb.__pow__, (1e-6, 1.0), (1e-3, 100.0)),
}
"""{operation: (ours, that of balls, the ranges of its operands)}"""


@pytest.mark.parametrize("name", OPERATIONS)
def test_an_operation_stays_in_its_bounds(name):
    """Half of the numbers are exact, the others as far off as they may be; some are whole, or beside whole ones."""
    ours, exactly, *ranges = OPERATIONS[name]
    random, count = np.random.default_rng(len(name)), 2000
    for largest, stays_exact in itertools.product((0.0, 2.0**0.1), (False, True)):
        operands, true = [], []
        for low, high in ranges:
            values = random.uniform(low, high, count)
            values = np.where(random.random(count) < 0.3, np.maximum(low, np.rint(values)), values)
            bounds = largest * np.abs(values) * 2.0 ** random.uniform(-55, 0, count)
            bounds = np.minimum(bounds, 0.99 * values) if low > 0 else bounds
            operands.append(Enclosed(values, bounds if largest else 0.0, stays_exact))
            with ctx.workprec(BITS):
                signed = bounds * random.choice([-1, 1], count)
                true.append([arb(float(v)) + arb(float(b)) for v, b in zip(values, signed, strict=True)])
        with np.errstate(all="ignore"):
            result = ours(*operands)
        with ctx.workprec(BITS):
            results = zip(result.value, np.broadcast_to(result.bound, count), map(exactly, *true), strict=True)
            assert not any(abs(arb(float(v)) - t) > arb(float(b)) for v, b, t in results if np.isfinite(b))


def test_a_half_that_is_rounded_up_to_a_normal_number_is_not_exact():
    number = Enclosed(np.nextafter([2.0**-1021], 0.0), stays_exact=True) * 0.5
    assert number.value == enclosing.LEAST_NORMAL
    assert number.bound > 0.0


def test_b_is_as_accurate_as_its_condition():
    """B as small and as far away as allowed: changing all inputs by 1e-16 of themselves moves its colour by 1.2e-8."""
    crop = 30, 20, 1, 1
    (left,), (top,) = Raster(64, 64, crop).image_points(Scene(eye=1e6, ball=False))
    center = left * (1 - 1.3e-6) + 4e-9, top * (1 - 1.3e-6) + 3e-9, 1.3
    frame = render(Scene(eye=1e6, ball_center=center, ball_radius=1e-8), 64, 64, crop=crop, bounds=True)
    assert frame.chambers[0, 0] & 3 == 2 and frame.bounds.max() <= 30 * 1.2e-8


# On an axis an image point is exact, and so is the side of a crease, of the seam and of a floor square

POINT = chain("image_points", image_extent, image_point, outputs=(x, y))
RASTERS = ((61, 60, Scene()), (80, 20, Scene(eye=7.3, radius=0.1)), (33, 19, Scene(eye=1.001)))


def image_points():
    """Yield how far each coordinate of each raster's x and y is from the exact one, and its bound."""
    for width, height, scene in RASTERS:
        raster, numbers = Raster(width, height), np.arange(max(width, height))
        sizes = {"width": width, "height": height, "eye": scene.eye, "radius": scene.radius}
        true = in_balls(POINT, sizes | {"column": numbers, "row": numbers}).values()
        bounds = rounded_inputs.of_image_points(Shot(scene, raster=raster))
        for points, balls, bound in zip(raster.image_points(scene), true, bounds, strict=True):
            yield distance(points, balls[: len(points)]), bound


def test_an_image_point_is_exact_where_it_is_0():
    """The axis is 3/20 of the half-height above the middle: the third raster has no row there."""
    assert all((off <= bound).all() for off, bound in image_points())
    assert [np.count_nonzero(bound == 0) for _, bound in image_points()] == [1, 1, 0, 1, 1, 0]


@pytest.mark.parametrize("method", [exact(), exact("general"), central(1e-3)])
def test_on_an_axis_nothing_is_open(method):
    """Leave no pixel of column 30, x = 0, or row 25, y = 0, open: neither at the edge of a square nor on the seam."""
    for place in ((40, 25), (2, 25), (20, 25), (30, 20)):
        frame = render(Scene(), 61, 60, method, (*place, 1, 1), bounds=True)
        assert not frame.open.any() and frame.bounds.max() < 1e-8
