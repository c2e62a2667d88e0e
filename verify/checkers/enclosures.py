"""Certified counterexamples: balls, with every rounding in them, show hypotheses true and a conclusion false."""

from collections.abc import Mapping
from typing import Any

from sympy import Eq, Symbol

from proofs.engine.program import Program
from verify.checkers.digits import Undefined, parts_of
from verify.checkers.sampler import Sampler

try:
    from flint import arb, ctx

    from verify.evaluate.balls import NAMES, Balls, compare
except ImportError:  # no python-flint: then no counterexample is certified
    arb = None  # type: ignore[assignment, misc]

BITS = 400


def certified(sampler: Sampler, point: Mapping[Symbol, Any]) -> bool:
    """Return whether balls show that a claim fails near a 50-digit point {symbol: value} of its sampler.

    The free inputs are taken as they are, exactly; what the sampler solved for is solved again, by formulas, so that
    its ball holds a solution. Equations that it did not solve decide nothing: then the answer is no.
    """
    open_ = [r for r in sampler.given if not (isinstance(r, Eq) and r in sampler.solved_relations)]
    if arb is None or any(isinstance(r, Eq) for r in open_):
        return False
    with ctx.workprec(BITS):
        try:
            solved = dict(sampler.solved)
            values = {s: arb(v) for s, v in point.items() if s not in solved}
            for symbol, coefficients in sampler.solved:
                values[symbol] = _root(_balls(coefficients.expressions, (), values), arb(point[symbol]))
            given, shows = (_decided(r, sampler.definitions, values) for r in (open_, sampler.claimed))
            return given and not shows
        except (Undefined, ValueError, TypeError):
            return False


def _balls(expressions, definitions, values):
    """Return the balls of expressions, or raise Undefined where a selection is not decided or a value not finite."""
    lines = [(Symbol(f"value_of_{i}", real=True), e) for i, e in enumerate(expressions)]
    program = Program("values", tuple(values), (*definitions, *lines), ())
    evaluate = Balls(program)
    evaluate.names = NAMES | {"sqrt": arb.sqrt}  # of a ball that reaches below 0 there is none
    found, undecided = evaluate({s.name: v for s, v in values.items()}, BITS)
    if undecided or not all(ball.is_finite() for ball in found.values()):
        raise Undefined("not decided")
    return [found[symbol.name] for symbol, _ in lines]


def _root(coefficients, near):
    """Return a ball with a root of a linear or quadratic polynomial, the one near a number."""
    if len(coefficients) == 2:
        return -coefficients[1] / coefficients[0]
    a, b, c = coefficients
    root = (b * b - 4 * a * c).sqrt()
    return min(((-b + s * root) / (2 * a) for s in (1, -1)), key=lambda ball: float(abs(ball - near).mid()))


def _decided(relations, definitions, values):
    parts = parts_of(relations)
    if any(r == False for r in parts):  # noqa: E712  (SymPy's false is not Python's)
        return False
    sides = _balls([side for r in parts for side in (r.lhs, r.rhs)], definitions, values)
    found = [compare(a, r.rel_op, b) for r, a, b in zip(parts, sides[::2], sides[1::2], strict=True)]
    if None in found and False not in found:
        raise Undefined("not decided")
    return all(found)
