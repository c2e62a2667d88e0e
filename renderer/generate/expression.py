"""Formulas as text: read by a list of what is allowed, and written so that they read back as they were.

A text from a file, a command line or a picture may be anybody's. It has to be short and of few letters; Python's parser
makes a tree of it, of which nothing is run: a walk makes SymPy's expression of the nodes that it knows.
"""

import ast
import operator
import re
from collections.abc import Mapping

from sympy import Abs, Add, And, Expr, Max, Min, Mul, Or, Piecewise, Pow, Rational, S, Symbol, exp, log, pi, sign, sqrt

from proofs.engine.program import evaluated
from proofs.formulas.half_turns import cospi, sinpi
from proofs.formulas.symbols import k_u, k_v, u, v
from renderer.checks import not_allowed

LONGEST, DEEPEST, LARGEST_POWER, LARGEST_NUMBER = 2000, 40, 64, 2**256
MOST_CHOICES = 16  # of abs, max, min, sign and Piecewise: SymPy compares all of them with each other
OF_FIELDS: Mapping[str, Symbol] = {symbol.name: symbol for symbol in (u, v, k_u, k_v)}
"""What an expression may be of, unless it says otherwise."""
_OF_ONE = {"sinpi": sinpi, "cospi": cospi, "exp": exp, "log": log, "sqrt": sqrt, "abs": Abs, "Abs": Abs, "sign": sign}
_OF_SEVERAL = {"max": Max, "Max": Max, "min": Min, "Min": Min}
_COMPARISONS = {ast.Lt: operator.lt, ast.LtE: operator.le, ast.Gt: operator.gt, ast.GtE: operator.ge}
_LETTERS = re.compile(r"[A-Za-z0-9_ .,+\-*/()<>=&|]*")
_NUMBER = re.compile(r"(\d+(\.\d*)?|\.\d+)(e[+-]?\d\d?)?")
_BROKEN = (SyntaxError, ValueError, TypeError, ArithmeticError, RecursionError, MemoryError)  # what SymPy may raise too


