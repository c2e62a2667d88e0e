"""The running error analysis: it encloses what float64 does, and what is exact costs nothing."""

import random

import mpmath
import pytest
from flint import arb

from verify.evaluate import rounding
from verify.evaluate.rounding import Rounded, Undecided, unit_in_the_last_place

EXPRESSIONS = ("a * b + c", "(a - b) / (a + c)", "a * (b - c * c) - 0.1", "(a - 0.5 * b) / (b + 0.5 * a)", "a + b + c")


def worst_share(expression, samples=3000):
    """Return the largest |float64 − exact| over its bound, over samples from [1/2, 2]."""
    rng, worst = random.Random(expression), 0
    a, b, c = (Rounded(rounding.between(0.5, 2)) for _ in "abc")
    code = compile(expression, expression, "eval")
    try:
        mantissa, exponent = eval(code, {"a": a, "b": b, "c": c}).bound.man_exp()
    except Undecided:
        return None
    with mpmath.workprec(1000):  # sums and products of a few float64 numbers are exact
        bound = mpmath.mpf(int(mantissa)) * mpmath.mpf(2) ** int(exponent)
        for _ in range(samples):
            x = {name: rng.uniform(0.5, 2) for name in "abc"}
            exact = eval(code, {name: mpmath.mpf(value) for name, value in x.items()})
            worst = max(worst, abs(mpmath.mpf(eval(code, x)) - exact) / bound)
    return worst


@pytest.mark.parametrize("expression", EXPRESSIONS)
def test_the_bound_encloses_what_float64_does(expression):
    assert 0.2 < worst_share(expression) <= 1


def test_a_bound_that_forgets_half_the_unit_is_seen(monkeypatch):
    unit = unit_in_the_last_place
    monkeypatch.setattr(rounding, "unit_in_the_last_place", lambda size: unit(size) / 4)
    assert max(worst_share(e) for e in EXPRESSIONS) > 1


def test_what_is_exact_costs_nothing():
    x = Rounded(rounding.between(1, 1.5))
    assert (2.0 * x).bound == 0
    assert (x - Rounded(rounding.between(0.8, 1.4))).bound == 0  # Sterbenz
    assert (x - Rounded(rounding.between(0.1, 0.4))).bound > 0
    assert (0.0 + x).bound == 0
    assert arb(2) ** -53 < (x * x).bound < arb(2) ** -52 * 1.001


def test_what_is_not_decided_is_not_guessed():
    x = Rounded(rounding.between(-1, 1))
    with pytest.raises(Undecided):
        _ = x > 0.5
    with pytest.raises(Undecided):
        _ = Rounded(1) / x
