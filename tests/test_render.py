"""The interface of `render`: shapes, types, crops, threads, stages, lights that are off, the count of the work."""

from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from renderer import Light, Scene, central, exact, gradient_at, height_at, pixel, render, stage_of
from renderer.kernels import FIELDS
from renderer.picture import views
from renderer.picture.stage import band_rows
from renderer.picture.sweep import sweep
from tests.strategies import looks, methods, rasters

DEFAULT = Scene()
PLANES = ("rgb", "chambers", "kink", "slope", "straddling")


def same(one, other):
    """Whether two frames are the same, bit for bit."""
    return all(np.array_equal(getattr(one, name), getattr(other, name)) for name in PLANES)


def test_shapes_and_types():
    frame = render(DEFAULT, 30, 20)
    assert (frame.rgb.shape, frame.rgb.dtype) == ((20, 30, 3), "float64")
    for name, dtype in (("chambers", "uint8"), ("kink", "bool"), ("slope", "float64")):
        plane = getattr(frame, name)
        assert (plane.shape, plane.dtype) == ((20, 30), dtype)


def test_without_lights_there_is_ambient_light_alone():
    frame = render(replace(DEFAULT, lights=()), 32, 32)
    np.testing.assert_array_equal(frame.rgb, np.broadcast_to([0.1 * 0.15, 0.1 * 0.15, 0.1 * 0.16], (32, 32, 3)))


@pytest.mark.parametrize("field", FIELDS)
def test_kink_and_slope_are_off_outside_a(field):
    frame = render(replace(DEFAULT, field=field), 64, 64)
    off = frame.chambers & 3 != 1
    assert not frame.kink[off].any()
    assert not frame.slope[off].any()
    assert frame.slope[~off].any()


@given(looks, rasters(40), methods, st.data())
def test_a_crop_equals_the_part_of_the_whole(scene, size, method, data):
    left, top = (data.draw(st.integers(0, side - 1)) for side in size)
    width, height = data.draw(st.integers(1, size[0] - left)), data.draw(st.integers(1, size[1] - top))
    part = render(scene, *size, method, crop=(left, top, width, height))
    whole = render(scene, *size, method)
    for name in PLANES:
        expected = getattr(whole, name)[top : top + height, left : left + width]
        np.testing.assert_array_equal(getattr(part, name), expected)


@pytest.mark.parametrize("method", [exact(), central(1e-3)])
def test_one_thread_and_two_give_the_same_bits(method):
    assert 2 * band_rows(200, 300) < 200
    assert same(render(DEFAULT, 300, 200, method, threads=1), render(DEFAULT, 300, 200, method, threads=2))


@settings(max_examples=40)
@given(looks, rasters(), st.data())
def test_a_stage_used_again_gives_the_same_bits(scene, size, data):
    stage = stage_of(scene, *size)
    for _ in range(2):
        names = ("model", "field", "ku", "kv", "beta", "kd", "shininess")
        other = data.draw(looks)
        shaded = replace(scene, **{name: getattr(other, name) for name in names})
        method = data.draw(methods)
        assert same(render(shaded, *size, method, stage=stage), render(shaded, *size, method))


@pytest.mark.parametrize(
    "other",
    [
        {"eye": 5.0},
        {"radius": 0.9},
        {"ball": False},
        {"floor": False},
        {"ball_center": (0.5, 0.5, 1.4)},
        {"lights": DEFAULT.lights[::-1]},
        {"lights": (Light((5, 5, 10), None), DEFAULT.lights[1])},
    ],
)
def test_a_stage_of_another_scene_is_rejected(other):
    stage = stage_of(replace(DEFAULT, **other), 16, 16)
    with pytest.raises(ValueError, match=r"stage = .* is not allowed: one made for the same lengths"):
        render(DEFAULT, 16, 16, stage=stage)


@pytest.mark.parametrize(
    ("size", "crop"), [((16, 17), None), ((20, 20), (0, 0, 16, 16)), ((16, 16), (0, 0, 8, 8)), ((16, 16), (8, 8, 4, 4))]
)
def test_a_stage_of_another_raster_or_crop_is_rejected(size, crop):
    stage = stage_of(DEFAULT, *size, crop=crop)
    for own in (None, (0, 0, 4, 4)):
        with pytest.raises(ValueError, match=r"stage = .* is not allowed"):
            render(DEFAULT, 16, 16, crop=own, stage=stage)


@settings(max_examples=40)
@given(looks, rasters(), st.data())
def test_drawing_into_an_earlier_frame_gives_the_same_bits(scene, size, data):
    stage = stage_of(scene, *size)
    frame = render(scene, *size, data.draw(methods), stage=stage)
    for _ in range(2):
        other, method = data.draw(looks), data.draw(methods)
        bumped = replace(scene, field=other.field, ku=other.ku, kv=other.kv, beta=other.beta)
        planes = frame.planes
        earlier, frame = frame, render(bumped, *size, method, stage=stage, into=frame)
        assert np.shares_memory(frame.planes, planes)
        with pytest.raises(ValueError, match=r"into = .* is not allowed: another frame has been drawn into it"):
            render(bumped, *size, method, stage=stage, into=earlier)
        assert same(frame, render(bumped, *size, method))


def test_a_frame_of_another_stage_or_shading_is_not_drawn_into():
    stage, frame = stage_of(DEFAULT, 16, 16), render(DEFAULT, 16, 16)
    brighter = replace(DEFAULT, ka=0.5)
    with pytest.raises(ValueError, match=r"into = 'frame' is not allowed: a frame"):
        render(DEFAULT, 16, 16, stage=stage, into="frame")
    for scene, more in ((DEFAULT, {}), (DEFAULT, {"stage": stage}), (brighter, {"stage": frame.stage})):
        with pytest.raises(ValueError, match=r"into = .* is not allowed: a frame of the stage"):
            render(scene, 16, 16, into=frame, **more)


