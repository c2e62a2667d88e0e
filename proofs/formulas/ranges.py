"""Intervals that enclose a height field over a box of its symbols, the operations that it may have, and its values."""

import operator
from collections.abc import Callable, Iterable, Mapping
from functools import reduce

from mpmath import iv
from sympy import Add, Basic, Expr, Mul, Piecewise, Pow, S, Symbol, atan2, lambdify, pi
from sympy.core.relational import Relational
from sympy.functions.elementary.piecewise import ExprCondPair

from proofs.engine.functions import FUNCTIONS, hull
from proofs.engine.half_turns import atan2pi
from proofs.engine.registry import shown

ENCLOSURES = {
    Add: lambda *parts: sum(parts),
    Mul: lambda *parts: reduce(operator.mul, parts),
    Pow: operator.pow,
    Piecewise: hull(min, max),
    **{function.made: function.enclosed for function in FUNCTIONS if function.enclosed},
}
"""{operation of height fields: the same of intervals}; of a selection, the hull of its values"""
_ADVICE = ": keep what it divides by off 0, and what it takes a root or log of above, as in sqrt(x**2 + 1e-4)"
_CONSTANTS = {pi: iv.pi, S.Exp1: iv.e}

LARGEST = 2.0**1000  # a larger number may be no float64
DIGITS = 100


def values_of(expression: Expr, symbols: Iterable[Symbol]) -> Callable[..., float]:
    """Return an expression that is finite as a function of numbers, by mpmath: SymPy takes long where calls are nested.

    The numbers are made within its digits, which `mpmath.workdps` says.
    """
    return lambdify([*symbols], expression.replace(atan2pi, lambda y, x: atan2(y, x) / pi), "mpmath")


def enclosure(expression: Basic, box: Mapping[Symbol, iv.mpf]) -> iv.mpf:
    """Return an interval around every value of the expression in a box.

    Raises ValueError where a part of it is not shown to be real and finite, and where it is made of more than the
    symbols, rationals, π, e and `ENCLOSURES`. Powers are rational; the last of a Piecewise is for all else.
    """
    if expression in box:
        return box[expression]
    if expression in _CONSTANTS:
        return _CONSTANTS[expression]
    if expression.is_Symbol:
        raise ValueError(f"it has {expression}, and a field no symbols but {', '.join(map(str, box))}")
    if isinstance(expression, Basic) and expression.is_Rational:
        if max(abs(expression.p), expression.q) >= LARGEST:
            raise ValueError(f"{shown(expression)} has a number that no float64 is near")
        return iv.mpf(expression.p) / expression.q
    if isinstance(expression, ExprCondPair):
        for relation in expression.cond.atoms(Relational):
            enclosure(relation.lhs - relation.rhs, box)
        return enclosure(expression.expr, box)
    kind = getattr(expression, "func", type(expression))
    if kind not in ENCLOSURES or (kind is Pow and not expression.exp.is_Rational):
        allowed = ", ".join(function.text or function.kernel for function in FUNCTIONS if function.enclosed)
        raise ValueError(f"no kernel has {kind.__name__} as in {shown(expression)}: write it by {allowed}")
    if kind is Piecewise and expression.args[-1].cond != True:  # noqa: E712  (SymPy's true is not Python's)
        raise ValueError(f"{shown(expression)} has no last value, for all else")
    parts = [enclosure(part, box) for part in expression.args]
    if kind is Pow and not expression.exp.is_Integer and not parts[0].a >= 0:
        raise ValueError(f"on the chart {shown(expression)} is not shown to be real{_ADVICE}")
    interval = ENCLOSURES[kind](*parts)
    if not abs(interval).b < LARGEST:
        raise ValueError(f"on the chart {shown(expression)} of h or a slope is not shown to be finite{_ADVICE}")
    return interval
