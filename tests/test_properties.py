"""Properties of every accepted scene: it is drawn in range, nothing but the bump bumps, and scale does not matter."""

import math
import warnings
from dataclasses import replace
from itertools import product

import numpy as np
import pytest
from hypothesis import given, strategies as st
from numpy.testing import assert_array_equal

from renderer import Light, Scene, exact, pixel, render
from renderer.kernels import FIELDS
from renderer.scene.scene import BUMPS, MODELS
from tests.strategies import methods, rasters, scaled_triple, scenes
from verify.reference import reference_pixel

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


# The record of one pixel: parts that add up to its colour


@given(scenes(), rasters(), methods, st.data())
def test_a_record_has_the_bits_of_the_frame_and_what_adds_up_to_them(scene, size, method, data):
    column, row = (data.draw(st.integers(0, side - 1)) for side in size)
    record, frame = pixel(scene, *size, column, row, method), render(scene, *size, method)
    told = record.rgb, record.chamber, bool(record.kink), bool(record.straddling)
    planes = frame.chambers, frame.kink, frame.straddling
    assert told == (tuple(frame.rgb[row, column]), *(plane[row, column] for plane in planes))
    assert record.surface == ("none", "A", "B", "floor")[record.chamber & 3]
    normal = frame.normal[row, column]
    assert tuple(normal) == record.normal if record.surface == "A" else np.isnan(normal).all()
    if record.surface == "none":
        assert (record.rgb, record.lights) == ((0.0, 0.0, 0.0), ())
        return
    for light in record.lights:
        assert light.occluded == bool(record.chamber >> (2 + light.number) & 1)
        assert not light.occluded or light.adds == (0.0, 0.0, 0.0)
    sums = scene.ka * np.array(scene.ambient) + sum(np.array(light.adds) for light in record.lights)
    assert record.rgb == pytest.approx(np.minimum(1.0, sums), abs=2e-15)


def test_a_normal_that_no_light_shows_is_recorded_bumped():
    dark = replace(Scene(), lights=[Light((5.0, 5.0, 10.0), None)])
    assert pixel(dark, 64, 64, 30, 30).normal == pixel(Scene(), 64, 64, 30, 30).normal


def test_a_record_has_the_gradient_of_the_field_without_a_bump_too():
    flat, bumped = (pixel(Scene(beta=beta), 256, 256, 104, 72) for beta in (0.0, 0.35))
    assert flat.gradient == bumped.gradient != (0.0, 0.0)


@pytest.mark.parametrize("model, surface, bump", [*product(MODELS, (1, 2, 3), BUMPS[:1]), ("phong", 1, "surface")])
def test_a_record_is_what_50_digits_say(surface, model, bump):
    scene = Scene(model=model, shininess=7.5, ku=-6.0, kv=-3.0, bump=bump)
    row, column = np.argwhere(render(scene, 64, 64).chambers & 3 == surface)[0].tolist()
    record, truth = pixel(scene, 64, 64, column, row), reference_pixel(scene, 64, 64, column, row)
    told = {f"point_{axis}": c for axis, c in zip("xyz", record.point, strict=True)}
    told |= {f"bumped_{axis}": c for axis, c in zip("xyz", record.normal, strict=True)}
    told |= {f"mu_{light.number}": light.mu for light in record.lights}
    told |= {f"specular_{light.number}": light.specular for light in record.lights}
    if surface == 1:
        told |= {"u": record.u, "v": record.v, "h_u": record.gradient[0], "h_v": record.gradient[1]}
    assert told == pytest.approx({name: float(truth[name]) for name in told}, abs=1e-12)


@pytest.mark.parametrize("switch, beta, shininess", [
    ({"model": "blinn_gated"}, 0.35, 1.0),
    ({"model": "blinn_gated"}, 0.35, 2.0),
    ({"horizon": True}, 0.0, 2.0),
])  # fmt: skip
def test_a_switch_takes_light_from_behind_and_no_more(switch, beta, shininess):
    """Behind the bumped normal the highlight, behind the surface itself all light; the rest keeps its bits."""
    scene = Scene(shininess=shininess, kd=0.0, lights=(Light((6.0, 2.0, 1.0)),))
    plain, unlit, switched = (render(replace(scene, **changes), 64, 64) for changes in ({}, {"ks": 0.0}, switch))
    on_a, behind = plain.stage.on_a, render(replace(scene, beta=beta), 64, 64).light_cosines(0) <= 0
    expected = np.where(behind[..., None], unlit.rgb, plain.rgb)[on_a]
    np.testing.assert_array_equal(switched.rgb[on_a], expected)
    assert (plain.rgb[on_a] != expected).any()


def test_a_gated_highlight_ends_where_the_bump_says():
    frame = render(Scene(model="blinn_gated"), 8, 8, derivatives=("beta", "kd"))
    assert frame.moves_boundaries == ("beta",)