def test_lights_may_change_colour_under_a_stage():
    red = replace(DEFAULT, lights=tuple(Light(light.position, (1, 0, 0)) for light in DEFAULT.lights))
    assert same(render(red, 32, 32, stage=stage_of(DEFAULT, 32, 32)), render(red, 32, 32))


@given(looks, rasters(), st.data())
def test_a_light_that_is_off_is_as_good_as_absent(scene, size, data):
    number = data.draw(st.integers(0, min(4, len(scene.lights))))
    off = Light((50 * scene.radius, 0.0, 50 * scene.radius), None)
    lights = scene.lights[:4]
    without = render(replace(scene, lights=lights), *size)
    with_it = render(replace(scene, lights=(*lights[:number], off, *lights[number:])), *size)
    np.testing.assert_array_equal(with_it.rgb, without.rgb)
    low = (1 << (2 + number)) - 1  # the bits below the light's; those above are moved up by one
    shadows, kept = without.chambers & 0x7C, without.chambers & 0x83
    moved = (shadows & low) | ((shadows & ~np.uint8(low)) << 1)
    np.testing.assert_array_equal(with_it.chambers, kept | moved)


@pytest.mark.parametrize(
    ("fields", "algebraic"),
    [
        ({}, True),
        ({"ku": 64.0, "kv": 64.0}, True),
        ({"ku": -8.0, "kv": -3.0}, True),
        ({"ku": 0.0, "kv": 0.0}, True),
        ({"ku": 66.0}, False),
        ({"kv": 65.0}, False),
        ({"ku": 7.0}, False),
        ({"kv": 2.5}, False),
        ({"field": "rings", "ku": 7.3, "kv": 2.5}, True),
        ({"field": "rings", "kv": 2.25}, False),
        ({"field": "rings", "kv": 33.0}, False),
    ],
)
def test_which_scenes_have_an_algebraic_gradient(fields, algebraic):
    work = render(replace(DEFAULT, **fields), 32, 32).work
    assert work["algebraic_gradients"] == (work["pixels_a"] if algebraic else 0)


@pytest.mark.parametrize(
    "call", [render, stage_of, sweep, partial(pixel, column=0, row=0), height_at, partial(gradient_at, method=exact())]
)
def test_what_is_no_scene_is_refused_by_all(call):
    with pytest.raises(ValueError, match="scene = 'ridges' is not allowed: a Scene"):
        call("ridges", 8, 8)


@pytest.mark.parametrize("view", [views.image_view, views.slope_view, views.kink_view])
def test_what_is_no_frame_is_refused_by_all(view):
    with pytest.raises(ValueError, match="frame = 'picture' is not allowed: a Frame"):
        view("picture")


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: render(DEFAULT, 2**20, 2**20), f"height = {2**40} is not allowed: at most {2**28} drawn pixels"),
        (lambda: render(DEFAULT, 8, 8, "central"), r"gradient = 'central' is not allowed: exact\(\), central\(eps\)"),
        (lambda: render(DEFAULT, 8, 8, threads=257), "threads = 257 is not allowed: a whole number from 1 to 256"),
        (
            lambda: render(replace(DEFAULT, ku=7), 8, 8, exact("algebraic")),
            "form = 'algebraic' is not allowed for field 'ridges' with ku = 7, kv = 4",
        ),
        (lambda: render(DEFAULT, 8, 8, stage="stage"), "stage = 'stage' is not allowed: one made for"),
        (lambda: render(DEFAULT, 8, 8, bounds=1), "bounds = 1 is not allowed: True or False"),
        (lambda: height_at(DEFAULT, "a", 0.1), r"\(u, v\) = \('a', 0.1\) is not allowed: numbers, or arrays of shapes"),
        (
            lambda: height_at(DEFAULT, [0.1] * 2, [0.1] * 3),
            r"\(u, v\) = .* is not allowed: numbers, or arrays of shapes",
        ),
        (
            lambda: gradient_at(DEFAULT, 0.1, 0.1, "exact"),
            r"method = 'exact' is not allowed: exact\(\), central\(eps\)",
        ),
        (
            lambda: gradient_at(replace(DEFAULT, ku=7.5), 0.1, 0.1, exact("algebraic")),
            "form = 'algebraic' is not allowed for field 'ridges' with ku = 7.5, kv = 4",
        ),
        (lambda: render(DEFAULT, 8, 8).light_cosines(-1), "light = -1 is not allowed: a whole number from 0 to 1"),
        (lambda: render(DEFAULT, 8, 8).light_cosines(2), "light = 2 is not allowed: a whole number from 0 to 1"),
        (lambda: render(replace(DEFAULT, lights=()), 8, 8).light_cosines(0), "light = 0 is not allowed: none, as the"),
    ],
)
def test_what_is_refused(call, message):
    with pytest.raises(ValueError, match=message):
        call()


@pytest.mark.parametrize("name", ["rgb", "planes"])
def test_a_frame_that_is_handed_over_says_so(name):
    frame = render(DEFAULT, 8, 8)
    render(DEFAULT, 8, 8, stage=frame.stage, into=frame)
    with pytest.raises(ValueError, match=r"frame = .* is not allowed: another frame has been drawn into it"):
        getattr(frame, name)


def test_a_tall_raster_shows_the_middle_of_a_wide_one():
    wide, tall = render(DEFAULT, 64, 32), render(DEFAULT, 32, 32)
    np.testing.assert_array_equal(wide.rgb[:, 16:48], tall.rgb)
    np.testing.assert_array_equal(wide.chambers[:, 16:48], tall.chambers)
