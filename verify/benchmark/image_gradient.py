"""The exact gradient alone, from the image point (x, y) to (h_u, h_v), in algebraic form on one thread."""

from renderer import exact, stage_of
from renderer.shader import ON_A
from verify.benchmark.frames import A_ALONE, calls
from verify.benchmark.plan import Case

SIDE = 256  # six planes of it stay in a cache: it is the gradient that is timed, not the memory


def points():
    """Return how many points one call takes: the pixels of A."""
    return int(stage_of(A_ALONE, SIDE, SIDE).on_a.sum())


def prepare():
    """Return a function that takes the gradient at every pixel of A and draws nothing."""
    stage = stage_of(A_ALONE, SIDE, SIDE)
    planes = {name: stage.new_plane() for name in ON_A}

    def work():
        stage.draw(A_ALONE, exact("algebraic"), 1, planes, given=True, surfaces="a", colors=False, kept=ON_A)

    work()
    return work


CASE = Case("image_gradient", prepare, calls(SIDE))
