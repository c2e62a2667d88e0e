"""The frontiers: orders of convergence, formulas against each other, stored normals, what displacement moves."""

import numpy as np
import pytest

from renderer import Scene, exact, render
from renderer.intervals import rms
from verify.accuracy.frontiers import fiction, normal_map, wall
from verify.accuracy.orders import fitted_slope

SIZES = (65, 129, 257)
FINER = (129, 257, 513)
BETAS = np.logspace(-3, -2, 4)


# The wall, and stored normals: exact at a texel's centre, of second order between, whichever pipeline stored them


def test_a_creased_field_does_not():
    """Find the largest error between πk and the jump, 2πk, at every size; the RMS falls like the root of the texel."""
    for kind in ("bilinear", "cubic"):
        largest, rms = wall.errors("ridges", kind, SIZES)
        assert (np.abs(largest / (np.pi * wall.KU) - 1.5) < 0.5).all()
        assert wall.order(rms, SIZES, last=3) == pytest.approx(0.5, abs=0.15)


def test_a_creased_map_converges_like_a_root():
    errors = normal_map.errors("ridges", FINER)
    assert wall.order(errors["symbolic"], FINER, last=3) == pytest.approx(0.5, abs=0.1)
    assert (errors["largest"] > 1.9).all()  # of at most 2: the normal of the other side


def test_the_derivative_in_beta_is_lost_between_the_centres():
    """It is an identity in g, but a map keeps no g: what its normals say of g is the filter's."""
    coarse, fine = (normal_map.derivative_errors("sine", texels) for texels in FINER[1:])
    assert rms(coarse) / rms(fine) == pytest.approx(4, rel=0.2)
    assert fine.max() > 0.01


def test_it_is_exact_at_the_centres():
    for texels in (33, 64):
        at = np.mgrid[0:texels, 0:texels].reshape(2, -1) / texels
        map_ = normal_map.baked(Scene(), texels, exact())
        np.testing.assert_allclose(normal_map.fetched(map_, *at), map_.reshape(3, -1), atol=1e-12)


def test_the_pipelines_meet_in_the_map():
    """Their difference is that of the formulas, and far below what the texels cost either."""
    errors, apart = normal_map.errors("sine", FINER), normal_map.without_a_map("sine")
    assert errors["between"] == pytest.approx(apart, rel=0.1)
    assert (errors["symbolic"] > 30 * errors["between"]).all()
    assert errors["numeric"] == pytest.approx(errors["symbolic"], rel=2e-2)
    assert (np.abs(errors["bytes"] - errors["symbolic"]) <= 1 / 255).all()


# The fiction, and what displacement moves: the shadow's edge as the grazed height says, the outline; and the order


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
