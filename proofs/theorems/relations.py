"""Relations, fields, names and numbers that several theorems speak of."""

from collections.abc import Sequence

from sympy import Basic, Expr, Mul, Rational, Symbol

from proofs.engine.claim import at_least, equation, greater
from proofs.engine.program import evaluated
from proofs.formulas.height_fields import HEIGHT_FIELDS

sine, ridges, rings = (HEIGHT_FIELDS[name] for name in ("sine", "ridges", "rings"))
SIDES = ("above", 1), ("below", -1)  # of a crease of an absolute value: the sign of what that is taken of
HALF, QUARTER, EIGHTH = (Rational(1, n) for n in (2, 4, 8))


def equations(left: Sequence[Expr], right: Sequence[Expr]) -> tuple[Basic, ...]:
    """Return the equations of two vectors."""
    return tuple(equation(a, b) for a, b in zip(left, right, strict=True))


def positive(*expressions: Expr) -> tuple[Basic, ...]:
    """Return that each is > 0."""
    return tuple(greater(e, 0) for e in expressions)


def nonnegative(*expressions: Expr) -> tuple[Basic, ...]:
    """Return that each is ≥ 0."""
    return tuple(at_least(e, 0) for e in expressions)


def zero(*expressions: Expr) -> tuple[Basic, ...]:
    """Return that each is 0."""
    return tuple(equation(e, 0) for e in expressions)


def both_ways(bound: Expr, *quantities: Expr) -> tuple[Basic, ...]:
    """Return −bound ≤ quantity ≤ bound of each quantity."""
    return nonnegative(*(end for quantity in quantities for end in (bound - quantity, bound + quantity)))


def between(low: Expr | int, high: Expr | int, *symbols: Symbol) -> tuple[tuple, ...]:
    """Return the ranges of symbols of which samples are drawn between the same ends."""
    return tuple((symbol, (low, high)) for symbol in symbols)


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

    found = factors(product)
    found.remove(factor)
    return Mul(*found)
