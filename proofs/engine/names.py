"""The rules for names in a claim: plain real symbols, no two of one name. This file is trusted."""

import re
from collections.abc import Iterable
from functools import cache

from sympy import Basic, Pow, Symbol

from proofs.engine.derivative import Untranslatable, small

TAKEN = r"pi|(?:root|inverse|sum|derivative)_\d+"
NAME = re.compile(rf"(?!(?:{TAKEN})$)[A-Za-z][A-Za-z0-9_]*", re.ASCII)


def plain(symbols: Iterable[Symbol], *kinds: str) -> None:
    """Raise Untranslatable unless every symbol is assumed real and nothing more, and no two have one name."""
    taken = set()
    for symbol in sorted(symbols, key=str):
        if not NAME.fullmatch(symbol.name):
            raise Untranslatable(f"{symbol.name!r} is no name, or one that the translation makes itself")
        if symbol not in [Symbol(symbol.name, **{kind: True}) for kind in ("real", *kinds)]:
            raise Untranslatable(
                f"{symbol} is not a plain real symbol: what is known of it is a hypothesis to be stated"
            )
        if symbol.name in taken:
            raise Untranslatable(f"two symbols are called {symbol}")
        taken.add(symbol.name)


@cache
def _weight(e):
    """Return how many parts an expression has where it is written out as a tree, with each level a fifth more."""
    return 1 + 6 * sum(map(_weight, e.args)) // 5


def symbols_of(expressions: Iterable[Basic]) -> set[Symbol]:
    """Return every symbol of some expressions, bound ones too; refuse those too deep or too long, and powers 0."""
    expressions = [*expressions]
    small(sum(map(_weight, expressions)) // 10)
    if zeroth := [power for e in expressions for power in e.atoms(Pow) if power.exp == 0]:
        raise Untranslatable(f"no rule translates {zeroth[0]}: what has the exponent 0 is written 1")
    return set().union(*(e.atoms(Symbol) for e in expressions))
