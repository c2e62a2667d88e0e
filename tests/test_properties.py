"""What holds for every scene that is accepted, bit for bit: that nothing but the bump bumps, and that scale is none."""

from dataclasses import replace

import numpy as np
from hypothesis import given, strategies as st
from numpy.testing import assert_array_equal

from renderer import Light, render
from renderer.kernels import FIELDS
from tests.strategies import methods, rasters, scaled_triple, scenes

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
        lights=tuple(Light(scaled_triple(light.position, factor), light.color) for light in scene.lights),
    )


@given(scenes(), rasters(), methods, methods, st.sampled_from(["sine", "ridges"]), st.sampled_from(["ku", "kv"]))
def test_no_amplitude_no_height_and_a_plain_sphere_have_the_same_bits(scene, size, method, other, product, wave):
    """A zero gradient times any β adds ±0 to N, and a zero β takes the same path with a zero gradient."""
    flat = render(replace(scene, beta=0.0), *size, method).rgb
    low = [replace(scene, field=field, ku=0.0, kv=0.0) for field in FIELDS]
    for each in (*low, replace(scene, field=product, **{wave: 0.0})):
        assert_array_equal(render(each, *size, other).rgb, flat)


@given(scenes(radius=st.just(1.0)), rasters(), methods, st.integers(-40, 40))
def test_powers_of_two_scale_all_lengths(scene, size, method, n):
    """Bit for bit, but for the floor's squares, whose side stays 1."""
    one, other = render(scene, *size, method), render(scaled(scene, 2.0**n), *size, method)
    assert_array_equal(one.chambers & ~np.uint8(DARK), other.chambers & ~np.uint8(DARK))
    kept = one.chambers & 3 != FLOOR
    assert_array_equal(one.rgb[kept], other.rgb[kept])
