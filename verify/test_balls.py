"""Programs in balls: they enclose the 50-digit reference, and say what they cannot decide."""

import random

import pytest
from flint import arb, ctx
from sympy import And, Max, Or, Piecewise, Pow, sign, sqrt

from proofs.engine.program import Program
from proofs.formulas.symbols import real
from renderer import Scene, render
from verify.accuracy.pixels import COLORS, SCENES, checked_pixel, chosen, problems, truth_of
from verify.evaluate.balls import Balls
from verify.reference import reference_pixel

a, b, c, d = real("a b c d")
SIZE = 96


@pytest.mark.parametrize("name", SCENES)
def test_balls_enclose_the_reference(name):
    """At 256 bits to 50 digits, and so does the frame's own bound."""
    rng, frame = random.Random(name), render(SCENES[name], SIZE, SIZE, bounds=True)
    for _ in range(4):
        column, row = rng.randrange(SIZE), rng.randrange(SIZE)
        truth, balls = reference_pixel(frame.scene, SIZE, SIZE, column, row), truth_of(frame, column, row)
        with ctx.workprec(400):
            for color in COLORS:
                assert abs(balls[color].mid() - arb(truth[color])) < arb(10) ** -48
        assert problems([checked_pixel(name, frame, "at random", column, row)]) == []


def line(expression, **values):
    """Return the ball of one line."""
    inputs = tuple(sorted(expression.free_symbols, key=str))
    return Balls(Program("line", inputs, ((d, expression),), (d,)))(values, 53)["d"]


def test_what_is_not_decided_is_enclosed():
    wide = arb(0, 1)
    value = line(Piecewise((1, a < b), (5, True)), a=wide, b=arb(0.5))
    assert value.contains(1)
    assert value.contains(5)
    assert line(Piecewise((1, a < b), (5, True)), a=arb(0, 0.25), b=arb(0.5)) == 1
    assert line(Piecewise((1, Or(a < b, b > 0)), (5, True)), a=wide, b=arb(0.5)) == 1
    assert line(Piecewise((1, And(a < b, b < 0)), (5, True)), a=wide, b=arb(0.5)) == 5
    assert all(line(sign(a), a=wide).contains(side) for side in (-1, 1))
    assert line(sign(a), a=arb(0)) == 0


def test_a_ball_that_reaches_below_zero_is_cut_off_where_the_line_says_so():
    assert line(sqrt(a), a=arb(0, 4)).contains(2)
    assert line(Pow(Max(0, a), b), a=arb(0, 0.5), b=arb(3)).contains(arb(0.125))
    assert line(sqrt(a), a=arb(-2)).is_nan()


def test_a_pixel_that_is_off_is_found():
    scene = Scene()
    frame = render(scene, 64, 64, bounds=True)
    place = next(p for p in chosen(scene, frame, each=2) if frame.chambers[p[2], p[1]] & 3 == 1)
    good = checked_pixel("ridges, blinn", frame, *place)
    assert problems([good]) == []
    off = {"error": 2 * good.bound}, {"error": float("nan")}, {"same_chamber": False}
    bad = [good._replace(**change) for change in off]
    assert problems(bad) == bad
    assert problems([bad[0]._replace(undecided=True)]) == []
    frame.rgb[place[2], place[1]] += 1e-11
    assert problems([checked_pixel("ridges, blinn", frame, *place)])
