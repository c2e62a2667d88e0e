"""The wall and the fiction: orders of convergence, and formulas against each other."""

from dataclasses import replace

import numpy as np
import pytest

from renderer import Scene, render
from verify.accuracy.frontiers import fiction, wall
from verify.accuracy.orders import fitted_slope

SIZES = (65, 129, 257)


@pytest.mark.parametrize(("kind", "order"), [("bilinear", 1), ("cubic", 3)])
def test_a_smooth_field_converges_at_the_order_of_the_interpolation(kind, order):
    largest, rms = wall.errors("sine", kind, SIZES)
    assert wall.order(largest, SIZES, last=3) == pytest.approx(order, abs=0.1)
    assert wall.order(rms, SIZES, last=3) == pytest.approx(order, abs=0.1)


@pytest.mark.parametrize("kind", ["bilinear", "cubic"])
def test_a_creased_field_does_not(kind):
    """The largest error stays between πk and the jump, 2πk; the RMS falls like the root of the texel."""
    largest, rms = wall.errors("ridges", kind, SIZES)
    assert (largest > np.pi * wall.KU).all() and (largest < 2 * np.pi * wall.KU).all()
    assert wall.order(rms, SIZES, last=3) == pytest.approx(0.5, abs=0.15)


def test_mending_the_normal_brings_it_nearer_step_by_step():
    medians = [np.nanmedian(angles) for angles in fiction.angle_maps(render(Scene(), 64, 64)).values()]
    assert medians == sorted(medians, reverse=True)
    assert medians[0] > 100 and medians[-1] < 5


def test_without_amplitude_all_normals_are_one():
    frame = render(Scene(beta=0.0), 32, 32)
    for angles in fiction.angle_maps(frame).values():
        assert np.nanmax(angles) < 1e-6


def test_the_silhouette_of_a_displaced_surface_to_second_order():
    betas = np.logspace(-3, -2, 5)
    for order, left in enumerate(fiction.silhouette_remainders(betas), start=1):
        assert fitted_slope(betas, left) == pytest.approx(order, abs=0.1)


def test_leaks_and_misses_are_the_flips_of_the_attached_shadow():
    scene, size = Scene(), 48
    bumped, flat = render(scene, size, size), render(replace(scene, beta=0.0), size, size)
    for number, (leak, miss) in enumerate(fiction.leaks(scene, size)):
        sides = [frame.light_cosines(number) > 0 for frame in (bumped, flat)]
        np.testing.assert_array_equal(leak | miss, sides[0] != sides[1])
        assert not (leak & miss).any()
        assert leak.any() and miss.any()
    assert not any(part.any() for pair in fiction.leaks(replace(scene, beta=0.0), size) for part in pair)
