"""The exact gradient alone, from the image point (x, y) to (h_u, h_v), in algebraic form on one thread."""

import numpy as np

from renderer import exact, stage_of
from renderer.shading import WORK
from renderer.sphere_a import bump_of
from verify.benchmark.frames import A_ALONE, calls
from verify.benchmark.plan import Case

SIDE = 256  # six planes of it stay in a cache: it is the gradient that is timed, not the memory


def points():
    """Return how many points one call takes: the pixels of A."""
    return int(stage_of(A_ALONE, SIDE, SIDE).on_a.sum())


def prepare():
    """Return a function that takes the gradient at every pixel of A and draws nothing."""
    stage, bump = stage_of(A_ALONE, SIDE, SIDE), bump_of(A_ALONE, exact("algebraic"))
    planes, count = np.empty((6, SIDE, SIDE)), np.zeros(len(WORK), np.int64)

    def work():
        for band in stage.bands:
            bump.draw(stage, band, count, planes=planes)

    work()
    return work


CASE = Case("image_gradient", prepare, calls(SIDE))