class _Reader:
    """Reads one text."""

    def __init__(self, text: str, names: Mapping[str, Symbol]):
        self.text, self.names, self.choices = text, {**names, "pi": pi}, 0

    def refused(self, why: str) -> ValueError:
        """Return the error that says so of the text, of which it shows the beginning."""
        return not_allowed("expression", self.text if len(self.text) < 80 else f"{self.text[:60]}...", why)

    def whole(self) -> Expr:
        """Return the expression of the whole text."""
        if len(self.text) > LONGEST:
            raise self.refused(f"a text of at most {LONGEST} letters, and it has {len(self.text)}")
        known = _LETTERS.match(self.text).end()  # type: ignore[union-attr]
        if known < len(self.text):
            raise self.refused(f"no formula has the letter {self.text[known]!r}")
        try:
            tree = ast.parse(self.text, mode="eval")
        except _BROKEN as error:
            raise self.refused(f"it is no formula ({getattr(error, 'msg', type(error).__name__)})") from None
        return self.read(tree.body, 0)

    def said(self, node: ast.expr) -> str:
        """Return the text of a node."""
        return self.text[node.col_offset : node.end_col_offset]

    def read(self, node: ast.expr, depth: int) -> Expr:
        """Return the expression of a node that is so deep in the tree."""
        if depth > DEEPEST:
            raise self.refused(f"it is nested more than {DEEPEST} deep")
        try:
            found = self._of(node, depth + 1)
        except _BROKEN as error:
            if str(error).startswith("expression = "):
                raise
            raise self.refused(f"{self.said(node)[:60]} is not defined") from None
        return self._bounded(found, node)

    def _of(self, node, depth):
        match node:
            case ast.Name(name) if name in self.names:
                return self.names[name]
            case ast.Constant() if _NUMBER.fullmatch(self.said(node)):
                return Rational(self.said(node))
            case ast.UnaryOp(ast.UAdd() | ast.USub() as operation, operand):
                return self.read(operand, depth) * (-1 if isinstance(operation, ast.USub) else 1)
            case ast.BinOp(_, ast.Add() | ast.Sub(), _):
                return Add(*self._chained(node, ast.Add, ast.Sub, lambda part: -part, depth))
            case ast.BinOp(_, ast.Mult() | ast.Div(), _):
                return Mul(*self._chained(node, ast.Mult, ast.Div, lambda part: 1 / part, depth))
            case ast.BinOp(base, ast.Pow(), power):
                return Pow(self.read(base, depth), self._power(self.read(power, depth), node))
            case ast.Call(ast.Name(name), [argument], []) if name in _OF_ONE:
                self._count(name in ("abs", "Abs", "sign"))
                return _OF_ONE[name](self.read(argument, depth))
            case ast.Call(ast.Name(name), [_, _, *_] as arguments, []) if name in _OF_SEVERAL:
                self._count(len(arguments))
                return _OF_SEVERAL[name](*(self.read(argument, depth) for argument in arguments))
            case ast.Call(ast.Name("Piecewise"), [_, *_] as choices, []):
                self._count(len(choices))
                return Piecewise(*(self._choice(choice, depth) for choice in choices))
        allowed = ", ".join([*self.names, *_OF_ONE, *_OF_SEVERAL])
        raise self.refused(f"{self.said(node)[:60]!r} is none of numbers, + - * / **, {allowed} and Piecewise")

    def _count(self, more):
        """Count the choices that a formula has, or refuse it."""
        self.choices += more
        if self.choices > MOST_CHOICES:
            raise self.refused(f"it has more than {MOST_CHOICES} choices by abs, max, min, sign or Piecewise")

    def _chained(self, node, join, part_from, inverse, depth):
        """Return the terms of a sum, or the factors of a product: all at once, or SymPy would multiply some out."""
        parts = []
        while isinstance(node, ast.BinOp) and isinstance(node.op, (join, part_from)):
            part = self.read(node.right, depth)
            parts.append(part if isinstance(node.op, join) else inverse(part))
            node = node.left
        return [self.read(node, depth), *reversed(parts)]

    def _choice(self, node, depth):
        """Return (value, condition) of a Piecewise."""
        match node:
            case ast.Tuple([value, ast.Constant(True)]):
                return self.read(value, depth), S.true
            case ast.Tuple([value, condition]):
                return self.read(value, depth), self._condition(condition, depth)
        raise self.refused(f"{self.said(node)[:60]!r} is no (value, condition)")

    def _condition(self, node, depth):
        if depth > DEEPEST:
            raise self.refused(f"it is nested more than {DEEPEST} deep")
        match node:
            case ast.BinOp(one, ast.BitAnd() | ast.BitOr() as connective, other):
                both = And if isinstance(connective, ast.BitAnd) else Or
                return both(self._condition(one, depth + 1), self._condition(other, depth + 1))
            case ast.Compare(left, [relation], [right]) if type(relation) in _COMPARISONS:
                left, right = self.read(left, depth), self.read(right, depth)
                return _COMPARISONS[type(relation)](left, right)
        raise self.refused(f"{self.said(node)[:60]!r} is no comparison by <, <=, > or >=")

    def _power(self, power, node):
        """Return the exponent of a node, or refuse it."""
        if not (power.is_Integer and abs(power) <= LARGEST_POWER) and abs(power) != S.Half:
            allowed = f"whole and at most {LARGEST_POWER}, or a half"
            raise self.refused(f"a power in {self.said(node)[:60]} is not {allowed}")
        return power

    def _bounded(self, found, node):
        """Return what is found at a node, or refuse it: numbers and powers are small, and all is real and finite."""
        for part in (found, *found.args):
            if part.is_Rational and max(abs(part.p), part.q) > LARGEST_NUMBER:
                raise self.refused(f"{self.said(node)[:60]} has a number above 2**256")
            if part.is_Pow:
                self._power(part.exp, node)
        if found.has(S.NaN, S.ComplexInfinity, S.Infinity, S.NegativeInfinity, S.ImaginaryUnit):
            raise self.refused(f"{self.said(node)[:60]} is no real number")
        return found


@evaluated
def parse_expression(text: str, names: Mapping[str, Symbol] = OF_FIELDS) -> Expr:
    """Return the SymPy expression of a text: numbers, names, π, + - * / ** and the functions that have kernels.

    A decimal is the exact fraction that it says. Raises ValueError, in one sentence, on anything else.
    """
    if not isinstance(text, str):
        raise not_allowed("expression", text, "a text")
    return _Reader(text.strip(), names).whole()


def expression_text(expression: Expr, names: Mapping[str, Symbol] = OF_FIELDS) -> str:
    """Return the text that `parse_expression` reads as the expression. Raises ValueError where there is none."""
    text = str(expression)
    if parse_expression(text, names) != expression:
        raise not_allowed("expression", text[:60], "one that is as SymPy evaluates it, which a text can say")
    return text
