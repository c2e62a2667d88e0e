"""What holds for every scene that is accepted: range, finiteness, invariances, each with its exact conditions."""

import warnings
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from renderer import Light, exact, render
from renderer.kernels import FIELDS
from renderer.scene.raster import Raster
from tests.strategies import methods, rasters, scaled_triple, scenes, wave_numbers

FLOOR = 3
DARK = 128


@pytest.fixture(autouse=True)
def warnings_are_errors():
    with warnings.catch_warnings(), np.errstate(all="raise"):
        warnings.simplefilter("error")
        yield


def mirrored(scene):
    """The scene with every x negated."""
    x, y, z = scene.ball_center
    lights = tuple(Light((-light.position[0], *light.position[1:]), light.color) for light in scene.lights)
    return replace(scene, ball_center=(-x, y, z), lights=lights)


def scaled(scene, factor):
    """The scene with every length times `factor`."""
    return replace(
        scene,
        radius=factor * scene.radius,
        eye=factor * scene.eye,
        ball_center=scaled_triple(scene.ball_center, factor),
        ball_radius=factor * scene.ball_radius,
        lights=tuple(Light(scaled_triple(light.position, factor), light.color) for light in scene.lights),
    )


@given(scenes(), rasters(), methods, methods, st.sampled_from(["sine", "ridges"]), st.sampled_from(["ku", "kv"]))
def test_no_amplitude_no_height_and_a_plain_sphere_have_the_same_bits(scene, size, method, other, product, wave):
    """A zero gradient times any β adds ±0 to N, and a zero β takes the same path with a zero gradient."""
    flat = render(replace(scene, beta=0.0), *size, method).rgb
    low = [replace(scene, field=field, ku=0.0, kv=0.0) for field in FIELDS]
    for each in (*low, replace(scene, field=product, **{wave: 0.0})):
        np.testing.assert_array_equal(render(each, *size, other).rgb, flat)


algebraic = st.just(exact("algebraic"))


def of_product(field, *remainders):
    """Return what is fixed of a scene: its field, kv whole, ku even, with one of the remainders modulo 4."""
    ku = st.integers(-32, 32).map(lambda n: 2.0 * n).filter(lambda ku: ku % 4 in remainders)
    return {"field": field, "ku": ku, "kv": st.integers(-64, 64).map(float)}


MIRRORED = {
    "rings": ({"field": "rings"}, methods),
    "no amplitude": ({"beta": 0.0}, methods),
    "ridges, ku even": (of_product("ridges", 0, 2), algebraic),
    "sine, ku = 4n + 2": (of_product("sine", 2), algebraic),
    "sine, ku = 4n, β → −β": (of_product("sine", 0), algebraic),
}
"""{which scenes: what is fixed of them, methods}: there h(1/2 − u) = h(u), and −h(u) where β changes its sign. Bit for
bit by the algebraic form, which conjugates; u itself is rounded."""


@pytest.mark.parametrize("name", MIRRORED)
@given(rasters(), st.data())
def test_a_mirrored_scene(name, size, data):
    """Bit for bit, but that dark and light squares of the floor are exchanged off the grid lines."""
    fixed, methods = MIRRORED[name]
    scene, method = data.draw(scenes(**fixed)), data.draw(methods)
    turned = mirrored(replace(scene, beta=-scene.beta) if "β" in name else scene)
    one, other = render(scene, *size, method), render(turned, *size, method)
    floor, (x, y) = one.chambers & 3 == FLOOR, Raster(*size).image_points(scene)
    off_grid = (y != np.floor(y))[:, None] & (x != np.floor(x))
    exchanged = one.chambers ^ np.where(floor & off_grid, DARK, 0)
    np.testing.assert_array_equal(other.chambers[:, ::-1], exchanged)
    np.testing.assert_array_equal(one.rgb[~floor], other.rgb[:, ::-1][~floor])


NEGATED = {
    "ridges": [("ku",), ("kv",), ("ku", "kv")],
    "sine": [("ku", "kv"), ("beta", "ku"), ("beta", "kv")],
    "rings": [("beta", "kv"), ("ku",)],
}
"""{field: which numbers may change their signs}: ridges are even in each, sine is odd, rings know no ku."""


@pytest.mark.parametrize("field", NEGATED)
@given(rasters(), methods, wave_numbers, st.data())
def test_what_may_change_its_sign(field, size, method, ku, data):
    scene, names = data.draw(scenes(field=field)), data.draw(st.sampled_from(NEGATED[field]))
    other = replace(scene, **{name: -getattr(scene, name) for name in names})
    other = replace(other, ku=ku) if field == "rings" else other
    np.testing.assert_array_equal(render(other, *size, method).rgb, render(scene, *size, method).rgb)


@given(scenes(radius=st.just(1.0)), rasters(), methods, st.integers(-40, 40))
def test_powers_of_two_scale_all_lengths(scene, size, method, n):
    """Bit for bit, but for the floor's squares, whose side stays 1."""
    one, other = render(scene, *size, method), render(scaled(scene, 2.0**n), *size, method)
    np.testing.assert_array_equal(one.chambers & ~np.uint8(DARK), other.chambers & ~np.uint8(DARK))
    kept = one.chambers & 3 != FLOOR
    np.testing.assert_array_equal(one.rgb[kept], other.rgb[kept])


@given(scenes(), rasters(), methods, st.data())
def test_lights_change_places_and_one_that_is_off_is_as_good_as_absent(scene, size, method, data):
    """The shadow bits move alike; every term is ≥ 0, so that colours differ by a few roundings at most."""
    lights = (*scene.lights[:4], Light((50 * scene.radius, 0.0, 50 * scene.radius), None))
    order = data.draw(st.permutations(range(len(lights))))
    one = render(replace(scene, lights=lights[:-1]), *size, method)
    other = render(replace(scene, lights=tuple(lights[number] for number in order)), *size, method)
    expected = one.chambers & 0x83
    for place, number in enumerate(order):
        expected |= ((one.chambers >> (2 + number)) & 1) << (2 + place)
    np.testing.assert_array_equal(other.chambers, expected)
    np.testing.assert_allclose(other.rgb, one.rgb, rtol=0, atol=2e-15)
