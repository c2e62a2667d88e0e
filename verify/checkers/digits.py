"""Expressions and relations as 50-digit code: what the second witness evaluates."""

from collections.abc import Iterable, Mapping, Sequence

import mpmath
from sympy import And, Basic, Expr, Symbol, sympify
from sympy.printing.pycode import MpmathPrinter

Lines = Sequence[tuple[Symbol, Expr]]
DIGITS = 50
WORKING_DIGITS = DIGITS + 15
TOLERANCE = mpmath.mpf(10) ** -40
_NAMES = {name: getattr(mpmath, name) for name in dir(mpmath) if not name.startswith("_")} | {
    "mpf": mpmath.mpf,
    "rint": mpmath.nint,
    "atan2pi": lambda y, x: mpmath.atan2(y, x) / mpmath.pi if (x, y) != (0, 0) else mpmath.mpf(0),
    "max": max,
    "min": min,
    "abs": abs,
}


class Undefined(ArithmeticError):
    """A division by zero, the root of a negative number, or an infinity."""


class _Printer(MpmathPrinter):
    def _print_Symbol(self, expr):
        return f"v_{expr.name}"


_printer = _Printer({"fully_qualified_modules": False, "allow_unknown_functions": True})


class Code:
    """Definitions and expressions over some inputs, printed as one Python function of 50-digit numbers."""

    def __init__(self, inputs: Iterable[Symbol], expressions: Sequence[Basic], definitions: Lines = ()):
        self.inputs, self.expressions = list(inputs), expressions
        body = [f"v_{s.name} = {_printer.doprint(e)}" for s, e in definitions]
        body.append(f"return [{', '.join(_printer.doprint(sympify(e)) for e in expressions)}]")
        arguments = ", ".join(f"v_{s.name}" for s in self.inputs)
        scope = dict(_NAMES)
        exec(f"def code({arguments}):\n    " + "\n    ".join(body), scope)
        self.code = scope["code"]

    def __call__(self, values: Mapping) -> list[mpmath.mpf]:
        """Return the expressions' real values, or raise Undefined."""
        try:
            results = [+mpmath.mpmathify(r) for r in self.code(*(values[s] for s in self.inputs))]
        except (ZeroDivisionError, ValueError, TypeError) as error:
            raise Undefined(str(error)) from None
        if not all(isinstance(r, mpmath.mpf) and mpmath.isfinite(r) for r in results):
            raise Undefined("complex or infinite")
        return results


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
        self.parts = parts_of(relations)
        sides = [side for r in self.parts for side in ((0, 1) if r == False else (r.lhs, r.rhs))]  # noqa: E712
        self.code = Code(inputs, sides, definitions)
        self.operators = ["==" if r == False else r.rel_op for r in self.parts]  # noqa: E712

    def __call__(self, values: Mapping) -> bool:
        sides = self.code(values)
        return all(
            _holds(op, a, b, self.slack) for op, a, b in zip(self.operators, sides[::2], sides[1::2], strict=True)
        )


def _holds(operator, left, right, tolerance):
    gap, size = left - right, 1 + abs(left) + abs(right)
    return {
        "==": abs(gap) <= TOLERANCE * size,
        "!=": abs(gap) > TOLERANCE * size,
        ">": gap > 0,
        ">=": gap >= -tolerance * size,
        "<": gap < 0,
        "<=": gap <= tolerance * size,
    }[operator]
