"""A straight-line program run in ball arithmetic: each line a midpoint and a radius that enclose its exact value.

At a few hundred bits the balls are a reference that says itself how good it is; at 53 bits their radius bounds what
rounding can do to the same lines. A selection that the balls do not decide takes both branches, and is named.
"""

from collections.abc import Mapping
from functools import reduce

import mpmath
from flint import arb, ctx, fmpq

from verify.evaluate import Evaluator, ExactPrinter


class _BallPrinter(ExactPrinter):
    """Comparisons of balls may be undecided; a condition stands in parentheses, as a kernel's does."""

    def select(self, condition, value, otherwise):
        return f"select({condition}, lambda: {value}, lambda: {otherwise})"

    def _print_And(self, expr, decisive=False):
        return f"(joined({decisive}, {', '.join(self._print(part) for part in sorted(expr.args, key=str))}))"

    def _print_Or(self, expr):
        return self._print_And(expr, decisive=True)

    def _print_Relational(self, expr):
        return f"(compare({self._print(expr.lhs)}, {expr.rel_op!r}, {self._print(expr.rhs)}))"


_OPERATORS = {"<": ("__lt__", "__ge__"), "<=": ("__le__", "__gt__"), ">": ("__gt__", "__le__"),
              ">=": ("__ge__", "__lt__"), "==": ("__eq__", "__ne__"), "!=": ("__ne__", "__eq__")}  # fmt: skip


def compare(left: arb, operator: str, right: arb) -> bool | None:
    """Return True, False, or None where the balls leave it open."""
    holds, fails = _OPERATORS[operator]
    if getattr(left, holds)(right):
        return True
    return False if getattr(left, fails)(right) else None


def joined(decisive: bool, *conditions: bool | None) -> bool | None:
    """Return the conjunction of True, False and None, which one False decides, or the disjunction: one True."""
    return decisive if decisive in conditions else (None if None in conditions else not decisive)


def ball_of(number: mpmath.mpf) -> arb:
    """Return an mpf as a ball of its exact value."""
    negative, mantissa, exponent, _ = number._mpf_
    return arb((-int(mantissa) if negative else int(mantissa), int(exponent)))


def power(base: arb, exponent: arb) -> arb:
    """Return base^exponent for base ≥ 0 by its meaning, exponent > 0; a ball that reaches below 0 is cut off there."""
    if base > 0:
        return base**exponent
    high = base.upper()
    return arb(0).union(high**exponent) if high > 0 else arb(0)


def root(value: arb) -> arb:
    """Return √value likewise; there is none of a ball below 0."""
    high = value.upper()
    return arb(0).union(high.sqrt()) if high > 0 and not value > 0 else value.sqrt()


NAMES = {
    "rational": lambda p, q: arb(fmpq(p, q)),
    "compare": compare,
    "joined": joined,
    "sqrt": root,
    "power": power,
    "exp": arb.exp,
    "log": arb.log,
    "floor": arb.floor,
    "rint": lambda x: (x + 0.5).floor(),
    "maximum": lambda *values: reduce(arb.max, values),
    "minimum": lambda *values: reduce(arb.min, values),
    "inf": arb.pos_inf(),
    "sin": arb.sin,
    "cos": arb.cos,
    "sinpi": arb.sin_pi,
    "cospi": arb.cos_pi,
    "atan2pi": lambda y, x: arb(0) if y.is_zero() and x.is_zero() else arb.atan2(y, x) / arb.pi(),
}
"""What the text calls, at flint's working precision; `select`, `sign` and `pi` are an evaluation's own."""


class Balls(Evaluator):
    """A program in balls: called with {name: float}, it returns ({name: ball} of every line, names left undecided)."""

    printer, names = _BallPrinter(), NAMES

    def __call__(self, values: Mapping[str, float], bits: int = 53) -> tuple[dict[str, arb], frozenset[str]]:
        self.undecided: set[str] = set()
        with ctx.workprec(bits):
            names = self.names | {"pi": arb.pi(), "select": self._select, "sign": self._sign}
            return self.run(names, values, arb), frozenset(self.undecided)

    def _select(self, condition, value, otherwise):
        if condition is None:
            self.undecided.add(self.line)
            return value().union(otherwise())
        return value() if condition else otherwise()

    def _sign(self, value):
        if value > 0 or value < 0 or value.is_zero():
            return value.sgn()
        self.undecided.add(self.line)
        return arb(0, 1)
