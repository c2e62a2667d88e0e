"""What a claim's names may be: plain real symbols, each with a name of its own. This file is trusted."""

import re
from collections.abc import Iterable

from sympy import Basic, Symbol

from proofs.engine.derivative import Untranslatable

TAKEN = r"pi|(?:root|inverse|sum|derivative)_\d+"
NAME = re.compile(rf"(?!(?:{TAKEN})$)[A-Za-z][A-Za-z0-9_]*", re.ASCII)


def plain(symbols: Iterable[Symbol]) -> None:
    """Raise Untranslatable unless every symbol is real, nothing more, and has a name of its own."""
    seen = set()
    for symbol in sorted(symbols, key=str):
        if not NAME.fullmatch(symbol.name):
            raise Untranslatable(f"{symbol.name!r} is no name, or one that the translation makes itself")
        if symbol != Symbol(symbol.name, real=True):
            raise Untranslatable(
                f"{symbol} is not a plain real symbol: what is known of it is a hypothesis to be stated"
            )
        if symbol.name in seen:
            raise Untranslatable(f"two symbols are called {symbol}")
        seen.add(symbol.name)


def symbols_of(expressions: Iterable[Basic]) -> set[Symbol]:
    """Return every symbol of some expressions, bound ones too."""
    return set().union(*(e.atoms(Symbol) for e in expressions))
