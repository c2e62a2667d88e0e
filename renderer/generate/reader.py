"""Reader of custom fields' formulas as people write them, in SymPy or as text, and the inverse."""

from collections.abc import Mapping
from functools import partial
from typing import Any

from sympy import (
    Add,
    Expr,
    Float,
    Heaviside,
    Max,
    Min,
    Mod,
    Pow,
    Rational,
    Symbol,
    atan,
    ceiling,
    cos,
    cosh,
    exp,
    floor,
    frac,
    log,
    pi,
    sign,
    sin,
    sinh,
    tan,
    tanh,
)

from proofs.engine.half_turns import atan2pi, cospi, sinpi
from proofs.engine.program import evaluated
from proofs.formulas.symbols import k_u, k_v, u, v
from proofs.printers import text

OF_FIELDS = {symbol.name: symbol for symbol in (u, v, k_u, k_v)}


def _turns(angle):
    """Return an angle in half-turns: each of its terms, so that π goes out of it."""
    return Add(*(term / pi for term in Add.make_args(angle)))


def _clip(x, low, high):
    return Max(low, Min(high, x))


def _smoothstep(low, high, x):
    share = _clip((x - low) / (high - low), 0, 1)
    return share**2 * (3 - 2 * share)


SPELLED: dict[Any, Any] = {
    sin: lambda angle: sinpi(_turns(angle)),
    cos: lambda angle: cospi(_turns(angle)),
    tan: lambda angle: sinpi(_turns(angle)) / cospi(_turns(angle)),
    atan: lambda slope: pi * atan2pi(slope, 1),
    tanh: lambda x: 1 - 2 / (exp(2 * x) + 1),
    sinh: lambda x: (exp(x) - exp(-x)) / 2,
    cosh: lambda x: (exp(x) + exp(-x)) / 2,
    Mod: text.remainder,
    frac: lambda x: x - floor(x),
    ceiling: lambda x: -floor(-x),
    Heaviside: lambda x, *at_0: (1 + sign(x)) / 2,
    Pow: lambda base, power: base**power if power.is_Rational else exp(power * log(base)),
}
"""{function of SymPy: the same by those that have kernels}"""
_CALLS = {made.__name__: spelled for made, spelled in SPELLED.items()}
_CALLS |= {"pow": SPELLED[Pow], "ceil": SPELLED[ceiling], "arctan": SPELLED[atan], "mod": text.remainder}
_CALLS |= {"round": lambda x: floor(x + Rational(1, 2)), "clip": _clip, "clamp": _clip, "fract": SPELLED[frac]}
_CALLS |= {"ln": log, "mix": lambda a, b, share: a + (b - a) * share}
_CALLS |= {"step": lambda edge, x: SPELLED[Heaviside](x - edge), "smoothstep": _smoothstep}
NAMES = {"ku": k_u, "kv": k_v} | OF_FIELDS

parse_expression = partial(text.parse_expression, names=NAMES, calls=_CALLS)
expression_text = partial(text.expression_text, names=OF_FIELDS)


@evaluated
def as_spelled(expression: Expr, names: Mapping[str, Symbol] = NAMES) -> Expr:
    """Return an expression by the functions that have kernels, its symbols the field's of these names, decimals exact.

    A decimal is the shortest that is this float64.
    """
    own = {s: names[name] for s in expression.atoms(Symbol) if (name := s.name) in names and names[name] != s}
    own |= {decimal: Rational(repr(float(decimal))) for decimal in expression.atoms(Float)}
    expression = expression.xreplace(own)
    for made, spelled in SPELLED.items():
        if expression.has(made):
            expression = expression.replace(made, spelled)
    return expression
