"""The running error analysis: it encloses what float64 does, and what is exact costs nothing."""

import random

import pytest
from flint import arb, ctx

from verify.evaluate import rounding
from verify.evaluate.rounding import Rounded, Undecided, unit_in_the_last_place

EXPRESSIONS = ("a * b + c", "(a - b) / (a + c)", "a * (b - c * c) - 0.1", "(a - 0.5 * b) / (b + 0.5 * a)", "a + b + c")


def worst_share(text, samples=3000):
    """Return the largest |float64 − exact| over its bound, over samples from [1/2, 2]."""
    rng, worst, expression = random.Random(text), 0.0, eval(f"lambda a, b, c: {text}")
    bound = expression(*(Rounded(rounding.between(0.5, 2)) for _ in "abc")).error
    with ctx.workprec(1000):
        for _ in range(samples):
            numbers = [rng.uniform(0.5, 2) for _ in "abc"]
            off = abs(arb(expression(*numbers)) - expression(*map(arb, numbers)))
            worst = max(worst, float(off / bound))
    return worst


@pytest.mark.parametrize("expression", EXPRESSIONS)
def test_the_bound_encloses_what_float64_does(expression):
    assert 0.2 < worst_share(expression) <= 1


def test_a_bound_that_forgets_half_the_unit_is_seen(monkeypatch):
    monkeypatch.setattr(rounding, "unit_in_the_last_place", lambda size: unit_in_the_last_place(size) / 4)
    assert max(map(worst_share, EXPRESSIONS)) > 1


def test_what_is_exact_costs_nothing_and_nothing_else():
    """By Sterbenz, among others."""
    x = Rounded(rounding.between(1, 1.5))
    assert (2.0 * x).error == (x - Rounded(rounding.between(0.8, 1.4))).error == 0
    assert (x - Rounded(rounding.between(0.1, 0.4))).error > 0


def test_what_is_not_decided_is_not_guessed():
    for undecided in (lambda x: x > 0.5, lambda x: Rounded(1) / x):
        with pytest.raises(Undecided):
            undecided(Rounded(rounding.between(-1, 1)))
