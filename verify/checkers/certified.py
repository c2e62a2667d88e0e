"""Whether a counterexample of 50 digits is one beyond doubt: its claim over balls, with every rounding in them."""

from collections.abc import Mapping
from functools import reduce
from typing import Any

from sympy import Eq, Symbol

from verify.checkers.digits import Code, Undefined, compare, parts_of
from verify.checkers.sampler import Sampler

try:
    import flint
except ImportError:  # then no counterexample is certified
    flint = None  # type: ignore[assignment]

BITS = 400


def certified(sampler: Sampler, point: Mapping[Symbol, Any]) -> bool:
    """Return whether balls, with every rounding in them, show that a claim fails near a 50-digit point {symbol: value}.

    The free inputs are taken as they are, exactly; what the sampler solved for is solved again, by formulas, so that
    its ball holds a solution. Equations that it did not solve decide nothing: then the answer is no.
    """
    if flint is None:
        return False
    with flint.ctx.workprec(BITS):
        names, solved = balls(), dict(sampler.solved)
        values = {s: flint.arb(v) for s, v in point.items() if s not in solved}

        def decided(relation):
            """Return whether a relation holds, or None where that is open."""
            sides = () if relation == False else (relation.lhs, relation.rhs)  # noqa: E712  (SymPy's false)
            try:
                left, right = Code(values, sides, sampler.definitions, names)(values) if sides else (0, 1)
                return compare(left, relation.rel_op if sides else "==", right)
            except (Undefined, NameError):
                return None

        try:
            for symbol, coefficients in sampler.solved:
                code = Code(coefficients.inputs, coefficients.expressions, names=names)
                values[symbol] = _root(code(values), flint.arb(point[symbol]))
        except (Undefined, NameError, ValueError):
            return False
        open_ = [r for r in sampler.given if not (isinstance(r, Eq) and r in sampler.solved_relations)]
        return all(map(decided, open_)) and any(decided(r) is False for r in parts_of(sampler.claimed))


def _root(coefficients, near):
    """Return a ball with a root of a linear or quadratic polynomial, the one near a number."""
    if len(coefficients) == 2:
        return -coefficients[1] / coefficients[0]
    a, b, c = coefficients
    root = (b * b - 4 * a * c).sqrt()
    return min(((-b + s * root) / (2 * a) for s in (1, -1)), key=lambda ball: float(abs(ball - near).mid()))


def balls() -> dict[str, Any]:
    """Return what the code calls over balls, at flint's working precision. Of a ball that reaches below 0 no root."""
    arb = flint.arb

    def real(ball):
        if not arb(ball).is_finite():
            raise Undefined("infinite, or of a ball where it has no value")
        return arb(ball)

    functions = {name: getattr(arb, name) for name in ("sqrt", "sin", "cos", "exp", "log", "floor")}
    return functions | {
        "real": real,
        "compare": compare,
        "mpf": arb,
        "pi": arb.pi(),
        "inf": arb.pos_inf(),
        "sinpi": arb.sin_pi,
        "cospi": arb.cos_pi,
        "atan2pi": lambda y, x: arb(0) if y.is_zero() and x.is_zero() else arb.atan2(y, x) / arb.pi(),
        "max": lambda *values: reduce(arb.max, map(arb, values)),
        "min": lambda *values: reduce(arb.min, map(arb, values)),
    }
