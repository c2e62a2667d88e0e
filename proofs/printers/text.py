"""Formulas as text: a printer whose text reads back as it was, and a reader of a list of allowed parts.

Functions by other names are the caller's. A text from a file, a command line or a picture may be anybody's. It has to
be short and of few letters; Python's parser makes a tree of it, of which nothing is run: a walk makes SymPy's
expression of the nodes that it knows.
"""

import ast
import operator
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from functools import cache
from typing import Any

from sympy import (
    Abs,
    Add,
    And,
    Basic,
    Expr,
    Function,
    Max,
    Min,
    Mul,
    Or,
    Piecewise,
    Pow,
    Rational,
    S,
    Symbol,
    Tuple,
    exp,
    floor,
    log,
    pi,
    sign,
    sqrt,
)
from sympy.logic.boolalg import Boolean
from sympy.printing.precedence import PRECEDENCE
from sympy.printing.str import StrPrinter

from proofs.engine.functions import FUNCTIONS
from proofs.engine.program import evaluated
from proofs.engine.registry import not_allowed
from proofs.engine.vectors import where

LONGEST, DEEPEST, LARGEST_POWER, LARGEST_NUMBER = 2000, 40, 64, 2**256
MOST_OPERATIONS, OF_A_FUNCTION = 1000, 10  # more would take a compiler many seconds
MOST_CHOICES = 40  # abs and sign are 1, another of n parts n(n − 1), each twice as many inside another choice
_CALLED = {function.text or function.kernel: function.made for function in FUNCTIONS if function.enclosed}
_PLAIN = {name: made for name, made in _CALLED.items() if made not in (Abs, sign, Max, Min)} | {"sqrt": sqrt}
_CHOICES = {name: made for name, made in _CALLED.items() if name not in _PLAIN} | {"Piecewise": Piecewise}
_CHOICES |= {"Abs": Abs, "Max": Max, "Min": Min}  # as SymPy prints them
_COMPARISONS = {ast.Lt: operator.lt, ast.LtE: operator.le, ast.Gt: operator.gt, ast.GtE: operator.ge}
_LETTERS = re.compile(r"[A-Za-z0-9_ .,+\-*/%^()<>=&|]*")
_NUMBER = re.compile(r"(\d+(\.\d*)?|\.\d+)([eE][+-]?\d\d?)?")
_SIGNS = str.maketrans({"π": "pi", "−": "-", "·": "*", "×": "*", "²": "**2", "³": "**3"})  # as people type them
_PRODUCTS_OF_PI = re.compile(r"(?<=[\w)])\s*(?=π)|(?<=π)\s*(?=[\w(])")  # 2πu
_HINT = "write 2*u for 2u, 4*sin(u) for 4 sin(u), abs(u) for |u|, sin(u)**2, where(u < v, 1, 2)"
_BROKEN = (SyntaxError, ValueError, TypeError, ArithmeticError, RecursionError, MemoryError)  # of SymPy too


