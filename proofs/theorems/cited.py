"""Lemmas cited from analysis and not proved here: bounds of sine and cosine, each with its conditions."""

from sympy import Expr, cos, pi, sin

from proofs.engine.claim import CitedLemma, at_least, greater

SOURCE = "DLMF"  # §1.4.35, Taylor's theorem; §4.18, the signs


def sine_below(x: Expr) -> CitedLemma:
    """Return the lemma sin x ≤ x, for x ≥ 0."""
    return CitedLemma(at_least(x, sin(x)), SOURCE, at_least(x, 0))


def sine_above(x: Expr) -> CitedLemma:
    """Return the lemma sin x ≥ x − x³/6, for x ≥ 0."""
    return CitedLemma(at_least(sin(x), x - x**3 / 6), SOURCE, at_least(x, 0))


def cosine_above(x: Expr) -> CitedLemma:
    """Return the lemma cos x ≥ 1 − x²/2, for every x."""
    return CitedLemma(at_least(cos(x), 1 - x**2 / 2), SOURCE)


def sine_inside_half_turn(x: Expr) -> CitedLemma:
    """Return the lemma sin πx > 0, for 0 < x < 1."""
    return CitedLemma(greater(sin(pi * x), 0), SOURCE, (greater(x, 0), greater(1, x)))


def sine_of_half_turn(x: Expr) -> CitedLemma:
    """Return the lemma sin πx ≥ 0, for 0 ≤ x ≤ 1."""
    return CitedLemma(at_least(sin(pi * x), 0), SOURCE, (at_least(x, 0), at_least(1, x)))
