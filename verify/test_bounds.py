"""What `render(..., bounds=True)` certifies is so: nowhere is a colour further from 256-bit balls than its bound."""

import itertools
from dataclasses import replace
from operator import add, mul, truediv
from types import SimpleNamespace

import numpy as np
import pytest
from flint import arb, ctx

from proofs.engine.program import Program, chain
from proofs.formulas.camera import point_on_b
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.shading import LIGHT_MODELS
from proofs.formulas.symbols import ball_center, ball_radius, eye, normal, point, x, y
from renderer import Light, Scene, exact, kernels, operations, render
from renderer.generate.kernels import function_of
from renderer.machines import enclosing, numpy_rows
from renderer.machines.enclosing import Enclosed, Mask
from renderer.picture import stage
from renderer.picture.frame import Frame
from renderer.scene.raster import Raster
from verify.accuracy.pixels import BITS, COLORS, truth_of
from verify.enclosed_pixels import KINDS, Picture, measure
from verify.evaluate.arrays import response
from verify.evaluate.balls import BALLS

enclosed_bounds = Frame.bounds.fget


@pytest.fixture
def by_rows(monkeypatch):
    """Let NumPy draw, so that nothing is compiled: its bounds are LLVM's to the last bit (tests/test_machines.py)."""
    monkeypatch.setattr(stage, "machine", lambda: SimpleNamespace(drawer=numpy_rows.drawer))


@pytest.mark.parametrize("drawn", [(42, 0), pytest.param((840, 1000), marks=pytest.mark.long)])
def test_no_error_is_above_its_bound(drawn, by_rows):
    """Nor bounds that say nothing, of any kind of picture."""
    found = measure(*drawn)["numbers"]
    assert (found["above_bound"], found["chambers_missed"]) == (0, 0)
    assert found["decided"] >= 0.95 * found["pixels"]
    assert all(found[f"median_ratio_{kind}"] <= 1000 for kind in KINDS)
    assert all(found[f"open_share_{kind}"] <= 1e-3 for kind in KINDS)


def test_a_bound_that_is_too_small_is_counted(monkeypatch, by_rows):
    monkeypatch.setattr(Frame, "bounds", property(lambda frame: 1e-3 * enclosed_bounds(frame)))
    assert measure(3, first=0)["numbers"]["above_bound"] > 0


@pytest.mark.parametrize("field", HEIGHT_FIELDS)
@pytest.mark.parametrize("model", LIGHT_MODELS)
def test_the_default_scene(field, model):
    """Nothing is open, at 256²; the bits are those of the plain picture; bounds are tight."""
    scene = Scene(field=field, model=model)
    plain, picture = render(scene, 256, 256), Picture(scene, 256, 256, exact())
    frame, random = picture.frame, np.random.default_rng(24)
    assert (frame.rgb.tobytes(), frame.chambers.tobytes()) == (plain.rgb.tobytes(), plain.chambers.tobytes())
    assert not frame.open.any()
    assert np.median(frame.bounds[(frame.chambers & 3) == 1]) <= 1e-12
    found = [picture.errors(*place) for place in random.integers(0, 256, (200, 2)).tolist()]
    share = np.median([share for off, bounds, _ in found for share in bounds[off > 0] / off[off > 0]])
    assert share <= (300 if scene == Scene() else 1000)


def on_creases(numbers=range(1, 25)):
    """Return Pictures of one pixel each, which lies within a rounding of a crease of ridges."""
    scene = Scene(ball=False)
    u = render(scene, 64, 64).surface_data["u"][20, 25]
    crop = 25, 20, 1, 1
    return [Picture(replace(scene, ku=float(n / u)), 64, 64, exact("general"), crop) for n in numbers]


def test_the_side_of_a_crease_is_open():
    pictures = on_creases()
    assert all(picture.frame.open.all() and not picture.wrong(0, 0) for picture in pictures)
    assert max(picture.errors(0, 0)[0].max() for picture in pictures) > 1e-3  # on the wrong side


