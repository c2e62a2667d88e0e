"""Evaluator of formulas in other numbers than float64: lines are printed once for all of these, and run in order.

The kinds differ by their tables of names: `MPMATH` here, `BALLS` in the module beside it.
The text shares the expressions with the kernels and nothing else: arithmetic and the elementary functions are the
table's.
For float64 and `Enclosed` numbers there is `renderer.generate.kernels.function_of`.
"""

import operator
from collections.abc import Iterable, Mapping
from functools import partial
from types import CodeType
from typing import Any

import mpmath
from sympy import Basic, Symbol, sympify

from proofs.engine.functions import FUNCTIONS
from proofs.engine.program import Program
from proofs.printers.numbers import NumberPrinter

DIGITS = 50
OPERATORS = {"<": (operator.lt, operator.ge), ">": (operator.gt, operator.le), "==": (operator.eq, operator.ne)}
OPERATORS |= {"<=": (operator.le, operator.gt), ">=": (operator.ge, operator.lt), "!=": (operator.ne, operator.eq)}
"""{relation: (the operator, that of its negation)}"""


def compare(left: Any, relation: str, right: Any) -> bool | None:
    """Return whether a relation holds; None where balls or NaN do not decide it."""
    holds, fails = OPERATORS[relation]
    return True if holds(left, right) else False if fails(left, right) else None


def joined(decisive: bool, *conditions: bool | None) -> bool | None:
    """Return the conjunction of True, False and None (open), False if one is, or the disjunction, True if one is."""
    return decisive if decisive in conditions else (None if None in conditions else not decisive)


ANY_NUMBERS = {
    "compare": lambda left, relation, right: OPERATORS[relation][0](left, right),
    "every": partial(joined, False),
    "some": partial(joined, True),
    "where": lambda condition, value, otherwise: value() if condition else otherwise(),
}
"""The functions that the text calls, where comparisons are decided."""

MPMATHS_OWN = {f.kernel: f.mpmath or f.kernel for f in FUNCTIONS if hasattr(mpmath, f.mpmath or f.kernel)}
MPMATHS_OWN |= {name: name for name in ("sqrt", "power", "inf", "pi", "sin", "cos")}
MPMATH = ANY_NUMBERS | {
    **{name: getattr(mpmath, of_mpmath) for name, of_mpmath in MPMATHS_OWN.items()},
    "rational": lambda p, q: mpmath.mpf(p) / q,
    "nan": mpmath.nan,
    "maximum": max,
    "minimum": min,
    "atan2pi": lambda y, x: mpmath.atan2(y, x) / mpmath.pi if x or y else mpmath.mpf(0),
}
"""The functions that the text calls over numbers at mpmath's working precision."""

_printer = NumberPrinter()


def code_of(lines: Program | Iterable[tuple[Symbol | int, Basic]]) -> list[tuple[str, CodeType]]:
    """Return [(name, code of its line)] of a program, or of (name, expression) pairs."""
    pairs = lines.definitions if isinstance(lines, Program) else lines
    return [(str(name), compile(_printer.doprint(sympify(e)), str(name), "eval")) for name, e in pairs]


class Evaluator:
    """The lines of a program, one after another, in one kind of number."""

    def __init__(self, program: Program):
        self.inputs, self.code = [s.name for s in program.inputs], code_of(program)

    def run(self, values: Mapping[str, Any], names: Mapping[str, Any]) -> dict[str, Any]:
        """Return {name: value} of the inputs, as they are given, and of every line; names: the table of their kind."""
        computed = dict(values)
        scope = {**names, "value": computed}
        for name, code in self.code:
            computed[name] = eval(code, scope)
        return computed
