"""The record of one pixel: the same bits as the frame, and parts that add up to its colour."""

from dataclasses import replace
from itertools import product

import numpy as np
import pytest
from hypothesis import given, strategies as st

from renderer import Light, Scene, pixel, render
from renderer.scene.scene import BUMPS, MODELS
from tests.strategies import methods, rasters, scenes
from verify.reference import reference_pixel

pytestmark = pytest.mark.usefixtures("by_numpy")


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