@pytest.mark.parametrize(("radius", "share"), [(1.0, 0.0), (2.0**53, 1.0), (1e40, 1.0)])
def test_a_floor_without_squares_is_open(radius, share, by_rows):
    scene = Scene(eye=4 * radius, radius=radius, ball=False, lights=(Light((3 * radius, -4 * radius, 6 * radius)),))
    frame = render(scene, 16, 16, bounds=True)
    floor = (frame.chambers & 3) == 3
    lit = floor & (frame.chambers & 4 == 0)
    assert frame.open[floor].mean() == share
    assert (frame.bounds[lit].max(axis=1) > 1e-3).all() == bool(share)


WIDE, RATIO = (-50.0, 50.0), (1e-6, 1.0)
OPERATIONS = {
    "sum": (add, add, WIDE, WIDE),
    "product": (mul, mul, WIDE, WIDE),
    "quotient": (truediv, truediv, WIDE, WIDE),
    "selected": (lambda a, b: operations.where(a > b, 1.0, -1.0), lambda a, b: arb(1 if a > b else -1), WIDE, (3, 3)),
    "both": (
        lambda a, b: operations.where((a > b) & ~(a * a <= 9.0), 1.0, -1.0),
        lambda a, b: arb(1 if a > b and a * a > 9 else -1),
        WIDE,
        (3, 3),
    ),
    "square root": (operations.sqrt, arb.sqrt, (1.0, 50.0)),
    "floor": (operations.floor, arb.floor, WIDE),
    "rint": (operations.rint, BALLS["rint"], WIDE),
    "sinpi": (kernels.sinpi, arb.sin_pi, WIDE),
    "cospi": (kernels.cospi, arb.cos_pi, WIDE),
    "atan2pi": (kernels.atan2pi, BALLS["atan2pi"], WIDE, WIDE),
    "exp": (kernels.exp, arb.exp, (-700.0, 700.0)),
    "log": (kernels.log, arb.log, (1.0, 50.0)),
    "power": (kernels.power, arb.__pow__, RATIO, (1e-3, 100.0)),
}


def escapes(name, count=2000):
    """Return how many results of an operation are further from the truth than their bounds.

    Half of them are of exact numbers, the others of numbers as far off as they may be; some are whole, or beside them.
    """
    ours, exactly, *ranges = OPERATIONS[name]
    random, escaped = np.random.default_rng(len(name)), 0
    for largest, stays_exact in itertools.product((0.0, 2.0**0.1), (False, True)):
        given, true = [], []
        for low, high in ranges:
            values = random.uniform(low, high, count)
            values = np.where(random.random(count) < 0.3, np.maximum(low, np.rint(values)), values)
            bounds = largest * np.abs(values) * 2.0 ** random.uniform(-55, 0, count)
            bounds = np.minimum(bounds, 0.99 * values) if low > 0 else bounds
            given.append(Enclosed(values, bounds if largest else 0.0, stays_exact))
            with ctx.workprec(BITS):
                signed = bounds * random.choice([-1, 1], count)
                true.append([arb(float(v)) + arb(float(b)) for v, b in zip(values, signed, strict=True)])
        with np.errstate(all="ignore"):
            result = ours(*given)
        with ctx.workprec(BITS):
            found = zip(result.value, np.broadcast_to(result.bound, count), map(exactly, *true), strict=True)
            escaped += sum(bool(abs(arb(float(v)) - t) > arb(float(b))) for v, b, t in found if np.isfinite(b))
    return escaped


@pytest.mark.parametrize("name", OPERATIONS)
def test_an_operation_stays_in_its_bounds(name):
    assert escapes(name) == 0


@pytest.mark.parametrize(("found", "at"), [(operations.floor, 3.0), (operations.rint, 2.5)])
def test_a_bound_however_small_moves_a_whole_number(found, at):
    """So few roundings are a bound that float64 takes for 0."""
    assert found(Enclosed.counted(np.float64(at), 2.0**-1074)).bound >= 1.0


def one_sided(mask, value, otherwise):
    """Return a selection that covers the side alone that was computed."""
    value, otherwise = map(enclosing.enclosed, (value, otherwise))
    chosen, bound = ((mask.holds, *pair) for pair in ((value.value, otherwise.value), (value.bound, otherwise.bound)))
    return Enclosed(operations.where(*chosen), operations.where(*bound))


def without_own_rounding(a, b):
    """Return a product whose own rounding is left out."""
    return Enclosed(a.value * b.value, abs(a.value) * b.bound + abs(b.value) * a.bound + a.bound * b.bound)