class _Reader:
    """A reader of one text."""

    def __init__(self, text: str, names: Mapping[str, Symbol], calls: Mapping[str, Callable]):
        self.text = _PRODUCTS_OF_PI.sub("*", text).translate(_SIGNS)
        self.names, self.calls = {**names, "pi": pi, "E": S.Exp1}, {**_PLAIN, **calls}
        self.choices, self.inside = 0, 0  # how many there are; in how many the present node lies

    def refused(self, why: str) -> ValueError:
        """Return the ValueError that refuses the text; it quotes the text's beginning."""
        return not_allowed("expression", self.text if len(self.text) < 80 else f"{self.text[:60]}...", why)

    def expression(self) -> Expr:
        """Return the expression of the whole text."""
        if len(self.text) > LONGEST:
            raise self.refused(f"a text of at most {LONGEST} letters, and it has {len(self.text)}")
        allowed = _LETTERS.match(self.text).end()  # type: ignore[union-attr]
        if allowed < len(self.text):
            raise self.refused(f"no formula has the letter {self.text[allowed]!r}: {_HINT}")
        try:
            self.text = re.sub(r"\b(np|numpy|math|sp|sympy)\.", "", self.text).replace("^", "**")
            tree = ast.parse(self.text, mode="eval")
        except _BROKEN as error:
            offset = getattr(error, "offset", None)
            place = f" from {self.text[offset - 1 :][:20]!r} on" if offset else ""
            raise self.refused(f"it is no formula{place}: {_HINT}") from None
        return self.read(tree.body, 0)

    def text_of(self, node: ast.expr) -> str:
        """Return the text of a node."""
        return self.text[node.col_offset : node.end_col_offset]

    def read(self, node: ast.expr, depth: int, kind: type = Expr) -> Any:
        """Return the expression of a node so deep in the tree; kind: a condition's is Boolean, a choice's Tuple."""
        if depth > DEEPEST:
            raise self.refused(f"it is nested more than {DEEPEST} deep")
        try:
            value = self._of(node, depth + 1)
        except _BROKEN as error:
            if str(error).startswith("expression = "):
                raise
            raise self.refused(f"{self.text_of(node)[:60]} is not defined") from None
        if next(one for one in (Expr, Tuple, Boolean) if isinstance(value, one)) is not kind:
            raise self.refused(f"{self.text_of(node)[:60]!r} is not of the kind that belongs there: {_HINT}")
        return self._bounded(value, node)

    def _of(self, node, depth):
        match node:
            case ast.Name(name) if name in self.names:
                return self.names[name]
            case ast.Constant() if _NUMBER.fullmatch(self.text_of(node)):
                return Rational(self.text_of(node))
            case ast.UnaryOp(ast.UAdd() | ast.USub() as operation, operand):
                return self.read(operand, depth) * (-1 if isinstance(operation, ast.USub) else 1)
            case ast.BinOp(_, ast.Add() | ast.Sub(), _):
                return Add(*self._chained(node, ast.Add, ast.Sub, lambda part: -part, depth))
            case ast.BinOp(_, ast.Mult() | ast.Div(), _):
                return Mul(*self._chained(node, ast.Mult, ast.Div, lambda part: 1 / part, depth))
            case ast.BinOp(one, ast.Mod(), other):
                return remainder(self.read(one, depth), self.read(other, depth))
            case ast.BinOp(base, ast.Pow(), power):
                base, power = self.read(base, depth), self.read(power, depth)
                return Pow(base, self._power(power, node)) if power.is_number else exp(power * log(base))
            case ast.Call(ast.Name(name), [_, *_] as arguments, []) if name in self.calls:
                return self.calls[name](*[self.read(argument, depth) for argument in arguments])
            case ast.Call(ast.Name(name), [_, *_] as arguments, []) if name in _CHOICES:
                with self.choice(len(arguments)):
                    kind = Tuple if name == "Piecewise" else Expr
                    return _CHOICES[name](*[self.read(argument, depth, kind) for argument in arguments])
            case ast.IfExp(test, one, other) | ast.Call(ast.Name("where"), [test, one, other], []):
                with self.choice(2):
                    values = self.read(one, depth), self.read(other, depth)
                    return where(self.read(test, depth, Boolean), *values)
            case ast.Tuple([value, condition]):
                return Tuple(self.read(value, depth), self.read(condition, depth, Boolean))
            case ast.Constant(True):
                return S.true
            case ast.BinOp(one, ast.BitAnd() | ast.BitOr() as connective, other):
                sides = self.read(one, depth, Boolean), self.read(other, depth, Boolean)
                return And(*sides) if isinstance(connective, ast.BitAnd) else Or(*sides)
            case ast.BoolOp(connective, parts):
                sides = [self.read(part, depth, Boolean) for part in parts]
                return And(*sides) if isinstance(connective, ast.And) else Or(*sides)
            case ast.Compare(left, [relation], [right]) if type(relation) in _COMPARISONS:
                return _COMPARISONS[type(relation)](self.read(left, depth), self.read(right, depth))
        known = [*self.names.items(), *self.calls.items(), *_CHOICES.items()]
        allowed = ", ".join({thing: name for name, thing in known}.values())  # of several names the last
        signs = "numbers (named a=1), +-*/%^"
        raise self.refused(f"{self.text_of(node)[:60]!r} is none of {signs}, {allowed}; {_HINT}")

    @contextmanager
    def choice(self, parts: int) -> Iterator[None]:
        """Enter a choice of so many parts: nested choices multiply. Raises ValueError above MOST_CHOICES."""
        self.choices += max(1, parts * (parts - 1)) * 2**self.inside
        if self.choices > MOST_CHOICES:
            raise self.refused(f"it has too many choices by {', '.join(_CHOICES)}, some inside others")
        self.inside += 1
        yield
        self.inside -= 1

    def _chained(self, node, join, part_from, inverse, depth):
        """Return the terms of a sum, or the factors of a product: all at once, or SymPy would multiply some out."""
        parts = []
        while isinstance(node, ast.BinOp) and isinstance(node.op, (join, part_from)):
            part = self.read(node.right, depth)
            parts.append(part if isinstance(node.op, join) else inverse(part))
            node = node.left
        if join is ast.Mult and isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            parts.append(S.NegativeOne)
            node = node.operand
        return [self.read(node, depth), *reversed(parts)]

    def _power(self, power, node):
        """Return the exponent of a node, or refuse it."""
        if not (power.is_Rational and abs(power) <= LARGEST_POWER):
            raise self.refused(f"a power in {self.text_of(node)[:60]} is no number of at most {LARGEST_POWER}")
        return power

    def _bounded(self, value, node):
        """Return a node's value, or refuse it: numbers and powers have to be small, and all real and finite."""
        for part in (value, *value.args):
            if part.is_Rational and max(abs(part.p), part.q) > LARGEST_NUMBER:
                raise self.refused(f"{self.text_of(node)[:60]} has a number above 2**256")
            if part.is_Pow:
                self._power(part.exp, node)
        if value.has(S.NaN, S.ComplexInfinity, S.Infinity, S.NegativeInfinity, S.ImaginaryUnit):
            raise self.refused(f"{self.text_of(node)[:60]} is no real number")
        return value


