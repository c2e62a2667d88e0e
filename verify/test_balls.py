"""Programs in balls say what they cannot decide."""

import pytest
from flint import arb
from sympy import Or, Piecewise, sign, sqrt

from proofs.engine.program import chain
from proofs.engine.vectors import real
from renderer import Scene
from verify.evaluate.arrays import in_balls
from verify.evaluate.balls import Balls
from verify.reference import Undecided, reference_pixel

a, b, c, d = real("a b c d")
WIDE = {"a": arb(0, 1), "b": arb(0.5)}
LINES = [
    (Piecewise((1, Or(a < b, b > 0)), (5, True)), WIDE, (1,)),
    (sign(a), WIDE, (-1, 1)),
    (sign(a), {"a": arb(0)}, (0,)),
    (sqrt(a), {"a": arb(0, 4)}, (2,)),
]
"""[(a line, the balls of its inputs, what its ball contains)]: where that is one number, it is decided."""


@pytest.mark.parametrize("expression, values, contained", LINES)
def test_what_is_not_decided_is_enclosed(expression, values, contained):
    ball = Balls(chain("line", {d: expression}))(values, 53)["d"]
    assert all(ball.contains(number) for number in contained)
    assert ball.is_exact() == (contained in ((0,), (1,)))


def test_a_ball_that_decides_nothing_is_no_reference():
    """1/(a − b) with a = b = 1/3: the ball of the difference contains 0, so that of the quotient is all numbers."""
    lines = chain("lines", {c: 1 / (a / 3 - b / 3), d: a * b}, outputs=(c, d))
    assert [ball[0] is None for ball in in_balls(lines, {"a": [1.0], "b": [1.0]}).values()] == [True, False]


def test_a_pixel_on_the_silhouette_is_undecided():
    """ρ = ρ_s = 3.75: the discriminant is 0, so that its computed sign is noise at any number of digits."""
    scene = Scene(eye=5.0, radius=3.0, ball=False)
    with pytest.raises(Undecided, match=r"column = 10, row = 0: surface, rgb_red.* undecided at 100 digits"):
        reference_pixel(scene, 21, 20, 10, 0, digits=100)
    with pytest.raises(Undecided, match="column = 10, row = 9: rgb_red, rgb_green, rgb_blue undecided"):
        reference_pixel(scene, 21, 20, 10, 9)  # on a crease
    assert reference_pixel(scene, 21, 20, 11, 1)["surface"] == 1
