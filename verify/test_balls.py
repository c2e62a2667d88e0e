"""Programs in balls: they enclose the 50-digit reference, and say what they cannot decide."""

import random

import pytest
from flint import arb, ctx
from sympy import And, Max, Or, Piecewise, Pow, sign, sqrt

from proofs.engine.program import Program
from proofs.formulas.symbols import real
from renderer import Scene, render
from verify.accuracy.pixels import COLORS, SCENES, balls_of, checked_pixel, chosen, problems
from verify.evaluate.balls import Balls, ball_of
from verify.reference import reference_pixel, scene_values

a, b, c, d = real("a b c d")
SIZE = 96


@pytest.mark.parametrize("name", SCENES)
def test_balls_enclose_the_reference(name):
    """At 256 bits to 50 digits, and at 53 bits as well."""
    rng, scene = random.Random(name), SCENES[name]
    for _ in range(4):
        column, row = rng.randrange(SIZE), rng.randrange(SIZE)
        values = scene_values(scene, column=column, row=row, width=SIZE, height=SIZE)
        truth = reference_pixel(scene, SIZE, SIZE, column, row)
        fine, _ = balls_of(scene.field, scene.model, 2)(values, 256)
        coarse, undecided = balls_of(scene.field, scene.model, 2)(values)
        with ctx.workprec(400):
            for color in COLORS:
                assert abs(fine[color].mid() - ball_of(truth[color])) < arb(10) ** -48
                assert undecided or coarse[color].contains(fine[color].mid())


def line(expression, **values):
    """Return (the ball of one line, whether it was left undecided)."""
    inputs = tuple(sorted(expression.free_symbols, key=str))
    found, undecided = Balls(Program("line", inputs, ((d, expression),), (d,)))(values)
    return found["d"], bool(undecided)


def test_what_is_not_decided_is_named_and_enclosed():
    wide = arb(0, 1)
    value, undecided = line(Piecewise((1, a < b), (5, True)), a=wide, b=arb(0.5))
    assert undecided
    assert value.contains(1)
    assert value.contains(5)
    assert line(Piecewise((1, a < b), (5, True)), a=arb(0, 0.25), b=arb(0.5)) == (arb(1), False)
    assert line(Piecewise((1, Or(a < b, b > 0)), (5, True)), a=wide, b=arb(0.5)) == (arb(1), False)
    assert line(Piecewise((1, And(a < b, b < 0)), (5, True)), a=wide, b=arb(0.5)) == (arb(5), False)
    assert line(sign(a), a=wide)[1]
    assert line(sign(a), a=arb(0)) == (arb(0), False)


def test_a_ball_that_reaches_below_zero_is_cut_off_where_the_line_says_so():
    assert line(sqrt(a), a=arb(0, 4))[0].contains(2)
    assert line(Pow(Max(0, a), b), a=arb(0, 0.5), b=arb(3))[0].contains(arb(0.125))
    assert line(sqrt(a), a=arb(-2))[0].is_nan()


def test_a_pixel_that_is_off_is_found():
    scene = Scene()
    frame = render(scene, 64, 64)
    kind, column, row = next(p for p in chosen(scene, frame, each=2) if frame.chambers[p[2], p[1]] & 3 == 1)
    good = checked_pixel("ridges, blinn", scene, frame, kind, column, row)
    assert problems([good]) == []
    bad = good._replace(error=1e-13), good._replace(error=float("nan")), good._replace(same_chamber=False)
    assert problems(bad) == list(bad)
    rim = good._replace(off_rim=False, error=2 * good.radius)
    assert problems([rim]) == [rim]
    assert problems([bad[0]._replace(undecided=frozenset({"h_u"}))]) == []
    frame.rgb[row, column] += 1e-12
    assert problems([checked_pixel("ridges, blinn", scene, frame, kind, column, row)])
