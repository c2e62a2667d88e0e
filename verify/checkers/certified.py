"""Whether a counterexample of 50 digits is one beyond doubt: its claim over balls, with every rounding in them."""

import operator
from collections.abc import Collection, Mapping
from typing import Any

from sympy import Eq, Symbol

from verify.checkers.digits import Code, Undefined, decided, parts_of
from verify.checkers.sampler import Sampler, real_roots

try:
    import flint

    from verify.evaluate.balls import BALLS
except ImportError:  # then no counterexample is certified
    flint = None  # type: ignore[assignment]

BITS = 400


def certified(sampler: Sampler, point: Mapping[Symbol, Any], fixed: Collection[Symbol] = ()) -> bool:
    """Return whether balls, with every rounding in them, show that a claim fails near a 50-digit point {symbol: value}.

    The free inputs, and those that are fixed, are taken as they are, exactly; what the sampler solved for is solved
    again, by formulas, so that its ball holds a solution. Of other equations each has to hold of exact numbers.
    """
    if flint is None:
        return False
    with flint.ctx.workprec(BITS):
        names = BALLS | {"compare": decided, "real": _real, "pi": flint.arb.pi()}
        names |= {"sqrt": flint.arb.sqrt, "power": operator.pow}  # undefined where a ball reaches below 0
        again = [(s, of) for s, of in sampler.solved if s not in fixed]
        values = {s: flint.arb(v) for s, v in point.items() if s not in dict(again)}

        def holds(relation):
            """Return whether a relation holds, or None where that is open."""
            if relation == False:  # noqa: E712  (SymPy's false is not Python's)
                return False
            try:
                left, right = Code((relation.lhs, relation.rhs), sampler.definitions)(values, names)
                return decided(left, relation.rel_op, right)
            except (Undefined, NameError):
                return None

        def solved(symbol, coefficients):
            """Return a ball with the root that is near the point's coordinate."""
            near = flint.arb(point[symbol])
            return min(real_roots(coefficients(values, names)), key=lambda root: float(abs(root - near).mid()))

        try:
            for symbol, coefficients in again:
                values[symbol] = solved(symbol, coefficients)
        except (Undefined, NameError, ValueError, TypeError):  # no root, or none by a formula
            return False
        solutions = {r for r, symbol in sampler.solved_relations.items() if symbol not in fixed}
        unsolved = [r for r in sampler.given if not (isinstance(r, Eq) and r in solutions)]
        return all(map(holds, unsolved)) and any(holds(r) is False for r in parts_of(sampler.claimed))


def _real(ball):
    if not ball.is_finite():
        raise Undefined("infinite, or of a ball where it has no value")
    return ball