def without_second_order(a, b):
    """Return a product without the product of the bounds."""
    own = enclosing.UNIT * abs(a.value * b.value)
    return Enclosed(a.value * b.value, abs(a.value) * b.bound + abs(b.value) * a.bound + own)


def uncounted(kind, value, roundings, keeps_zero=False):
    """Return an Enclosed whose bound is halved."""
    return kind(value, 0.5 * enclosing.UNIT * roundings, keeps_zero)


@pytest.mark.parametrize(("broken", "name", "value", "operation"), [
    (Enclosed, "__mul__", without_own_rounding, "product"),
    (Enclosed, "counted", classmethod(uncounted), "quotient"),
    (enclosing, "where", one_sided, "selected"),
    (Mask, "__init__", lambda self, holds, open_=None: vars(self).update(holds=holds, open=None), "both"),
    (kernels, "ULPS", {name: ulps / 2 for name, ulps in kernels.ULPS.items()}, "exp"),
    (Enclosed, "__mul__", without_second_order, "product"),
    (Enclosed, "is_zero", property(lambda number: abs(number.value) < 1.0), "atan2pi"),
])  # fmt: skip
def test_a_false_bound_is_noticed(broken, name, value, operation, monkeypatch):
    """A rounding left out, a selection of one side, a mask taken for decided, constants halved, no second order."""
    monkeypatch.setattr(broken, name, value)
    assert escapes(operation) > 0


def test_a_picture_of_false_bounds_is_noticed(monkeypatch, by_rows):
    monkeypatch.setattr(enclosing, "where", one_sided)
    assert any(picture.wrong(0, 0) for picture in on_creases())


def worst_on_b():
    """Return the largest error of a pixel on B in units of the response, over ratios and sizes of B."""
    return max(error_on_b(*lengths) for lengths in itertools.product((0.25, 1e-2, 1e-4, 1e-6), (0.32, 1e-4, 1e-8)))


def error_on_b(ratio, size):
    """Return the error of a pixel on B by what 64 shakes of all inputs by 1e-16 move it, or its own rounding."""
    scene = Scene(eye=1 / ratio, ball=False)
    (left,), (top,) = Raster(64, 64, (30, 20, 1, 1)).image_points(scene)
    along = 1.3 * ratio  # how far from the image point to the eye
    center = (1 - along) * left + 0.4 * size, (1 - along) * top + 0.3 * size, 1.3
    scene = replace(scene, ball=True, ball_center=center, ball_radius=size)
    picture = Picture(scene, 64, 64, exact(), (30, 20, 1, 1))
    assert picture.frame.chambers[0, 0] & 3 == 2
    off, bounds, _ = picture.errors(0, 0)
    assert (off <= bounds).all()
    true = truth_of(picture.frame, 0, 0)

    def change(shaken):
        moved = truth_of(picture.frame, 0, 0, shaken)
        return max(float(abs(moved[name] - true[name])) for name in COLORS)

    return off.max() / response(picture.frame.rgb.max(), change)


def test_b_is_as_accurate_as_its_condition():
    assert worst_on_b() <= 30


def cancelling_normal_of_b():
    """Return the program of P and N of B by P − C of the hit, which is what was there."""
    from_hit = tuple(p - c for p, c in zip(point, ball_center, strict=True))
    outward = tuple((n, d / ball_radius) for n, d in zip(normal, from_hit, strict=True))
    lines = Program("outward", (point, ball_center, ball_radius), outward, normal)
    return chain("normal_of_b", point_on_b, lines, outputs=(*point, *normal))


def test_a_normal_that_cancels_is_noticed(monkeypatch, by_rows):
    cancelling = cancelling_normal_of_b()
    function, names = function_of(cancelling), [s.name for s in cancelling.inputs]
    wanted = [s.name for s in (x, y, eye, *ball_center, ball_radius)]
    on = {"ball_on": enclosing.enclosed(1.0)}

    def old(*arguments):
        given = dict(zip(wanted, arguments, strict=True)) | on
        return function(*(given[name] for name in names))

    monkeypatch.setattr(kernels, "normal_of_b", old)
    assert worst_on_b() > 30
