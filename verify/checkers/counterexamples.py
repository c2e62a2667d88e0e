"""Counterexamples of false variants: a point at 50 digits, certified by balls, and an exact one where there is one."""

import operator
from collections.abc import Collection, Iterable, Mapping
from fractions import Fraction
from typing import Any

import mpmath
from sympy import Eq, Symbol

from proofs.engine import kernel
from proofs.engine.claim import Claim, Induction, Separation
from proofs.engine.counterexample import refutation
from proofs.engine.derivative import Untranslatable
from proofs.engine.stored import each_shown
from proofs.engine.theorem import Mutant
from verify.checkers import witness
from verify.checkers.digits import TOLERANCE, WORKING_DIGITS, Code, Undefined, decided, parts_of
from verify.checkers.sampler import Sampler, real_roots

try:
    import flint

    from verify.evaluate.balls import BALLS
except ImportError:  # then no counterexample is certified
    flint = None  # type: ignore[assignment]

BITS = 400
FAILURES, UNROLLED = 6, 4  # and the first numbers of which an induction is tried
EFFORTS = ((60, 20), (400, 200))  # points that satisfy the hypotheses, and draws for each: a short look, a long one


def counterexample(mutant: Mutant, seed: str) -> dict[str, Any] | None:
    """Return {"exact": bool, "certified": bool, "at": {name: text}} where a mutant fails, or None.

    exact: at the point, a rational one, the kernel accepts that the claim is refuted. certified: intervals show that
    it fails at a point with these digits. An Induction is refuted as a claim of one number n.
    """
    if isinstance(mutant.claim, Separation):
        path = path_to_avoided(mutant.claim)
        return None if path is None else {"exact": True, "certified": True, "at": {"path": " → ".join(path)}}
    if not isinstance(mutant.claim, Induction):
        return _where_it_fails(mutant.claim, mutant.at, seed)
    for number in range(UNROLLED):
        point = _where_it_fails(mutant.claim.of(number), mutant.at, seed)
        if point:
            return point | {"at": point["at"] | {mutant.claim.n.name: str(number)}}
    return None


def _where_it_fails(claim, at, seed):
    failures: list[dict] = []
    if at:
        failing = witness.fails_at(claim, at)
        failures = [failing] if failing else []
    else:
        for points, attempts in EFFORTS:
            failures = failures or witness.sample(claim, seed, points, FAILURES, attempts).failures
    if not failures:
        return None
    failures.sort(key=witness.length)
    exact = exact_counterexample(claim, failures)
    sampler = Sampler(claim, seed)
    near = exact or next((point for point in failures if certified(sampler, point, dict(at))), None)
    return {
        "exact": exact is not None,
        "certified": near is not None,
        "at": exact or witness.printed(near or failures[0]),
    }


def exact_counterexample(claim: Claim, failures: Iterable[dict]) -> dict[str, str] | None:
    """Return a rational point, {name: text}, near one of the failures, that the kernel accepts, or None."""
    try:
        statements = each_shown(claim)
    except Untranslatable:
        return None
    for point in failures:
        rational = {s: _rational(v) for s, v in point.items()}
        if all(q is not None for q in rational.values()):
            pair = refutation(statements, rational)
            if pair is not None and kernel.check(*pair) is None:
                return {s.name: str(q) for s, q in sorted(rational.items(), key=str)}
    return None


def _rational(value):
    """Return the Fraction of small denominator that a 50-digit number is, or None."""
    with mpmath.workdps(WORKING_DIGITS):
        q = Fraction(mpmath.nstr(value, 40)).limit_denominator(10**4)
        return q if abs(value - mpmath.mpf(q.numerator) / q.denominator) < TOLERANCE else None


def path_to_avoided(claim: Separation) -> list[str] | None:
    """Return the shortest list of names from an output of a Separation to a name that it should avoid, or None."""
    uses = {s: sorted(e.free_symbols, key=str) for s, e in claim.lines.definitions}
    paths, reached = [[s] for s in claim.outputs], set(claim.outputs)
    for path in paths:
        if path[-1] in claim.avoid:
            return [s.name for s in path]
        for name in uses.get(path[-1], []):
            if name not in reached:
                reached.add(name)
                paths.append([*path, name])
    return None


def certified(sampler: Sampler, point: Mapping[Symbol, Any], fixed: Collection[Symbol] = ()) -> bool:
    """Return whether balls, with every rounding in them, show that a claim fails near a 50-digit point {symbol: value}.

    Free and fixed inputs are exact. Those that the sampler solved for are solved for again, by formulas, so that their
    balls hold a solution. Every other equation must hold of exact numbers.
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
