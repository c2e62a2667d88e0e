"""Relations, names and points that several theorems speak of."""

from collections.abc import Mapping, Sequence

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


def point(values: Mapping) -> tuple[tuple[Symbol, object], ...]:
    """Return ((symbol, value), …) of {symbol or vector of symbols: value or values}."""
    pairs = ((s, v) if isinstance(s, tuple) else ((s,), (v,)) for s, v in values.items())
    return tuple(pair for symbols, at in pairs for pair in zip(symbols, at, strict=True))
