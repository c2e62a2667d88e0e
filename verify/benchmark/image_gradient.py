"""The exact gradient alone, from the image point (x, y) to (h_u, h_v), in algebraic form on one thread."""

from renderer import exact, stage_of
from renderer.gradients import fill_angles, fill_gradient, scratch_planes
from verify.benchmark.frames import A_ALONE, STEP, calls
from verify.benchmark.plan import Case


def points():
    """Return how many points one call takes: the pixels of A."""
    return int(stage_of(A_ALONE, STEP, STEP).on_a.sum())


def prepare():
    """Return a function that takes the gradient at every pixel of A."""
    stage, method = stage_of(A_ALONE, STEP, STEP), exact("algebraic")

    def work():
        for band in stage.bands:
            planes = scratch_planes(len(band.y), STEP)
            fill_angles(stage, band, planes)
            fill_gradient(A_ALONE, method, band, planes)

    work()
    return work


CASE = Case("image_gradient", prepare, calls(STEP))
