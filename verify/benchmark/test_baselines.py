"""The baselines draw the chapter's picture: what they are timed for is the same work."""

from itertools import product

import numpy as np
import pytest
from sympy import symbols

from proofs.engine.program import Program
from proofs.formulas.symbols import x
from renderer import Scene, central, exact, render
from renderer.scene import MODELS
from renderer.stage import SURFACE_BITS
from verify.benchmark.baselines import seed_loops as loops
from verify.benchmark.baselines.numpy_tiles import numpy_function, numpy_tiles, without_repeats
from verify.benchmark.baselines.seed_loops import seed_loops

SIDE = 48  # with such sides no pixel lies on a crease, where there is no gradient to agree on
LOOPS_AGREE = 1e-11  # their frame by √(1 − N_z²) and v by acos lose digits towards the pole (F20)
TILES_AGREE = 1e-12  # libm's sine of a rounded πku


def largest(rgb, frame):
    return np.abs(rgb - frame.rgb).max()


DRAWN = [(Scene(field=f, model=m), SIDE, SIDE, eps) for f, m, eps in product(loops.FIELDS, MODELS, (None, 1e-3))]


@pytest.mark.parametrize("drawn", [*DRAWN, (Scene(ball=False, floor=False, kv=3.5, beta=-0.8), 30, 22, None)])
def test_the_seed_loops_draw_our_picture(drawn):
    *given, eps = drawn
    rgb, surfaces = seed_loops(*given, eps)
    frame = render(*given, exact() if eps is None else central(eps))
    assert largest(rgb, frame) < LOOPS_AGREE
    np.testing.assert_array_equal(surfaces, frame.chambers & SURFACE_BITS)


@pytest.mark.parametrize(("name", "wrong"), [
    ("nearest_hit", lambda *given: (loops.SPHERE_B, 0.5)),  # B covers the picture, as by the seed's own quadratic
    ("exact_gradient", loops.central_gradient),
])  # fmt: skip
def test_other_loops_draw_another_picture(name, wrong, monkeypatch):
    frame = render(Scene(), 16, 16, exact())
    assert largest(seed_loops(Scene(), 16, 16)[0], frame) < LOOPS_AGREE
    monkeypatch.setattr(loops, name, lambda *given: wrong(*given[:3], given[3] or 1e-1))
    assert largest(seed_loops(Scene(), 16, 16)[0], frame) > 1e-3


@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("side", [64, 256])
def test_the_numpy_tiles_draw_our_picture(side, threads):
    rgb, surfaces = numpy_tiles(Scene(), side, side, threads)
    frame = render(Scene(), side, side, exact("general"))
    assert largest(rgb, frame) < TILES_AGREE
    np.testing.assert_array_equal(surfaces, frame.chambers & SURFACE_BITS)


def test_repeated_lines_are_computed_once():
    a, b, c = symbols("a b c", real=True)
    program = Program("p", (x,), ((a, x + 1), (b, x + 1), (c, a * b)), (c, b))
    slim = without_repeats(program)
    assert [s for s, _ in slim.definitions] == [a, c]
    assert numpy_function(slim)[0](2.0) == (9.0, 3.0)
