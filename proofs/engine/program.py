"""A straight-line program: an ordered list of named definitions, each an expression in earlier names.

It is the chapter's derivation, line by line. Kernels print it as it stands; proofs substitute as much of it as
they need.
"""

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from functools import wraps
from typing import Any

from sympy import Expr, Symbol, evaluate


def evaluated(make: Callable) -> Callable:
    """Let a function make the same formulas in a theorem, where SymPy evaluates nothing, as for a kernel."""

    @wraps(make)
    def making(*arguments, **named):
        with evaluate(True):
            return make(*arguments, **named)

    return making


def _each(part):
    """Return the components of a vector, or the one part that is none."""
    return part if isinstance(part, tuple) else (part,)


def _all(parts):
    return tuple(component for part in parts for component in _each(part))


@dataclass(frozen=True)
class Program:
    """Definitions `(symbol, expression)` in order, from `inputs` to `outputs` (tuples of symbols).

    A vector may be an input, or defined at once: `(symbols, expressions)`. Without `outputs`, the last line's are.
    Raises ValueError where a line uses a name that is neither an input nor defined above it, where a name is
    defined twice, or where an output is not defined.
    """

    name: str
    inputs: tuple[Symbol, ...]
    definitions: tuple[tuple[Symbol, Expr], ...]
    outputs: tuple[Symbol, ...] = None  # type: ignore[assignment]  # a tuple from here on

    def __post_init__(self):
        lines = [line for names, values in self.definitions for line in zip(_each(names), _each(values), strict=True)]
        outputs = self.definitions[-1][:1] if self.outputs is None else self.outputs
        vars(self).update(inputs=_all(self.inputs), definitions=tuple(lines), outputs=_all(outputs))
        known = set(self.inputs)
        for symbol, expression in self.definitions:
            unknown = expression.free_symbols - known
            if unknown:
                raise ValueError(f"{self.name}: {symbol} uses {sorted(map(str, unknown))} before any definition")
            if symbol in known:
                raise ValueError(f"{self.name}: {symbol} is defined twice")
            known.add(symbol)
        missing = set(self.outputs) - known
        if missing:
            raise ValueError(f"{self.name}: outputs {sorted(map(str, missing))} are not defined")

    def __getitem__(self, symbol):
        """Return the expression that defines `symbol`, as it stands."""
        return dict(self.definitions)[symbol]

    def reaches(self, *symbols: Symbol) -> set[Symbol]:
        """Return every name, inputs included, that the given symbols depend on (themselves included)."""
        reached = set(symbols)
        for symbol, expression in reversed(self.definitions):
            if symbol in reached:
                reached |= expression.free_symbols
        return reached

    def keep(self, *outputs: Symbol, name: str | None = None) -> "Program":
        """Return the program for `outputs` alone, without the lines and inputs that they do not need."""
        needed = self.reaches(*outputs)
        return Program(
            name or self.name,
            tuple(s for s in self.inputs if s in needed),
            tuple(line for line in self.definitions if line[0] in needed),
            outputs,
        )

    def at(self, values: Mapping[Symbol, Expr]) -> "Program":
        """Return the program with values, which may be expressions, in the place of some inputs."""
        lines = tuple((symbol, expression.xreplace(values)) for symbol, expression in self.definitions)
        used = set().union(*(expression.free_symbols for _, expression in lines)) - {symbol for symbol, _ in lines}
        return Program(self.name, tuple(sorted(used, key=str)), lines, self.outputs)

    def expand(self, symbol: Any, until: Collection[Symbol] = ()) -> Any:
        """Return a symbol, or each of a vector's, as one expression in the inputs and the names in `until`."""
        if isinstance(symbol, tuple):
            return type(symbol)(self.expand(s, until) for s in symbol)
        expression = symbol
        for name, definition in reversed(self.definitions):
            if name not in until:
                expression = expression.xreplace({name: definition})
        return expression


def chain(name: str, *programs: Program, outputs: tuple[Symbol, ...] | None = None) -> Program:
    """Return the programs one after another: a later one's inputs may be names that an earlier one defines.

    A line that an earlier program already has, letter for letter, is not repeated.
    """
    definitions: dict[Symbol, Expr] = {}
    inputs: dict[Symbol, None] = {}
    for program in programs:
        for symbol in program.inputs:
            if symbol not in definitions:
                inputs[symbol] = None
        for symbol, expression in program.definitions:
            if definitions.setdefault(symbol, expression) != expression:
                raise ValueError(f"{name}: {symbol} is defined twice, differently")
    return Program(name, tuple(inputs), tuple(definitions.items()), outputs or programs[-1].outputs)
