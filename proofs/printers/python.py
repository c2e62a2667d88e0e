"""Printer of programs as Python functions, for NumPy's arrays, traced values (LLVM) and numbers that count.

The printed text fixes the operations and their order, so that all machines agree to the last bit: integers as floats,
whole powers as products, x^−1 as a division, x^±½ by sqrt, exact rationals that float64 holds as one literal.
"""

import builtins
from collections.abc import Callable, Mapping
from functools import reduce
from inspect import isfunction
from typing import Any, ClassVar

from sympy import Basic, Mul, Rational, S
from sympy.printing.precedence import PRECEDENCE, precedence
from sympy.printing.str import StrPrinter

from proofs.engine.functions import FUNCTIONS
from proofs.engine.program import Program


class KernelPrinter(StrPrinter):
    """A printer of a definition for `renderer.operations`; `NumberPrinter` is that for any other kind of number."""

    names: ClassVar = {function.made.__name__: function.kernel for function in FUNCTIONS}
    names |= {"Infinity": "inf", "NegativeInfinity": "-inf"}

    def literal(self, rational: Rational) -> str:
        """Return the text of an exact rational."""
        number = rational.p / rational.q  # the nearest: as floats the two would be rounded
        return repr(number) if Rational(number) == rational else f"Constant({number!r})"

    def _print_Rational(self, expr):
        return self.literal(expr)

    _print_Integer = _print_Zero = _print_One = _print_NegativeOne = _print_Half = _print_Rational

    def _print_Infinity(self, expr):
        return self.names[type(expr).__name__]

    _print_NegativeInfinity = _print_Infinity

    def _print_Exp1(self, expr):
        return self._call("exp", [S.One])

    def _print_Mul(self, expr):
        coefficient, factors = expr.as_coeff_mul()
        product = expr if coefficient is S.One else expr.func(*factors)
        above, below = [], []
        for factor in product.as_ordered_factors():
            inverse = factor.is_Pow and factor.exp.is_Rational and factor.exp.is_negative
            (below if inverse else above).append(1 / factor if inverse else factor)
        sign = "-" if coefficient.is_negative else ""
        if abs(coefficient) != 1 or not above:
            above.insert(0, abs(coefficient))
        text = " * ".join(self.parenthesize(factor, PRECEDENCE["Mul"]) for factor in above)
        if len(below) == 1:
            text += f" / {self.parenthesize(below[0], PRECEDENCE['Mul'], strict=True)}"
        elif below:
            text += f" / ({' * '.join(self.parenthesize(factor, PRECEDENCE['Mul']) for factor in below)})"
        return sign + text

    def parenthesize(self, item: Basic, level: int, strict: bool = False) -> str:
        """Return the printed item, in parentheses where it binds less tightly (strictly: not more tightly)."""
        product = item.is_Pow and item.exp.is_Integer
        binding = PRECEDENCE["Mul"] if product else precedence(item)
        loose = binding <= level if strict else binding < level
        return f"({self._print(item)})" if loose else self._print(item)

    def _print_Add(self, expr):
        first, *others = (self._print(term) for term in self._as_ordered_terms(expr))
        if first.startswith("-") and not others[0].startswith("-"):  # −a + b is b − a, to the last bit
            first, others[0] = others[0], first
        return first + "".join(f" - {t[1:]}" if t.startswith("-") else f" + {t}" for t in others)

    def _print_Pow(self, expr):
        base, exponent = expr.base, expr.exp
        if exponent == S.Half:
            return f"sqrt({self._print(base)})"
        if exponent.is_Rational and exponent.is_negative:
            return f"1.0 / {self.parenthesize(1 / expr, PRECEDENCE['Mul'], strict=True)}"
        if exponent.is_Integer:
            return " * ".join([self.parenthesize(base, PRECEDENCE["Mul"])] * int(exponent))
        return f"power({self._print(base)}, {self._print(exponent)})"

    def _call(self, name, arguments):
        return f"{name}({', '.join(self._print(a) for a in arguments)})"

    def _print_Function(self, expr):
        return self._call(self.names.get(type(expr).__name__, type(expr).__name__), expr.args)

    _print_Abs = _print_Function

    def _print_Max(self, expr):
        first, *others = map(self._print, expr.args)
        name = self.names[type(expr).__name__]
        return reduce(lambda largest, other: f"{name}({largest}, {other})", others, first)

    _print_Min = _print_Max

    def _print_sign(self, expr):
        """Return the text of a product's sign: the product of its factors' signs, as the product may underflow."""
        text = " * ".join(self._call("sign", [factor]) for factor in Mul.make_args(expr.args[0]))
        return f"({text})" if expr.args[0].is_Mul else text

    def _half_turn(self, name, argument):
        """Return the text of sinpi or cospi of a sum of products, which is computed in two parts to lose nothing."""
        parts = []
        for term in self._as_ordered_terms(argument):
            coefficient, factors = term.as_coeff_mul()
            *others, last = sorted(factors, key=str) or [S.One]
            if others[1:] or not all(factor.is_Symbol for factor in factors):
                return self._call(name, [argument])
            parts.append(self._call("two_product", [Mul(coefficient, *others), last]))
        text = ", ".join(parts)
        certified = len(parts) == 1 and abs(coefficient) <= 4  # up to 4 times the largest wave number
        return f"{name}(*{text if certified else f'sum_of_half_turns({text})'})"

    def _print_sinpi(self, expr):
        return self._half_turn(type(expr).__name__, expr.args[0])

    _print_cospi = _print_sinpi

    def _print_Relational(self, expr):
        return f"({self._print(expr.lhs)} {expr.rel_op} {self._print(expr.rhs)})"

    def _print_Piecewise(self, expr):
        return self._selection(expr, self._print, self._print)

    def _selection(self, expr, branch, decision):
        """Return the text of a Piecewise, of the texts of its values and conditions."""
        (last, otherwise) = expr.args[-1]
        if otherwise != True:  # noqa: E712  (SymPy's true is not Python's)
            raise ValueError(f"expression = {expr} is not allowed: a selection whose last value is for all else")
        text = branch(last)
        for value, condition in reversed(expr.args[:-1]):
            text = self.select(decision(condition), branch(value), text)
        return text

    def select(self, condition: str, value: str, otherwise: str) -> str:
        """Return the text of a selection; the condition stands in parentheses, which it does not need here."""
        return f"where({condition[1:-1]}, {value}, {otherwise})"

    def _print_And(self, expr, connective=" & "):
        return f"({connective.join(self._print(part) for part in sorted(expr.args, key=str))})"

    def _print_Or(self, expr):
        return self._print_And(expr, " | ")


