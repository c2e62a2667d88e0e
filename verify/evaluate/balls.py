"""A straight-line program run in ball arithmetic: each line a midpoint and a radius that enclose its exact value.

At a few hundred bits the balls are a reference that says itself how good it is; at 53 bits their radius bounds what
rounding can do to the same lines. A selection that the balls do not decide takes both branches, and is named.
"""

from collections.abc import Mapping
from functools import reduce

import mpmath
from flint import arb, ctx, fmpq

from verify.evaluate import ANY_NUMBERS, Evaluator, compare


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


BALLS = ANY_NUMBERS | {
    **{name: getattr(arb, name) for name in ("floor", "sin", "cos", "exp", "log")},
    "rational": lambda p, q: arb(fmpq(p, q)),
    "compare": compare,
    "sqrt": root,
    "power": power,
    "rint": lambda x: (x + 0.5).floor(),
    "maximum": lambda *values: reduce(arb.max, values),
    "minimum": lambda *values: reduce(arb.min, values),
    "inf": arb.pos_inf(),
    "sinpi": arb.sin_pi,
    "cospi": arb.cos_pi,
    "atan2pi": lambda y, x: arb(0) if y.is_zero() and x.is_zero() else arb.atan2(y, x) / arb.pi(),
}
"""What the text calls, at flint's working precision; `where`, `sign` and `pi` are an evaluation's own."""


class Balls(Evaluator):
    """A program in balls: called with {name: float}, it returns ({name: ball} of all, names left undecided)."""

    def __call__(self, values: Mapping[str, float], bits: int = 53) -> tuple[dict[str, arb], frozenset[str]]:
        self.undecided: set[str] = set()
        with ctx.workprec(bits):
            names = BALLS | {"pi": arb.pi(), "where": self._where, "sign": self._sign}
            return self.run({name: arb(values[name]) for name in self.inputs}, names), frozenset(self.undecided)

    def _where(self, condition, value, otherwise):
        if condition is None:
            self.undecided.add(self.line)
            return value().union(otherwise())
        return value() if condition else otherwise()

    def _sign(self, value):
        if value > 0 or value < 0 or value.is_zero():
            return value.sgn()
        self.undecided.add(self.line)
        return arb(0, 1)
