"""A straight-line program: an ordered list of named definitions, each an expression in earlier names.

It is the chapter's derivation, line by line. Kernels print it as it stands; proofs substitute as much of it as
they need.
"""

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass
from functools import wraps
from typing import Any

from sympy import Expr, Symbol, evaluate


def evaluated(make: Callable) -> Callable:
    """Let a function make the same formulas in a theorem, where SymPy evaluates nothing, as for a kernel.

    >>> from sympy import evaluate
    >>> from proofs.theorems.language import evaluated, real
    >>> def twice(x):
    ...     return x + x
    >>> with evaluate(False):
    ...     print(twice(real("x")), evaluated(twice)(real("x")))
    x + x 2*x
    """

    @wraps(make)
    def making(*arguments, **named):
        with evaluate(True):
            return make(*arguments, **named)

    return making


Some = Any  # one thing, or several in tuples, lists and iterators, one in another


def flat(part: Some) -> tuple:
    """Return one thing, or several, however they stand in one another, as one tuple.

    >>> from proofs.theorems.language import flat
    >>> flat(1), flat((1, [2, (3,)]))
    ((1,), (1, 2, 3))
    """
    several = isinstance(part, tuple | list | Iterator)
    return tuple(thing for each in part for thing in flat(each)) if several else (part,)


def pairs(lines: Any) -> tuple[tuple, ...]:
    """Return ((symbol, value), …) of {symbol or vector: value or values}, or of such pairs."""
    items = lines.items() if isinstance(lines, Mapping) else lines
    return tuple(pair for names, values in items for pair in zip(flat(names), flat(values), strict=True))


def put(record: Any, **values: Any) -> None:
    """Set fields of a frozen dataclass, while it is made."""
    for name, value in values.items():
        object.__setattr__(record, name, value)


@dataclass(frozen=True)
class Program:
    """Definitions {symbol: expression} in order, from `inputs` to `outputs`; once made, ((symbol, expression), …).

    A vector may be an input, or defined at once: {symbols: expressions}. Without `outputs`, the last line's are.
    Raises ValueError where a line uses a name that is neither an input nor defined above it, where a name is
    defined twice, or where an output is not defined.

    >>> from proofs.theorems.language import Program, real, sqrt
    >>> x, square, root = real("x square root")
    >>> program = Program("length", x, {square: x**2 + 1, root: sqrt(square)})
    >>> program.outputs, program.expand(root), program.keep(square).outputs
    ((root,), sqrt(x**2 + 1), (square,))
    >>> Program("length", x, {root: sqrt(square)})
    Traceback (most recent call last):
    ValueError: length: root uses ['square'] before any definition
    """

    name: str
    inputs: Some
    definitions: Any
    outputs: Some = None

    def __post_init__(self):
        outputs = [*dict(self.definitions)][-1] if self.outputs is None else self.outputs
        put(self, inputs=flat(self.inputs), definitions=pairs(self.definitions), outputs=flat(outputs))
        defined = set(self.inputs)
        for symbol, expression in self.definitions:
            unknown = expression.free_symbols - defined
            if unknown:
                raise ValueError(f"{self.name}: {symbol} uses {sorted(map(str, unknown))} before any definition")
            if symbol in defined:
                raise ValueError(f"{self.name}: {symbol} is defined twice")
            defined.add(symbol)
        missing = set(self.outputs) - defined
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
            [s for s in self.inputs if s in needed],
            [line for line in self.definitions if line[0] in needed],
            outputs,
        )

    def at(self, values: Mapping) -> "Program":
        """Return the program with values, which may be expressions, for some inputs, and other names for some lines.

        values: {symbol or vector: value or values}.
        """
        put = dict(pairs(values))
        inputs = [t for s in self.inputs for t in sorted(put.get(s, s).free_symbols, key=str)]
        lines = [(put.get(symbol, symbol), expression.xreplace(put)) for symbol, expression in self.definitions]
        return Program(self.name, [*dict.fromkeys(inputs)], lines, [put.get(s, s) for s in self.outputs])

    def expand(self, symbol: Any, until: Collection[Symbol] = ()) -> Any:
        """Return a symbol, or each of a vector's, as one expression in the inputs and the names in `until`."""
        if isinstance(symbol, tuple):
            return type(symbol)(self.expand(s, until) for s in symbol)
        expression = symbol
        for name, definition in reversed(self.definitions):
            if name not in until:
                expression = expression.xreplace({name: definition})
        return expression


def chain(name: str, *parts: Program | Mapping, outputs: Some = None) -> Program:
    """Return programs one after another: a later one's inputs may be names that an earlier one defines.

    Between them may stand lines alone, {symbol or vector: expression or expressions}. A line that an earlier program
    already has, letter for letter, is not repeated.

    >>> from proofs.theorems.language import Program, chain, real
    >>> x, square, inverse = real("x square inverse")
    >>> both = chain("inverse_square", Program("square", x, {square: x**2}), {inverse: 1 / square})
    >>> both.inputs, both.expand(inverse)
    ((x,), x**(-2))
    """
    lines: dict[Symbol, Expr] = {}
    inputs: dict[Symbol, None] = {}
    for part in parts:
        program = part if isinstance(part, Program) else _of_lines(name, part)
        inputs |= dict.fromkeys(symbol for symbol in program.inputs if symbol not in lines)
        for symbol, expression in program.definitions:
            if lines.setdefault(symbol, expression) != expression:
                raise ValueError(f"{name}: {symbol} is defined twice, differently")
    return Program(name, [*inputs], lines, outputs or program.outputs)


def _of_lines(name, lines):
    """Return the program of some lines: its inputs are the names that they use and do not define, in order of use."""
    each = pairs(lines)
    defined = {symbol for symbol, _ in each}
    used = [symbol for _, line in each for symbol in sorted(line.free_symbols - defined, key=str)]
    return Program(name, [*dict.fromkeys(used)], lines)