OPTIONAL = "product_error"  # an input of functions of two_product, 0 by default


def print_function(name: str, program: Program, printer: KernelPrinter, before: str = "") -> str:
    """Return the text of a function of a program's inputs that returns its outputs, a line for each definition.

    before: further parameters, as text.
    """
    needed = program.reaches(*program.outputs)
    printed = {s.name: printer.doprint(e) for s, e in program.definitions if s in needed}
    results, used = [s.name for s in program.outputs], set().union(*(e.free_symbols for _, e in program.definitions))
    at_once = f"return {', '.join(printed.values())}"
    if list(printed) == results and used.isdisjoint(program.outputs) and len(at_once) <= 100:
        lines = [at_once]
    else:
        lines = [*(f"{name} = {text}" for name, text in printed.items()), f"return {', '.join(results)}"]
    parameters = ", ".join(f"{s.name}=0.0" if s.name == OPTIONAL else s.name for s in program.inputs)
    return "\n".join([f"def {name}({before}{parameters}):", *(f"    {line}" for line in lines), ""])


def function_of(program: Program, names: Mapping[str, Any]) -> Callable:
    """Return a program as a Python function of its inputs, in order, that returns its outputs.

    names: {name: function} of all that the printed text may call.
    """
    scope = dict(names)
    exec(print_function(program.name, program, KernelPrinter()), scope)
    return scope[program.name]


def refuse_unknown_calls(scope: dict[str, Any]) -> None:
    """Raise ValueError where a function that was made in the scope calls a name that the scope lacks."""
    for kernel in (f for f in scope.values() if isfunction(f) and f.__globals__ is scope):
        if unknown := {*kernel.__code__.co_names} - scope.keys() - {*dir(builtins)}:
            raise ValueError(f"{kernel.__name__} is not allowed: it calls {', '.join(unknown)}, which no kernel has")
