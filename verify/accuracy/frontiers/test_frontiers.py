"""The frontiers: stored normals. Orders of the other frontiers are asked for by the ledger."""

import numpy as np
import pytest

from renderer import Scene, exact
from renderer.intervals import rms
from verify.accuracy.frontiers import normal_map, wall

FINER = (129, 257, 513)


def test_a_creased_map_converges_like_a_root():
    errors = normal_map.errors("ridges", FINER)
    assert wall.order(errors["symbolic"], FINER, last=3) == pytest.approx(0.5, abs=0.1)
    assert (errors["largest"] > 1.9).all()  # of at most 2: the normal of the other side


def test_the_derivative_in_beta_is_lost_between_the_centres():
    """The slope in β is an identity in g, but a map stores no g, and the g of interpolated normals is the filter's."""
    coarse, fine = (normal_map.derivative_errors("sine", texels) for texels in FINER[1:])
    assert rms(coarse) / rms(fine) == pytest.approx(4, rel=0.2)
    assert fine.max() > 0.01


def test_it_is_exact_at_the_centres():
    for texels in (33, 64):
        at = np.mgrid[0:texels, 0:texels].reshape(2, -1) / texels
        map_ = normal_map.baked(Scene(), texels, exact())
        np.testing.assert_allclose(normal_map.fetched(map_, *at), map_.reshape(3, -1), atol=1e-12)


def test_the_pipelines_meet_in_the_map():
    """The pipelines' maps differ as their formulas do, far less than the texels make either wrong."""
    errors, apart = normal_map.errors("sine", FINER), normal_map.without_a_map("sine")
    assert errors["between"] == pytest.approx(apart, rel=0.1)
    assert (errors["symbolic"] > 30 * errors["between"]).all()
    assert errors["numeric"] == pytest.approx(errors["symbolic"], rel=2e-2)
    assert (np.abs(errors["bytes"] - errors["symbolic"]) <= 1 / 255).all()
