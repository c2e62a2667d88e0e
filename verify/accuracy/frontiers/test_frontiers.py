"""The wall and the fiction: orders of convergence, and formulas against each other."""

import numpy as np
import pytest

from renderer import Scene, render
from verify.accuracy.frontiers import fiction, wall
from verify.accuracy.orders import fitted_slope

SIZES = (65, 129, 257)


def test_a_creased_field_does_not():
    """The largest error stays between πk and the jump, 2πk; the RMS falls like the root of the texel."""
    for kind in ("bilinear", "cubic"):
        largest, rms = wall.errors("ridges", kind, SIZES)
        assert (np.abs(largest / (np.pi * wall.KU) - 1.5) < 0.5).all()
        assert wall.order(rms, SIZES, last=3) == pytest.approx(0.5, abs=0.15)


def test_the_silhouette_of_a_displaced_surface_to_second_order():
    betas = np.logspace(-3, -2, 5)
    for order, left in enumerate(fiction.silhouette_remainders(betas), start=1):
        assert fitted_slope(betas, left) == pytest.approx(order, abs=0.1)


def test_leaks_and_misses_are_the_flips_of_the_attached_shadow():
    frames = [render(Scene(beta=beta), 48, 48) for beta in (Scene().beta, 0.0)]
    for number, (leak, miss) in enumerate(fiction.leaks(Scene(), 48)):
        bumped, flat = (frame.light_cosines(number) > 0 for frame in frames)
        assert (leak == (bumped & ~flat)).all() and (miss == (flat & ~bumped)).all()
        assert leak.any() and miss.any()
