"""A straight-line program run in ball arithmetic: each line a midpoint and a radius that enclose its exact value.

At a few hundred bits the balls are a reference that says itself how good it is. A selection that they do not decide
takes both branches.
"""

from collections.abc import Callable, Mapping
from functools import reduce

from flint import arb, ctx, fmpq

from proofs.engine.functions import FUNCTIONS
from verify.evaluate import ANY_NUMBERS, Evaluator, compare


def power(base: arb, exponent: arb) -> arb:
    """Return base^exponent for base ≥ 0 by its meaning, exponent > 0; a ball that reaches below 0 is cut off there."""
    if base > 0:
        return base**exponent
    high = base.upper()
    return arb(0).union(high**exponent) if high > 0 else arb(0)


def root(value: arb) -> arb:
    """Return √value; a ball that reaches below 0 is cut off there, and one below 0 has none."""
    high = value.upper()
    return arb(0).union(high.sqrt()) if high > 0 and not value > 0 else value.sqrt()


def where(condition: bool | None, value: Callable[[], arb], otherwise: Callable[[], arb]) -> arb:
    """Return what is selected, or a ball around both."""
    return value().union(otherwise()) if condition is None else value() if condition else otherwise()


BALLS = ANY_NUMBERS | {
    **{f.kernel: getattr(arb, f.arb or f.kernel) for f in FUNCTIONS if hasattr(arb, f.arb or f.kernel)},
    "sin": arb.sin,
    "cos": arb.cos,
    "rational": lambda p, q: arb(fmpq(p, q)),
    "compare": compare,
    "where": where,
    "sqrt": root,
    "power": power,
    "rint": lambda x: (x + 0.5).floor(),
    "binary_exponent": lambda x: arb(x.mid().man_exp()[1] + x.mid().man_exp()[0].bit_length() - 1),
    "power_of_two": lambda n: arb(2) ** n,
    "maximum": lambda *values: reduce(arb.max, values),
    "minimum": lambda *values: reduce(arb.min, values),
    "inf": arb.pos_inf(),
    "atan2pi": lambda y, x: arb(0) if y.is_zero() and x.is_zero() else arb.atan2(y, x) / arb.pi(),
}
"""The functions that the text calls, at flint's working precision; `pi` is an evaluation's own."""


class Balls(Evaluator):
    """A program in balls: called with {name: number or ball}, it returns {name: ball} of all."""

    def __call__(self, values: Mapping[str, float | arb], bits: int) -> dict[str, arb]:
        with ctx.workprec(bits):
            return self.run({name: arb(values[name]) for name in self.inputs}, BALLS | {"pi": arb.pi()})
