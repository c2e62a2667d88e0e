"""Properties of every accepted scene: it is drawn in range, nothing but the bump bumps, and scale does not matter."""

import math
import warnings
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, strategies as st
from numpy.testing import assert_array_equal

from renderer import Light, Scene, exact, pixel, render
from renderer.kernels import FIELDS
from tests.strategies import methods, rasters, scaled_triple, scenes

pytestmark = pytest.mark.usefixtures("by_numpy")
FLOOR = 3
DARK = 128


def scaled(scene, factor):
    """The scene with every length times `factor`."""
    return replace(
        scene,
        radius=factor * scene.radius,
        eye=factor * scene.eye,
        ball_center=scaled_triple(scene.ball_center, factor),
        ball_radius=factor * scene.ball_radius,
        beta=scene.beta * (factor if scene.bump == "surface" else 1.0),  # a length there
        lights=tuple(Light(scaled_triple(light.position, factor), light.color) for light in scene.lights),
    )


@given(scenes(), rasters(), methods, methods, st.sampled_from(sorted(FIELDS)), st.sampled_from(["ku", "kv"]))
def test_no_amplitude_no_height_and_a_plain_sphere_have_the_same_bits(scene, size, method, other, field, wave):
    """A zero gradient times any β adds ±0 to N, and a zero β takes the same path with a zero gradient."""
    flat = render(replace(scene, beta=0.0), *size, method).rgb
    product = "sine" if field == "rings" else field
    for each in (replace(scene, field=field, ku=0.0, kv=0.0), replace(scene, field=product, **{wave: 0.0})):
        assert_array_equal(render(each, *size, other).rgb, flat)


@given(scenes(radius=st.just(1.0)), rasters(), methods, st.integers(-40, 40))
def test_powers_of_two_scale_all_lengths(scene, size, method, n):
    """Bit for bit, but for the floor's squares, whose side stays 1."""
    one, other = render(scene, *size, method), render(scaled(scene, 2.0**n), *size, method)
    assert_array_equal(one.chambers & ~np.uint8(DARK), other.chambers & ~np.uint8(DARK))
    off_floor = one.chambers & 3 != FLOOR
    assert_array_equal(one.rgb[off_floor], other.rgb[off_floor])


def check(frame, record=None):
    """Raise AssertionError if anything of a frame, or of a pixel's record, is not a number in range."""
    assert frame.rgb.min() >= 0 and frame.rgb.max() <= 1  # false for NaN
    on_a = frame.stage.on_a
    for name, plane in frame.surface_data.items():
        assert (np.isfinite(plane) == on_a).all(), name
    u, v = (frame.surface_data[name][on_a] for name in "uv")
    assert ((u >= 0) & (u < 1) & (v >= 0) & (v < 0.5)).all()
    if record:
        assert all(map(math.isfinite, (*record.point, *record.rgb))), record
        assert abs(math.hypot(*record.normal) - 1) <= (1e-6 if record.surface == "B" else 1e-14), record
        for light in record.lights:
            assert abs(light.mu) <= 1 + 1e-6, record
            assert all(0 <= number < math.inf for number in (light.specular, *light.adds)), record


@given(scenes(), rasters(12), methods)
def test_every_accepted_scene_is_drawn_in_range(scene, size, method):
    """With warnings as errors; a pixel is looked at before the clip, which would turn NaN into 0."""
    with warnings.catch_warnings(), np.errstate(all="raise"):
        warnings.simplefilter("error")
        frame = render(scene, *size, method)
        drawn = np.argwhere(frame.chambers & 3)
        row, column = drawn[len(drawn) // 2].tolist() if len(drawn) else (None, None)
        check(frame, pixel(scene, *size, column, row, method) if len(drawn) else None)


def test_one_bad_number_is_found():
    """In the picture, and behind the clip."""
    frame, record = render(Scene(), 8, 8, exact()), pixel(Scene(), 8, 8, 4, 4)
    check(frame, record)
    good = frame.rgb[0, 0, 0]
    for value in (np.nan, np.inf, -1e-9, 1 + 1e-9):
        frame.rgb[0, 0, 0] = value
        with pytest.raises(AssertionError):
            check(frame)
    frame.rgb[0, 0, 0] = good
    object.__setattr__(record.lights[0], "mu", float("nan"))
    with pytest.raises(AssertionError):
        check(frame, record)
