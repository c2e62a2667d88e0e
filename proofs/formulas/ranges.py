"""What a height field is made of, and intervals that enclose it where its symbols lie in intervals."""

import operator
from collections.abc import Mapping
from functools import reduce

from mpmath import iv
from sympy import Abs, Add, Expr, Max, Min, Mul, Piecewise, Pow, S, Symbol, exp, log, pi, preorder_traversal, sign
from sympy.functions.elementary.piecewise import ExprCondPair
from sympy.logic.boolalg import Boolean

from proofs.formulas.half_turns import cospi, sinpi

LARGEST = 2.0**1000  # a larger number may be no float64

ENCLOSURES = {
    Add: lambda *parts: sum(parts),
    Mul: lambda *parts: reduce(operator.mul, parts),
    Pow: operator.pow,
    Abs: abs,
    sign: lambda _: iv.mpf([-1, 1]),
    Max: lambda *parts: iv.mpf([max(part.a for part in parts), max(part.b for part in parts)]),
    Min: lambda *parts: iv.mpf([min(part.a for part in parts), min(part.b for part in parts)]),
    Piecewise: lambda *values: iv.mpf([min(value.a for value in values), max(value.b for value in values)]),
    sinpi: lambda turns: iv.sin(iv.pi * turns),
    cospi: lambda turns: iv.cos(iv.pi * turns),
    exp: iv.exp,
    log: iv.log,
}
"""{what a height field is made of: the same of intervals}; of a selection, whichever value is selected"""


def foreign_part(expression: Expr, *symbols: Symbol) -> str | None:
    """Return what a height field is not made of, in words, or None if there is nothing such.

    It is made of `symbols`, rationals, π, comparisons and `ENCLOSURES`; powers are whole or square roots.
    """
    if not isinstance(expression, Expr):
        return f"{expression!r}, which is no expression of SymPy"
    for part in preorder_traversal(expression):
        if part.is_Atom and not (part in (*symbols, pi, S.true) or part.is_Rational):
            return f"{part}, which is none of the symbols {', '.join(map(str, symbols))} nor an exact number"
        if not (part.is_Atom or part.func in ENCLOSURES or isinstance(part, ExprCondPair | Boolean)):
            return f"{part.func.__name__}, which no kernel has"
        if part.is_Pow and not (part.exp.is_Integer or abs(part.exp) == S.Half):
            return f"{part}, whose exponent is neither whole nor ±1/2"
    return None


def enclosure(expression: Expr, box: Mapping[Symbol, iv.mpf]) -> iv.mpf:
    """Return an interval around every value of the expression in a box. ValueError where it may have none."""
    if expression in box:
        return box[expression]
    if expression.is_Atom:
        return iv.pi if expression == pi else iv.mpf(expression.p) / expression.q
    if isinstance(expression, ExprCondPair):
        return enclosure(expression.expr, box)
    return ENCLOSURES[expression.func](*(enclosure(part, box) for part in expression.args))


def unbounded_near(expressions: tuple[Expr, ...], box: Mapping[Symbol, iv.mpf], boxes: int = 1000) -> str | None:
    """Return where in a box an expression is not shown to be finite, or None if all of them are.

    A box that shows nothing is halved along its widest side, `boxes` times at most.
    """
    waiting = [box]
    for _ in range(boxes):
        if not waiting:
            return None
        box = waiting.pop()
        if not all(_is_bounded(expression, box) for expression in expressions):
            widest = max(box, key=lambda symbol: box[symbol].delta)
            low, middle, high = box[widest].a, box[widest].mid, box[widest].b
            waiting += [{**box, widest: iv.mpf(half)} for half in ((low, middle), (middle, high))]
    return ", ".join(f"{symbol} = {float(side.mid):.3g}" for symbol, side in waiting[-1].items())


def _is_bounded(expression, box):
    try:
        return abs(enclosure(expression, box)).b < LARGEST
    except ValueError:  # the logarithm or the root of what may be negative
        return False
