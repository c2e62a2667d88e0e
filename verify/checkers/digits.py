"""Expressions and relations as code, over numbers of 50 digits or over balls: what the second witness evaluates."""

import operator
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import mpmath
from sympy import And, Basic, Expr, Symbol, sympify
from sympy.printing.pycode import MpmathPrinter

Lines = Sequence[tuple[Symbol, Expr]]
DIGITS = 50
WORKING_DIGITS = DIGITS + 15
TOLERANCE = mpmath.mpf(10) ** -40
OPERATORS = {"<": (operator.lt, operator.ge), ">": (operator.gt, operator.le), "==": (operator.eq, operator.ne)}
OPERATORS |= {"<=": (operator.le, operator.gt), ">=": (operator.ge, operator.lt), "!=": (operator.ne, operator.eq)}


class Undefined(ArithmeticError):
    """A division by zero, the root of a negative number, an infinity; or balls that leave a comparison open."""


def compare(left: Any, relation: str, right: Any) -> bool:
    """Return whether a relation holds; raise Undefined where balls leave that open."""
    holds, fails = OPERATORS[relation]
    if not holds(left, right) and not fails(left, right):
        raise Undefined(f"{left} {relation} {right} is open")
    return holds(left, right)


def _real(number):
    number = +mpmath.mpmathify(number)
    if not isinstance(number, mpmath.mpf) or not mpmath.isfinite(number):
        raise Undefined("complex or infinite")
    return number


NUMBERS = {name: getattr(mpmath, name) for name in dir(mpmath) if not name.startswith("_")} | {
    "real": _real,
    "compare": compare,
    "rint": mpmath.nint,
    "atan2pi": lambda y, x: mpmath.atan2(y, x) / mpmath.pi if (x, y) != (0, 0) else mpmath.mpf(0),
    "max": max,
    "min": min,
    "abs": abs,
}
"""What the code calls, over numbers at mpmath's working precision."""


class _Printer(MpmathPrinter):
    def _print_Symbol(self, expr):
        return f"v_{expr.name}"

    def _print_Relational(self, expr):
        return f"compare({self._print(expr.lhs)}, {expr.rel_op!r}, {self._print(expr.rhs)})"


_printer = _Printer({"fully_qualified_modules": False, "allow_unknown_functions": True})


class Code:
    """Definitions and expressions over some inputs, printed as one Python function of numbers, or of balls."""

    def __init__(
        self, inputs: Iterable[Symbol], expressions: Sequence[Basic], definitions: Lines = (), names: Mapping = NUMBERS
    ):
        self.inputs, self.expressions, self.real = list(inputs), expressions, names["real"]
        body = [f"v_{s.name} = {_printer.doprint(e)}" for s, e in definitions]
        body.append(f"return [{', '.join(_printer.doprint(sympify(e)) for e in expressions)}]")
        arguments = ", ".join(f"v_{s.name}" for s in self.inputs)
        scope = dict(names)
        exec(f"def code({arguments}):\n    " + "\n    ".join(body), scope)
        self.code = scope["code"]

    def __call__(self, values: Mapping) -> list:
        """Return the expressions' real values, or raise Undefined."""
        try:
            return [self.real(r) for r in self.code(*(values[s] for s in self.inputs))]
        except (ZeroDivisionError, ValueError, TypeError) as error:
            raise Undefined(str(error)) from None


def parts_of(relations: Iterable[Basic]) -> list[Basic]:
    """Return the single relations of conjunctions, the true ones left out."""
    flat = [part for r in relations for part in (r.args if isinstance(r, And) else (r,))]
    return [part for part in flat if part != True]  # noqa: E712  (SymPy's true is not Python's)


class Relations:
    """Relations over inputs and definitions, as code: called with values, whether all of them hold, to 40 digits.

    exactly: inequalities hold without that tolerance, as what is given has to.
    """

    def __init__(
        self, inputs: Iterable[Symbol], relations: Iterable[Basic], definitions: Lines = (), exactly: bool = False
    ):
        self.slack = 0 if exactly else TOLERANCE
        pairs = [(r.lhs, r.rel_op, r.rhs) if r != False else (0, "==", 1) for r in parts_of(relations)]  # noqa: E712
        self.code = Code(inputs, [side for left, _, right in pairs for side in (left, right)], definitions)
        self.operators = [relation for _, relation, _ in pairs]

    def __call__(self, values: Mapping) -> bool:
        sides = self.code(values)
        return all(map(self._holds, self.operators, sides[::2], sides[1::2]))

    def _holds(self, relation, left, right):
        size = 1 + abs(left) + abs(right)
        if relation in ("==", "!="):
            return (abs(left - right) <= TOLERANCE * size) == (relation == "==")
        if relation in ("<=", ">="):
            right += (self.slack if relation == "<=" else -self.slack) * size
        return compare(left, relation, right)
