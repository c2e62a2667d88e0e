"""Counterexamples of false variants: a point at 50 digits, certified by balls, and where it can be had an exact one."""

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from typing import Any

import mpmath
from sympy import Eq, Symbol

from proofs.engine.claim import Claim, Induction, Separation
from proofs.engine.counterexample import refutation
from proofs.engine.statement import derivations
from proofs.engine.theorem import Mutant, Theorems, borrowed
from verify.checkers import witness
from verify.checkers.digits import TOLERANCE, WORKING_DIGITS, Code, Undefined, balls, compare, parts_of
from verify.checkers.sampler import Sampler

FAILURES = 6
EFFORTS = ((60, 20), (400, 200))  # points that satisfy the hypotheses, and draws for each: a short look, a long one
BITS = 400


def counterexample(mutant: Mutant, seed: str, theorems: Theorems, refused: Callable) -> dict[str, Any] | None:
    """Return {"exact": bool, "certified": bool, "at": {name: text}} where a mutant fails, or None.

    exact: at the point, a rational one, both checkers accept that the claim is refuted. certified: intervals show that
    it fails at a point with these digits.

    refused(statement, certificate): None if both checkers accept the pair.
    """
    if isinstance(mutant.claim, Separation):
        path = path_to_avoided(mutant.claim)
        return None if path is None else {"exact": True, "certified": True, "at": {"path": " → ".join(path)}}
    failures: list[dict] = []
    if mutant.at:
        failing = witness.fails_at(mutant.claim, mutant.at)  # type: ignore[arg-type]  # no Induction: its mutants give no point
        failures = [failing] if failing else []
    else:
        for points, attempts in EFFORTS:
            failures = failures or witness.sample(mutant.claim, seed, points, FAILURES, attempts).failures
    if not failures:
        return None
    failures.sort(key=witness.length)
    exact, near = None, None
    if not isinstance(mutant.claim, Induction):
        exact = exact_counterexample(mutant.claim, failures, theorems, refused)
        near = exact or next((point for point in failures if certified(Sampler(mutant.claim, seed), point)), None)
    at = exact or witness.printed(near or failures[0])
    return {"exact": exact is not None, "certified": near is not None, "at": at}


def exact_counterexample(
    claim: Claim, failures: Iterable[dict], theorems: Theorems, refused: Callable
) -> dict[str, str] | None:
    """Return a rational point, {name: text}, near one of the failures, that both checkers accept, or None."""
    statements = derivations(borrowed(claim, theorems).but(cited=()))
    for point in failures:
        rational = {s: _rational(v) for s, v in point.items()}
        if all(q is not None for q in rational.values()):
            pair = refutation(statements, rational)
            if pair is not None and refused(*pair) is None:
                return {s.name: str(q) for s, q in sorted(rational.items(), key=str)}
    return None


def _rational(value):
    """Return the Fraction of small denominator that a 50-digit number is, or None."""
    with mpmath.workdps(WORKING_DIGITS):
        q = Fraction(mpmath.nstr(value, 40)).limit_denominator(10**4)
        return q if abs(value - mpmath.mpf(q.numerator) / q.denominator) < TOLERANCE else None


def certified(sampler: Sampler, point: Mapping[Symbol, Any]) -> bool:
    """Return whether balls, with every rounding in them, show that a claim fails near a 50-digit point {symbol: value}.

    The free inputs are taken as they are, exactly; what the sampler solved for is solved again, by formulas, so that
    its ball holds a solution. Equations that it did not solve decide nothing: then the answer is no.
    """
    try:
        from flint import arb, ctx
    except ImportError:  # no python-flint: then no counterexample is certified
        return False
    with ctx.workprec(BITS):
        names, solved = balls(), dict(sampler.solved)
        values = {s: arb(v) for s, v in point.items() if s not in solved}

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
                values[symbol] = _root(code(values), arb(point[symbol]))
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


def path_to_avoided(claim: Separation) -> list[str] | None:
    """Return the shortest list of names from an output of a Separation to a name that it should avoid, or None."""
    uses = {s: sorted(e.free_symbols, key=str) for s, e in claim.lines.definitions}
    paths, seen = [[s] for s in claim.outputs], set(claim.outputs)
    for path in paths:
        if path[-1] in claim.avoid:
            return [s.name for s in path]
        for name in uses.get(path[-1], []):
            if name not in seen:
                seen.add(name)
                paths.append([*path, name])
    return None
