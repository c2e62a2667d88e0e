"""What is taken from analysis and not proved here: bounds of sine and cosine by their Taylor polynomials."""

from sympy import cos, sin

from proofs.engine.claim import CitedLemma, at_least

SOURCE = "DLMF"  # §1.4.35, Taylor's theorem; §4.18, the signs


def sine_below(x):
    """sin x ≤ x, for x ≥ 0."""
    return CitedLemma(at_least(x, sin(x)), SOURCE)


def sine_above(x):
    """sin x ≥ x − x³/6, for x ≥ 0."""
    return CitedLemma(at_least(sin(x), x - x**3 / 6), SOURCE)


def cosine_above(x):
    """cos x ≥ 1 − x²/2, for every x."""
    return CitedLemma(at_least(cos(x), 1 - x**2 / 2), SOURCE)


def sine_of_half_turn(x):
    """sin x ≥ 0, for 0 ≤ x ≤ π."""
    return CitedLemma(at_least(sin(x), 0), SOURCE)
