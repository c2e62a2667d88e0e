"""Stored normals: exact at a texel's centre, of second order between, and the same whichever pipeline stored them."""

import numpy as np
import pytest

from renderer import Scene, exact
from renderer.picture.differences import rms
from verify.accuracy.frontiers import normal_map
from verify.accuracy.frontiers.wall import order

SIZES = (129, 257, 513)


def test_a_creased_map_converges_like_a_root():
    found = normal_map.errors("ridges", SIZES)
    assert order(found["symbolic"], SIZES, last=3) == pytest.approx(0.5, abs=0.1)
    assert (found["largest"] > 1.9).all()  # of at most 2: the normal of the other side


def test_the_derivative_in_beta_is_lost_between_the_centres():
    """It is an identity in g, but a map keeps no g: what its normals say of g is the filter's."""
    coarse, fine = (normal_map.derivative_errors("sine", texels) for texels in SIZES[1:])
    assert rms(coarse) / rms(fine) == pytest.approx(4, rel=0.2)
    assert fine.max() > 0.01


def test_it_is_exact_at_the_centres():
    for texels in (33, 64):
        at = np.mgrid[0:texels, 0:texels].reshape(2, -1) / texels
        map_ = normal_map.baked(Scene(), texels, exact())
        np.testing.assert_allclose(normal_map.fetched(map_, *at), map_.reshape(3, -1), atol=1e-12)


def test_the_pipelines_meet_in_the_map():
    """Their difference is that of the formulas, and far below what the texels cost either."""
    found, apart = normal_map.errors("sine", SIZES), normal_map.without_a_map("sine")
    assert found["between"] == pytest.approx(apart, rel=0.1)
    assert (found["symbolic"] > 30 * found["between"]).all()
    assert found["numeric"] == pytest.approx(found["symbolic"], rel=2e-2)
    assert (np.abs(found["bytes"] - found["symbolic"]) <= 1 / 255).all()
