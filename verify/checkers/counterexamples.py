"""Counterexamples of false variants: a point at 50 digits, certified by balls, and where it can be had an exact one."""

from collections.abc import Iterable
from fractions import Fraction
from typing import Any

import mpmath

from proofs.engine import kernel
from proofs.engine.claim import Claim, Induction, Separation
from proofs.engine.counterexample import refutation
from proofs.engine.derivative import Untranslatable
from proofs.engine.stored import each_shown
from proofs.engine.theorem import Mutant, Theorems
from verify.checkers import witness
from verify.checkers.certified import certified
from verify.checkers.digits import TOLERANCE, WORKING_DIGITS
from verify.checkers.sampler import Sampler

FAILURES, UNROLLED = 6, 4  # and the first numbers of which an induction is tried
EFFORTS = ((60, 20), (400, 200))  # points that satisfy the hypotheses, and draws for each: a short look, a long one


def counterexample(mutant: Mutant, seed: str, theorems: Theorems) -> dict[str, Any] | None:
    """Return {"exact": bool, "certified": bool, "at": {name: text}} where a mutant fails, or None.

    exact: at the point, a rational one, the kernel accepts that the claim is refuted. certified: intervals show that
    it fails at a point with these digits. An Induction is refuted as what it says of one number.
    """
    if isinstance(mutant.claim, Separation):
        path = path_to_avoided(mutant.claim)
        return None if path is None else {"exact": True, "certified": True, "at": {"path": " → ".join(path)}}
    if not isinstance(mutant.claim, Induction):
        return _where_it_fails(mutant.claim, mutant.at, seed, theorems)
    for number in range(UNROLLED):
        seen = _where_it_fails(mutant.claim.of(number), mutant.at, seed, theorems)
        if seen:
            return seen | {"at": seen["at"] | {mutant.claim.n.name: str(number)}}
    return None


def _where_it_fails(claim, at, seed, theorems):
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
    exact = exact_counterexample(claim, failures, theorems)
    sampler = Sampler(claim, seed)
    near = exact or next((point for point in failures if certified(sampler, point, dict(at))), None)
    return {
        "exact": exact is not None,
        "certified": near is not None,
        "at": exact or witness.printed(near or failures[0]),
    }


def exact_counterexample(claim: Claim, failures: Iterable[dict], theorems: Theorems) -> dict[str, str] | None:
    """Return a rational point, {name: text}, near one of the failures, that the kernel accepts, or None."""
    try:
        said = each_shown(claim, theorems)
    except Untranslatable:
        return None
    for point in failures:
        rational = {s: _rational(v) for s, v in point.items()}
        if all(q is not None for q in rational.values()):
            pair = refutation(said, rational)
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
    paths, seen = [[s] for s in claim.outputs], set(claim.outputs)
    for path in paths:
        if path[-1] in claim.avoid:
            return [s.name for s in path]
        for name in uses.get(path[-1], []):
            if name not in seen:
                seen.add(name)
                paths.append([*path, name])
    return None
