"""Counterexamples of false variants: a point at 50 digits, and where it can be had an exact one."""

from fractions import Fraction

import mpmath

from proofs.engine.claim import Separation
from proofs.engine.counterexample import refutation
from proofs.engine.statement import derivations
from proofs.engine.theorem import borrowed
from verify.checkers import witness

FAILURES = 6
EFFORTS = (
    (60, 20),
    (400, 200),
)  # points that satisfy the hypotheses, and draws for each: a short look, then a long one


def counterexample(mutant, seed, theorems, refused):
    """Return {"exact": bool, "at": {name: text}} where a mutant fails, the simplest that was found, or None.

    refused(statement, certificate): None if both checkers accept the pair.
    """
    if isinstance(mutant.claim, Separation):
        path = path_to_avoided(mutant.claim)
        return None if path is None else {"exact": True, "at": {"path": " → ".join(path)}}
    if mutant.at:
        failing = witness.fails_at(mutant.claim, mutant.at)
        failures = [failing] if failing else []
    else:
        for points, attempts in EFFORTS:
            failures = witness.sample(mutant.claim, seed, points, failures=FAILURES, attempts=attempts).failures
            if failures:
                break
    if not failures:
        return None
    exact = exact_counterexample(mutant.claim, failures, theorems, refused)
    if exact is not None:
        return {"exact": True, "at": exact}
    return {"exact": False, "at": witness.printed(witness.Witness(1, failures).smallest)}


def exact_counterexample(claim, failures, theorems, refused):
    """Return a rational point, {name: text}, near one of the failures, that both checkers accept, or None."""
    if not hasattr(claim, "lines"):
        return None
    statements = derivations(borrowed(claim, theorems))
    for point in sorted(failures, key=witness._length):
        rational = {str(s): _rational(v) for s, v in point.items()}
        if all(q is not None for q in rational.values()):
            pair = refutation(statements, rational)
            if pair is not None and refused(*pair) is None:
                return {name: str(q) for name, q in sorted(rational.items())}
    return None


def _rational(value):
    """Return the Fraction of small denominator that a 50-digit number is, or None."""
    with mpmath.workdps(witness.WORKING_DIGITS):
        q = Fraction(mpmath.nstr(value, 40)).limit_denominator(10**4)
        return q if abs(value - mpmath.mpf(q.numerator) / q.denominator) < witness.TOLERANCE else None


def path_to_avoided(claim):
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
