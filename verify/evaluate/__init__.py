"""A straight-line program in other numbers than float64: printed for them, line by line, and run.

What runs it shares the expressions with the kernels and nothing else: arithmetic and the elementary functions are
mpmath's, or those of `verify.evaluate.balls`. For float64 there is `renderer.generate.kernels.function_of`.
"""

from collections.abc import Callable, Mapping
from types import CodeType
from typing import Any

import mpmath
from sympy import Rational

from proofs.engine.program import Program
from renderer.generate.printer import KernelPrinter

DIGITS = 50
NOTHING = mpmath.nan  # the value of a line that has none, such as the normal of a sphere that is not hit


class LazyPrinter(KernelPrinter):
    """One number at a time: a selection computes the side that it takes, and no other."""

    def select(self, condition: str, value: str, otherwise: str) -> str:
        return f"({value} if {condition} else {otherwise})"


class ExactPrinter(LazyPrinter):
    """Numbers of any precision: rationals are quotients, and a product needs no error beside it."""

    def literal(self, rational: Rational) -> str:
        return f"rational({rational.p}, {rational.q})"

    def _half_turn(self, name, argument):
        return f"{name}({self._print(argument)})"


def code_of(program: Program, printer: KernelPrinter | None = None) -> list[tuple[str, CodeType]]:
    """Return [(name, code of its line)] of a program; by default with the kernels' operations."""
    printer = printer or LazyPrinter()
    return [(s.name, compile(printer.doprint(e), s.name, "eval")) for s, e in program.definitions]


NAMES = {
    "rational": lambda p, q: mpmath.mpf(p) / q,
    "sqrt": mpmath.sqrt,
    "floor": mpmath.floor,
    "rint": mpmath.nint,
    "sign": mpmath.sign,
    "maximum": max,
    "minimum": min,
    "power": mpmath.power,
    "exp": mpmath.exp,
    "log": mpmath.log,
    "binary_exponent": lambda x: mpmath.mpf(mpmath.frexp(x)[1] - 1),
    "power_of_two": lambda n: mpmath.mpf(2) ** n,
    "nan": mpmath.nan,
    "inf": mpmath.inf,
    "pi": mpmath.pi,
    "sinpi": mpmath.sinpi,
    "cospi": mpmath.cospi,
    "atan2pi": lambda y, x: mpmath.atan2(y, x) / mpmath.pi if x or y else mpmath.mpf(0),
}
"""What ExactPrinter's text calls, at mpmath's working precision."""


class Evaluator:
    """A straight-line program in the numbers of a subclass."""

    printer = ExactPrinter()

    def __init__(self, program: Program):
        self.program, self.lines = program, code_of(program, self.printer)

    def run(self, names: dict[str, Any], values: Mapping[str, Any], number: Callable) -> dict[str, Any]:
        """Return {name: value} of every line; names: what the text calls; values: of every input, by name."""
        scope = names | {s.name: number(values[s.name]) for s in self.program.inputs}
        for name, code in self.lines:
            self.line = name
            scope[name] = self.compute(code, scope)
        return {name: scope[name] for name, _ in self.lines}

    def compute(self, code: CodeType, scope: dict[str, Any]) -> Any:
        """Return the value of a line."""
        return eval(code, scope)


class Reference(Evaluator):
    """A straight-line program at any precision, by mpmath."""

    def __call__(self, values: Mapping[str, Any], digits: int = DIGITS) -> dict[str, mpmath.mpf]:
        """Return {name: value} of every line; `values` has a float or an mpf for every input's name."""
        # A product k·u of float64 numbers has 106 bits; the guard digits keep it exact, and cancellation away.
        with mpmath.workdps(digits + 20):
            return self.run(NAMES, values, mpmath.mpf)

    def compute(self, code: CodeType, scope: dict[str, Any]) -> mpmath.mpf:
        """Return the value of a line, NOTHING where it divides by zero."""
        try:
            return mpmath.mpmathify(eval(code, scope))
        except ZeroDivisionError:
            return NOTHING
