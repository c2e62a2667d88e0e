"""Relations, names and points that several theorems speak of."""

from collections.abc import Sequence

from sympy import Basic, Expr, Symbol

from proofs.engine.claim import at_least, equation


def equations(left: Sequence[Expr], right: Sequence[Expr]) -> tuple[Basic, ...]:
    """Return the equations of two vectors."""
    return tuple(equation(a, b) for a, b in zip(left, right, strict=True))


def both_ways(bound: Expr, quantity: Expr) -> tuple[Basic, Basic]:
    """Return −bound ≤ quantity ≤ bound."""
    return at_least(bound - quantity, 0), at_least(bound + quantity, 0)


def named(function: Expr) -> Symbol:
    """Return the name that the translation gives to a cosine or a sine, for hints about squares."""
    return Symbol(str(function).replace(" ", ""), real=True)
