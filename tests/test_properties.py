"""What holds for every scene that is accepted: range, finiteness, invariances, each with its exact conditions."""

import warnings
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from proofs.formulas.height_fields import HEIGHT_FIELDS
from renderer import Light, exact, pixel, render
from renderer.kernels import FIELDS
from renderer.scene.raster import Raster
from tests.strategies import differences, methods, rasters, scaled_triple, scenes, wave_numbers

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


@given(scenes(), rasters(), methods, methods)
def test_no_amplitude_no_height_and_a_plain_sphere_have_the_same_bits(scene, size, method, other):
    """A zero gradient times any β adds ±0 to N, and a zero β takes the same path with a zero gradient."""
    flat = render(replace(scene, beta=0.0), *size, method).rgb
    for field in FIELDS:
        low = replace(scene, field=field, ku=0.0, kv=0.0)
        np.testing.assert_array_equal(render(low, *size, other).rgb, flat)


@given(scenes(field=st.sampled_from(["sine", "ridges"])), rasters(), methods, st.booleans())
def test_one_zero_wave_number_makes_a_product_flat(scene, size, method, which):
    low = replace(scene, ku=0.0) if which else replace(scene, kv=0.0)
    np.testing.assert_array_equal(render(low, *size, method).rgb, render(replace(scene, beta=0.0), *size).rgb)


@given(scenes(beta=0.0), rasters())
def test_a_plain_sphere_has_the_normal_of_its_points(scene, size):
    width, height = size
    record = pixel(scene, width, height, width // 2, height // 2)
    assume(record.surface == "A")
    assert record.normal == pytest.approx([c / scene.radius for c in record.point], abs=1e-15)


@given(scenes(), rasters())
def test_mirrored_chambers(scene, size):
    """Bit for bit, but that dark and light squares of the floor are exchanged off the grid lines."""
    one, other = render(scene, *size), render(mirrored(scene), *size)
    differ = one.chambers ^ other.chambers[:, ::-1]
    x, y = Raster(*size).image_points(scene)
    off_grid = (y != np.floor(y))[:, None] & (x != np.floor(x))
    np.testing.assert_array_equal(differ, np.where(off_grid & (one.chambers & 3 == FLOOR), DARK, 0))


whole = st.integers(-64, 64).map(float)
algebraic = st.just(exact("algebraic"))
MIRRORED = {
    "rings": ({"field": "rings"}, methods),
    "no amplitude": ({"beta": 0.0}, methods),
    "ridges, ku even": ({"field": "ridges", "ku": st.integers(-32, 32).map(lambda n: 2.0 * n), "kv": whole}, algebraic),
    "sine, ku = 4n + 2": (
        {"field": "sine", "ku": st.integers(-16, 15).map(lambda n: 4.0 * n + 2), "kv": whole},
        algebraic,
    ),
    "sine, ku = 4n, β → −β": (
        {"field": "sine", "ku": st.integers(-16, 16).map(lambda n: 4.0 * n), "kv": whole},
        algebraic,
    ),
}
"""{which scenes: what is fixed of them, methods}: there h(1/2 − u) = h(u), and −h(u) where β changes its sign. Bit for
bit by the algebraic form, which conjugates; u itself is rounded."""


@pytest.mark.parametrize("name", MIRRORED)
@given(rasters(), st.data())
def test_mirrored_colours(name, size, data):
    fixed, methods = MIRRORED[name]
    scene, method = data.draw(scenes(**fixed)), data.draw(methods)
    turned = mirrored(replace(scene, beta=-scene.beta) if "β" in name else scene)
    one, other = render(scene, *size, method), render(turned, *size, method)
    kept = one.chambers & 3 != FLOOR
    np.testing.assert_array_equal(one.rgb[kept], other.rgb[:, ::-1][kept])


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
    other = other if HEIGHT_FIELDS[field].depends_on_u else replace(other, ku=ku)
    np.testing.assert_array_equal(render(other, *size, method).rgb, render(scene, *size, method).rgb)


@given(scenes(radius=st.just(1.0)), rasters(), methods, st.integers(-40, 40))
def test_powers_of_two_scale_all_lengths(scene, size, method, n):
    """Bit for bit, but for the floor's squares, whose side stays 1."""
    one, other = render(scene, *size, method), render(scaled(scene, 2.0**n), *size, method)
    np.testing.assert_array_equal(one.chambers & ~np.uint8(DARK), other.chambers & ~np.uint8(DARK))
    kept = one.chambers & 3 != FLOOR
    np.testing.assert_array_equal(one.rgb[kept], other.rgb[kept])


@given(scenes(), rasters(), methods, st.data())
def test_the_order_of_the_lights(scene, size, method, data):
    """The shadow bits are permuted alike; every term is ≥ 0, so that colours differ by a few roundings at most."""
    order = data.draw(st.permutations(range(len(scene.lights))))
    other = render(replace(scene, lights=tuple(scene.lights[n] for n in order)), *size, method)
    one = render(scene, *size, method)
    expected = one.chambers & 0x83
    for place, number in enumerate(order):
        expected |= ((one.chambers >> (2 + number)) & 1) << (2 + place)
    np.testing.assert_array_equal(other.chambers, expected)
    np.testing.assert_allclose(other.rgb, one.rgb, rtol=0, atol=2e-15)


SHADING = ("field", "ku", "kv", "beta", "model", "ambient", "albedo_a", "albedo_b", "ka", "kd", "ks", "shininess")


@given(scenes(), scenes(), rasters(), methods)
def test_no_flips(scene, other, size, method):
    """Chambers depend on neither field, wave numbers, β, ε, method nor anything of the shading."""
    shaded = replace(scene, floor_tint=other.floor_tint, **{name: getattr(other, name) for name in SHADING})
    np.testing.assert_array_equal(render(shaded, *size, method).chambers, render(scene, *size).chambers)


@given(scenes(field="ridges"), rasters(), differences)
def test_straddling_grows_with_the_step(scene, size, difference):
    wider = replace(difference, eps=min(0.5, 2 * difference.eps))
    narrow, wide = (render(scene, *size, method).straddling for method in (difference, wider))
    assert (wide >= narrow).all()
    assert not render(scene, *size, exact()).straddling.any()
