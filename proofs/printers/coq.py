"""Printer of programs as Coq's definitions over real numbers: a module, each line a function of the names it reads."""

import re
import textwrap
from collections.abc import Iterable
from typing import ClassVar

from sympy import And, Basic, Or, Rational, S

from proofs.engine.functions import FUNCTIONS
from proofs.engine.program import Program
from proofs.printers.python import KernelPrinter

WIDTH = 120
COMPARISONS = {
    ">=": ("le", -1),
    "<=": ("le", 1),
    ">": ("lt", -1),
    "<": ("lt", 1),
    "==": ("Req_EM_T", 1),
    "!=": ("differ", 1),
}
"""{relation: (its decision, 1, or -1 where its sides change places)}"""


class CoqPrinter(KernelPrinter):
    """A printer of an expression as a term of Coq's real numbers.

    A symbol that may be infinite (the distance of a missed hit) is of Coquelicot's type Rbar; operations take its real
    part.
    """

    names: ClassVar = {function.made.__name__: function.coq for function in FUNCTIONS if function.coq}
    names |= {"Pi": "PI", "Infinity": "p_infty"}

    def literal(self, rational: Rational) -> str:
        return str(rational.p) if rational.q == 1 else f"({rational.p} / {rational.q})"

    _print_Pi = KernelPrinter._print_Infinity

    def _print_Symbol(self, symbol):
        return symbol.name if symbol.is_real else f"real {symbol.name}"

    def parenthesize(self, item: Basic, level: int, strict: bool = False) -> str:
        text = super().parenthesize(item, level, strict)
        return f"({text})" if " " in text and (item.is_Function or item.is_Symbol) else text

    def _print_Pow(self, expr):
        base, exponent = expr.base, expr.exp
        if exponent == S.Half:
            return f"sqrt {self._atom(base)}"
        if exponent.is_Integer and exponent > 0:
            return f"{self._atom(base)} ^ {exponent}"
        if exponent.is_Rational and exponent.is_negative:
            return f"/ {self._atom(1 / expr)}"
        return f"power {self._atom(base)} {self._atom(exponent)}"

    def _atom(self, expr):
        text = self._print(expr)
        return text if text.replace("_", "").isalnum() else f"({text})"

    def _call(self, name, arguments):
        return " ".join([name, *map(self._atom, arguments)])

    def _folded(self, name, arguments):
        first, *others = arguments
        return (
            self._call(name, arguments)
            if len(others) == 1
            else f"{name} {self._atom(first)} ({self._folded(name, others)})"
        )

    def _print_Max(self, expr):
        return self._folded(self.names[type(expr).__name__], sorted(expr.args, key=str))

    _print_Min, _print_sign = _print_Max, KernelPrinter._print_Function

    def _print_floor(self, expr):
        return f"IZR (Int_part {self._atom(expr.args[0])})"

    def _half_turn(self, name, argument):
        return f"{name.removesuffix('pi')} (PI * {self._atom(argument)})"

    def _comparison(self, relation):
        name, order = COMPARISONS[relation.rel_op]
        sides = relation.args[::order]
        if not any(side is S.Infinity or (side.is_Symbol and not side.is_real) for side in sides):
            return self._call({"le": "Rle_dec", "lt": "Rlt_dec"}.get(name, name), sides)
        return " ".join([f"Rbar_{name}_dec", *map(self._extended, sides)])

    def _extended(self, side):
        """Return a term of Rbar."""
        return "p_infty" if side is S.Infinity else side.name if not side.is_real else f"(Finite {self._atom(side)})"

    def _decision(self, condition):
        """Return a term that decides a condition."""
        if not isinstance(condition, And | Or):
            return self._comparison(condition)
        both = "both" if isinstance(condition, And) else "either"
        first, *others = (f"({self._decision(part)})" for part in sorted(condition.args, key=str))
        for other in others:
            first = f"({both} {first} {other})"
        return first[1:-1]

    def _print_Piecewise(self, expr):
        bounded = any(value is S.Infinity for value, _ in expr.args)

        def branch(value):
            return f"Finite {self._atom(value)}" if bounded and value is not S.Infinity else self._print(value)

        return self._selection(expr, branch, self._decision)

    def select(self, condition: str, value: str, otherwise: str) -> str:
        return f"if {condition} then {value} else {otherwise}"


def wrapped(text: str) -> str:
    """Return a text of Coq's, its longer lines broken at spaces."""

    def filled(line):
        further = f"{line[1]}    "
        return textwrap.fill(line[0], WIDTH, subsequent_indent=further, break_long_words=False, break_on_hyphens=False)

    return re.sub(rf"(?m)^( *).{{{WIDTH}}}.+$", filled, text)


def module_of(program: Program) -> str:
    """Return a program as the text of a Coq module."""
    printer, inside = CoqPrinter(), []
    real = " ".join(s.name for s in program.inputs if s.is_real)
    infinite = " ".join(s.name for s in program.inputs if not s.is_real)
    inside += [f"Variables {real} : R."] if real else []
    inside += [f"Variables {infinite} : Rbar."] if infinite else []
    inside += [f"Definition {s.name} := {printer.doprint(e)}." for s, e in program.definitions]
    return in_module(program.name, inside)


def in_module(name: str, inside: Iterable[str]) -> str:
    """Return definitions as a Coq module, with a tactic that unfolds them, the last one first."""
    lines = [*inside]
    defined = ", ".join(line.split()[1] for line in reversed(lines) if line.startswith("Definition"))
    unfolded = f"Ltac lines := unfold {defined}."
    return wrapped(
        "\n".join([f"Module {name}.", "Section program.", *lines, "End program.", unfolded, f"End {name}.", ""])
    )
