"""The language of theorems, which a file of theorems imports whole: claims, relations, symbols, fields, numbers."""

from collections.abc import Sequence

from sympy import Abs, Basic, Derivative, Expr, Max, Mul, Or, Pow, Rational, S, Symbol, cos, pi, sign, sin, sqrt

from proofs.engine.claim import (
    CitedLemma,
    Claim,
    Encloses,
    Induction,
    Rounded,
    Separation,
    at_least,
    equation,
    greater,
    number,
)
from proofs.engine.program import Program, Some, chain, evaluated, flat
from proofs.engine.theorem import SideCondition, Theorem, variant
from proofs.engine.vectors import Vector, cross, dot, real, squared, vector, vectors, where
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.symbols import *
from proofs.theorems.cited import cosine_above, sine_above, sine_below, sine_inside_half_turn, sine_of_half_turn

sine, ridges, rings = (HEIGHT_FIELDS[name] for name in ("sine", "ridges", "rings"))
SIDES = ("above", 1), ("below", -1)  # of a crease of an absolute value: the sign of its argument
HALF, QUARTER = Rational(1, 2), Rational(1, 4)
lengths_of_a = (eye > 0, radius > 0, eye > radius)  # the hypotheses on the spheres' lengths
lengths_of_b = (eye > 0, ball_radius > 0)


def equations(left: Sequence[Expr], right: Sequence[Expr]) -> tuple[Basic, ...]:
    """Return the equations of two vectors."""
    return tuple(equation(a, b) for a, b in zip(left, right, strict=True))


def positive(*expressions: Some) -> tuple[Basic, ...]:
    """Return that each is > 0."""
    return tuple(greater(e, 0) for e in flat(expressions))


def nonnegative(*expressions: Some) -> tuple[Basic, ...]:
    """Return that each is ≥ 0."""
    return tuple(at_least(e, 0) for e in flat(expressions))


def zero(*expressions: Some) -> tuple[Basic, ...]:
    """Return that each is 0."""
    return tuple(equation(e, 0) for e in flat(expressions))


def negated(claim: Claim) -> Basic:
    """Return the first equation that a claim shows, its left side with the other sign."""
    return equation(-claim.shows[0].lhs, claim.shows[0].rhs)


def both_ways(bound: Expr, *quantities: Expr) -> tuple[Basic, ...]:
    """Return −bound ≤ quantity ≤ bound of each quantity."""
    return nonnegative([(bound - quantity, bound + quantity) for quantity in quantities])


@evaluated
def named(function: Expr) -> Symbol:
    """Return the name that the translation gives to a cosine or a sine, for hints about squares."""
    return Symbol(str(function.doit()).replace(" ", ""), real=True)


def without(factor: Expr, product: Expr) -> Expr:
    """Return a product without one of its factors: without π, which is no coordinate of a point, say.

    Raises ValueError where it has no such factor.
    """

    def factors(e):
        return [f for part in e.args for f in factors(part)] if e.is_Mul else [e]

    rest = factors(product)
    rest.remove(factor)
    return Mul(*rest)
