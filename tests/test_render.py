"""The interface of `render`: shapes, types, threads, stages, frames that serve again, what is refused."""

import gc
import math
import re
from dataclasses import replace
from fractions import Fraction
from functools import partial

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from renderer import Light, Scene, central, exact, fit, gradient_at, height_at, pixel, render, stage_of
from renderer.machines import native, numpy_rows
from renderer.picture import drawing, stage as memory, views
from renderer.picture.differences import difference_on_a, distance_on_a
from renderer.picture.stream import stream
from renderer.picture.sweep import sweep
from tests.refusals import rejection
from tests.strategies import looks, methods, rasters
from tests.test_machines import drawn_by, numpy_draws

DEFAULT, SINE = Scene(), Scene(field="sine")
PLANES = ("rgb", "chambers", "kink", "slope", "straddling")
BUMP = ("field", "ku", "kv", "beta")
SHADING = ("model", "ambient", "albedo_a", "albedo_b", "ka", "kd", "ks", "shininess", "floor_tint")


def same(one, other):
    """Return whether two frames are the same, bit for bit."""
    return all(np.array_equal(getattr(one, name), getattr(other, name)) for name in PLANES)


def with_parts(scene, parts, names):
    """Return a scene with some of the parts that are given by name."""
    values = {name: parts[name] for name in names}
    most = 1e80 * scene.radius if scene.bump == "surface" else 1e100
    return replace(scene, **values | {"beta": max(-most, min(values["beta"], most))})


@pytest.mark.parametrize("drawer", [native.drawer, numpy_rows.drawer])
@settings(max_examples=20)
@given(looks, rasters(), st.data())
def test_a_stage_and_a_frame_serve_again(drawer, scene, size, data):
    """No bump and no shading moves a boundary: the same bits as a picture that is drawn whole, chambers among them."""
    with drawn_by(drawer, 1):
        stage = stage_of(scene, *size)
        for _ in range(2):
            shaded = with_parts(scene, vars(data.draw(looks)), (*BUMP, *SHADING))
            frame = render(shaded, *size, data.draw(methods), stage=stage)
            assert same(frame, render(shaded, *size, frame.method))
            bumped, method, planes = with_parts(shaded, vars(data.draw(looks)), BUMP), data.draw(methods), frame.planes
            over = render(bumped, *size, method, stage=stage, into=frame)
            assert np.shares_memory(over.planes, planes)
            assert same(over, render(bumped, *size, method))
            for gone in (partial(render, bumped, *size, stage=stage, into=frame), lambda frame=frame: frame.rgb):
                assert "is not allowed: another frame has been drawn into it" in rejection(gone)


