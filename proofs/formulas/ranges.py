"""Intervals that enclose a height field over a box of its symbols, the operations that it may have, and its values."""

import operator
from collections.abc import Callable, Iterable, Mapping
from functools import reduce

from mpmath import iv
from sympy import Add, Basic, Expr, Mul, Piecewise, Pow, S, Symbol, lambdify, pi
from sympy.core.relational import Relational
from sympy.functions.elementary.piecewise import ExprCondPair

from proofs.engine.functions import FUNCTIONS, hull
from proofs.engine.registry import shown

ENCLOSURES = {
    Add: lambda *parts: sum(parts),
    Mul: lambda *parts: reduce(operator.mul, parts),
    Pow: operator.pow,
    Piecewise: hull(min, max),
    **{function.made: function.enclosed for function in FUNCTIONS if function.enclosed},
}
"""{operation of height fields: the same of intervals}; of a selection, the hull of its values"""


LARGEST = 2.0**1000  # a larger number may be no float64
DIGITS = 100


def values_of(expression: Expr, symbols: Iterable[Symbol]) -> Callable[..., float]:
    """Return an expression that is finite as a function of numbers, by mpmath: SymPy takes long where calls are nested.

    The numbers are made within its digits, which `mpmath.workdps` says.
    """
    return lambdify([*symbols], expression, "mpmath")


def enclosure(expression: Basic, box: Mapping[Symbol, iv.mpf]) -> iv.mpf:
    """Return an interval around every value of the expression in a box.

    Raises ValueError where a part of it is not shown to be real and finite, and where it is made of more than the
    symbols, rationals, π and `ENCLOSURES`. Powers are whole, or square roots; the last of a Piecewise is for all else.
    """
    if expression in box:
        return box[expression]
    if expression == pi:
        return iv.pi
    if isinstance(expression, Basic) and expression.is_Rational:
        if max(abs(expression.p), expression.q) >= LARGEST:
            raise ValueError(f"{shown(expression)} has a number that no float64 is near")
        return iv.mpf(expression.p) / expression.q
    if isinstance(expression, ExprCondPair):
        for relation in expression.cond.atoms(Relational):
            enclosure(relation.lhs - relation.rhs, box)
        return enclosure(expression.expr, box)
    kind = getattr(expression, "func", type(expression))
    if kind not in ENCLOSURES or (kind is Pow and not (expression.exp.is_Integer or abs(expression.exp) == S.Half)):
        raise ValueError(f"no kernel has {kind.__name__} as in {shown(expression)}")
    if kind is Piecewise and expression.args[-1].cond != True:  # noqa: E712  (SymPy's true is not Python's)
        raise ValueError(f"{shown(expression)} has no last value, for all else")
    parts = [enclosure(part, box) for part in expression.args]
    if kind is Pow and not expression.exp.is_Integer and not parts[0].a >= 0:
        raise ValueError(f"on the chart {shown(expression)} is not shown to be real")
    interval = ENCLOSURES[kind](*parts)
    if not abs(interval).b < LARGEST:
        raise ValueError(f"on the chart {shown(expression)} is not shown to be finite")
    return interval
