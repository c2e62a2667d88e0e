"""The baselines draw the chapter's picture: what they are timed for is the same work."""

from itertools import product

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from renderer import Scene, central, exact, render
from renderer.kernels import FIELDS
from renderer.picture.facts import SEED_MODELS
from renderer.picture.stage import SURFACE_BITS
from verify.benchmark.baselines.seed_loops import PRINTED, seed_loops

pytestmark = pytest.mark.usefixtures("by_numpy")
SIDE = 48  # with such sides no pixel lies on a crease, where there is no gradient to agree on
LOOPS_AGREE = 1e-11  # their frame by √(1 − N_z²) and v by acos lose digits towards the pole (F20)


DRAWN = [(Scene(field=f, model=m), SIDE, SIDE, eps) for f, m, eps in product(FIELDS, SEED_MODELS, (None, 1e-3))]


@pytest.mark.parametrize("drawn", [*DRAWN, (Scene(ball=False, floor=False, kv=3.5, beta=-0.8), 30, 30, None)])
def test_the_seed_loops_draw_our_picture(drawn):
    *picture, eps = drawn
    rgb, surfaces, kink, slope = seed_loops(*picture, eps)
    frame = render(*picture, exact() if eps is None else central(eps))
    assert np.abs(rgb - frame.rgb).max() < LOOPS_AGREE
    assert_array_equal(surfaces, frame.chambers & SURFACE_BITS)
    assert_array_equal(kink, frame.kink)
    ours = sum(np.nan_to_num(abs(frame.surface_data[name])) for name in ("h_u", "h_v"))
    assert np.abs(slope - ours).max() < 1e-10


def test_the_two_pipelines_of_the_seed_loops_differ_in_the_gradient_alone():
    flat = Scene(beta=0.0)
    assert_array_equal(seed_loops(flat, 16, 16)[0], seed_loops(flat, 16, 16, 1e-3)[0])
    assert np.abs(seed_loops(Scene(), 16, 16)[0] - seed_loops(Scene(), 16, 16, 1e-1)[0]).max() > 1e-3


def test_the_seed_loops_with_the_seeds_own_quadratic_are_told_apart():
    """F1: with c = |C|² − R₂² B covers the picture."""
    _, surfaces, *_ = seed_loops(Scene(), 8, 8, quadratic=PRINTED)
    assert (surfaces == 2).all()
    assert (surfaces != render(Scene(), 8, 8).chambers & SURFACE_BITS).any()