class _Writer(StrPrinter):
    """A printer of products by factors, as they are read: 1/4/(v + 3), where 1/(4*(v + 3)) would be multiplied out."""

    def _print_Mul(self, expr):
        first, *factors = expr.args if expr.args[0].is_Rational else (S.One, *expr.args)
        text = str(first)
        for factor in factors:
            below = factor.is_Pow and factor.exp.is_Rational and factor.exp.is_negative
            part = self.parenthesize(1 / factor if below else factor, PRECEDENCE["Mul"], strict=not below)
            text += f"/{part}" if below else f"*{part}"
        return text.removeprefix("1*") if first == 1 else text.replace("-1*", "-", 1) if first == -1 else text


@cache
def _operations(expression: Basic) -> int:
    """Return about how many operations a kernel needs for an expression; a whole power counts as its products."""
    if expression.is_Pow and expression.exp.is_Integer:
        return abs(int(expression.exp)) * (1 + _operations(expression.base))
    return sum(map(_operations, expression.args)) + (OF_A_FUNCTION if isinstance(expression, Function) else 1)


def check_operations(name: str, value: object, expressions: Iterable[Basic]) -> None:
    """Raise ValueError, with an argument's name and value, where expressions have too many operations for a kernel."""
    if (count := sum(map(_operations, expressions))) > MOST_OPERATIONS:
        raise not_allowed(name, value, f"at most {MOST_OPERATIONS} operations, slopes included, and here are {count}")


def remainder(number: Expr, divisor: Expr) -> Expr:
    """Return what is left of a number by a divisor, with the divisor's sign."""
    return number - divisor * floor(number / divisor)


@evaluated
def parse_expression(text: str, names: Mapping[str, Symbol], calls: Mapping[str, Callable] = {}) -> Expr:
    """Return the SymPy expression of a text: numbers, names, π, e, + - * / % ** and the functions that have kernels.

    calls: further functions, which make an expression of those.

    A decimal is the exact fraction that it says. Raises ValueError, in one sentence, on anything else.
    """
    if not isinstance(text, str):
        raise not_allowed("expression", text, "a text")
    return _Reader(text.strip(), names, calls).expression()


def expression_text(expression: Expr, names: Mapping[str, Symbol]) -> str:
    """Return the text that `parse_expression` reads as the expression. Raises ValueError where there is none."""
    text = _Writer().doprint(expression)
    if parse_expression(text, names) != expression:
        raise not_allowed("expression", text[:60], "one that is as SymPy evaluates it, which a text can say")
    return text