def test_memory_waits_for_the_next_picture_up_to_a_size_and_is_given_back():
    gc.collect()  # frames of other tests
    memory.give_back()
    places = [render(DEFAULT, 64, 48, derivatives=["beta", "kd"]).planes.ctypes.data for _ in range(2)]
    assert places[0] == places[1] and len(memory._spare) == 2
    for sizes, kept in (([27] * 5, [27] * 3), ([28, 27, 28], [28]), ([27, 30], [27]), ([29, 27], [27])):
        blocks = [memory.lent((1, 2**size // 8)) for size in sizes]  # nothing is written, so that the system gives none
        while blocks:
            del blocks[0]
        assert [block.nbytes for block in memory._spare][-len(kept) :] == [2**size for size in kept]
        memory.give_back()
    assert not memory._spare


def test_a_stage_serves_lights_of_other_colours_and_no_other_scene_raster_or_crop():
    red, off = (tuple(Light(light.position, colour) for light in DEFAULT.lights) for colour in ((1, 0, 0), None))
    coloured = replace(DEFAULT, lights=red)
    assert same(render(coloured, 16, 16, stage=stage_of(DEFAULT, 16, 16)), render(coloured, 16, 16))
    others = {"eye": 5.0}, {"ball": False}, {"ball_radius": 0.3}, {"lights": off}
    stages = [stage_of(replace(DEFAULT, **other), 16, 16) for other in others]
    for stage in (*stages, stage_of(DEFAULT, 16, 17), stage_of(DEFAULT, 16, 16, (8, 8, 4, 4))):
        assert rejection(render, DEFAULT, 16, 16, stage=stage).startswith("stage = ")
    frame = render(DEFAULT, 16, 16)
    mean = render(DEFAULT, 16, 16, samples=2)
    for scene, stage, into in (  # nor a frame of another stage or shading, nor a mean, of which the rest would stay
        (DEFAULT, None, frame),
        (Scene(ka=0.5), frame.stage, frame),
        (DEFAULT, mean.stage, mean),
    ):
        assert rejection(render, scene, 16, 16, into=into, stage=stage).startswith("into = ")


@pytest.mark.parametrize(
    "count, crop, method, by, drawer",
    [
        (2, None, exact(), ("eye", "ku"), native.drawer),
        (3, (3, 2, 7, 9), exact(), ("eye", "ku"), numpy_rows.drawer),
        (16, (11, 7, 1, 2), central(1e-3), (), native.drawer),
    ],
)
def test_a_mean_of_samples_keeps_their_bounds(count, crop, method, by, drawer, monkeypatch):
    """The mean's bound exceeds the mean of the samples' bounds by at least the mean's own rounding."""
    monkeypatch.setattr(drawing, "BAND_SAMPLES", 1)
    with drawn_by(drawer, 1):
        drawn = partial(render, SINE, gradient=method, bounds=True, derivatives=by)
        frame = drawn(17, 13, crop=crop, samples=count)
        _, _, wide, high = frame.raster.crop
        fine = drawn(17 * count, 13 * count, crop=tuple(count * n for n in frame.raster.crop))
        assert (frame.chambers == render(SINE, 17, 13, method, crop).chambers).all()
    blocks = high, count, wide, count
    assert (frame.open >= fine.open.reshape(blocks).any(axis=(1, 3))).all()
    pairs = ([(f.rgb, f.bounds), *((f.derivatives[n], f.derivative_bounds[n]) for n in by)] for f in (frame, fine))
    for one, other in zip(*pairs, strict=True):
        means = [np.vectorize(Fraction)(each.reshape(*blocks, 3)).sum(axis=(1, 3)) / count**2 for each in other]
        mean, bound = map(np.vectorize(Fraction), one)
        assert (abs(mean - means[0]) + means[1] <= bound).all() and (bound <= means[1] * (1 + 1e-9) + 1e-13).all()


@pytest.mark.parametrize(
    "field, ku, kv, algebraic",
    [
        ("ridges", 64, 64, True),
        ("ridges", -8, -3, True),
        ("ridges", 66, 4, False),
        ("ridges", 7, 4, False),
        ("ridges", 8, 2.5, False),
        ("rings", 7.3, 2.5, True),
        ("rings", 8, 2.25, False),
    ],
)
def test_which_scenes_have_an_algebraic_gradient(field, ku, kv, algebraic):
    work = render(Scene(field=field, ku=ku, kv=kv), 32, 32).work
    assert work["algebraic_gradients"] == (work["pixels_a"] if algebraic else 0)


def test_what_is_no_scene_or_no_frame_is_refused_by_all():
    at = partial(gradient_at, method=exact())
    for call in (render, stage_of, sweep, partial(pixel, column=0, row=0), height_at, at):
        assert rejection(call, "ridges", 8, 8) == "scene = 'ridges' is not allowed: a Scene"
    assert rejection(views.image_view, "picture") == "frame = 'picture' is not allowed: a Frame"


ODD = replace(DEFAULT, ku=7.5)
default = partial(render, DEFAULT, 8, 8)
SLOPED = default(derivatives=["kv"])
REFUSED = {
    "gradient = 'central' is not allowed: exact(), central(eps)": lambda: default("central"),
    "into = 'frame'": lambda: default(into="frame"),
    "bounds = 1 is not allowed: True or False": lambda: default(bounds=1),
    "frame = Frame(Raster(width=8, height=9": lambda: default() - render(DEFAULT, 8, 9),
    "derivatives = 'beta' is not allowed: a list of names of the scene's": lambda: default(derivatives="beta"),
    "derivatives = 'lights[00].position[0]' is not": lambda: default(derivatives=["lights[00].position[0]"]),
    "derivatives = 7 is not allowed: names": lambda: default(derivatives=[7]),
    "form = 'algebraic' is not allowed: general or": lambda: default(exact("algebraic"), derivatives=["ku"]),
    "direction = 'ku' is not allowed: a number of the frame's derivatives=": lambda: SLOPED.derivative({"ku": 1}),
    "assignment destination is read-only": lambda: SLOPED.derivatives["kv"].fill(0),
    "kv = 1e+200 is not allowed: a finite number from -1e+100": lambda: SLOPED.derivative({"kv": 1e200}),
    "derivatives = 'ball' is not": lambda: default(derivatives=["ball"]),
    "numbers = 'lights[5].color[0]' is not": lambda: DEFAULT.with_numbers({"lights[5].color[0]": 1}),
    "name = 'nope' is not allowed: names": lambda: DEFAULT.number("nope"),
    "names = 'nope' is not allowed: names": lambda: fit(DEFAULT, np.zeros((8, 8, 3)), ["nope"]),
    "samples = 9 is not allowed: a whole number from 1 to 8": lambda: render(DEFAULT, 2**21, 1, samples=9),
    "samples = 2 is not allowed: 1 beside a stage": lambda: default(samples=2, stage=stage_of(DEFAULT, 8, 8)),
    "samples = 2 is not allowed: 1 beside": lambda: default(samples=2, into=default()),
    "derivatives = ('beta', 'ku') is not allowed: one name": lambda: stream(
        DEFAULT, 8, 8, "a.npy", derivatives=["beta", "ku"]
    ),
    "path = None is not allowed: a file's name": lambda: default().save(None),
    "out = b'a.npy' is not allowed: a file's name": lambda: stream(DEFAULT, 8, 8, b"a.npy"),
    "steps = 0.001 is not allowed: a sequence of numbers": lambda: sweep(DEFAULT, 8, 8, 1e-3),
    "reference = None is not allowed: a Frame": lambda: difference_on_a(default(), None),
    "frame = Frame(Raster(width=8,": lambda: distance_on_a(default(), render(DEFAULT, 8, 9)),
    "form = 'algebraic' is not allowed: a field whose wave number in u": lambda: render(ODD, 8, 8, exact("algebraic")),
    "(u, v) = ('a', 0.1)": lambda: height_at(DEFAULT, "a", 0.1),
    "(u, v) = (0.5, 1.000000001) is not allowed: u and v in [0, 1]": lambda: gradient_at(
        DEFAULT, 0.5, [0.5, 1 + 1e-9], exact()
    ),
    "(u, v) = (0.5, nan)": lambda: gradient_at(DEFAULT, 0.5, math.nan, exact()),
    "method = 'exact'": lambda: gradient_at(DEFAULT, 0.1, 0.1, "exact"),
    "column = 64": lambda: pixel(DEFAULT, 64, 64, 64, 0),
    "highest = nan": lambda: views.slope_view(default(), math.nan),
    "light = 2": lambda: default().light_cosines(2),
    "light = 0 is not allowed: none, as the": lambda: render(Scene(lights=()), 8, 8).light_cosines(0),
}
"""{how it is said: what is asked for}"""


@pytest.mark.parametrize("text", REFUSED)
def test_what_is_refused(text):
    with pytest.raises(ValueError, match=f"^{re.escape(text)}"):
        REFUSED[text]()


def test_a_frame_is_of_the_scene_that_was_given():
    for scene in (Scene(beta=0.0), Scene(beta=-0.0), Scene(beta=0.0)):
        assert render(scene, 8, 8).scene is scene


@numpy_draws()
def test_a_fit_says_what_it_cannot_tell_and_what_it_is_not_given():
    frame = render(SINE, 16, 16)
    once, twice = (fit(replace(SINE, beta=0.3), frame, names) for names in (["beta"], ["beta", "beta"]))
    assert once == twice and once.scene.number("beta") == pytest.approx(SINE.beta, rel=1e-12)
    for scene, names in (
        (replace(SINE, kd=0.0, ks=0.0), ["beta"]),
        (SINE, ["ka", *(f"ambient[{n}]" for n in range(3))]),
    ):
        assert set(fit(scene, render(scene, 16, 16), names).errors.values()) == {np.inf}
    for picture in (None, "sky", frame.srgb, frame.rgb[..., 0], frame.rgb * np.nan, frame.rgb * 1e5, frame.rgb + 0j):
        assert rejection(fit, SINE, picture, ["beta"]).startswith("picture = ")
    assert [rejection(fit, SINE, frame, names)[:5] for names in ((), "beta")] == ["names", "names"]
