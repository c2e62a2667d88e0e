"""The second witness: the claims themselves, as SymPy states them, evaluated at random points with 50 digits.

It knows nothing of the kernel, of certificates, or of the translation into polynomials. A fixed seed for each claim.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import mpmath
from sympy import Symbol

from proofs.engine.claim import Claim, Induction
from proofs.engine.theorem import Point
from verify.checkers.digits import DIGITS, WORKING_DIGITS, Code, Relations, Undefined
from verify.checkers.sampler import Sampler

NUMBERS = 13


@dataclass
class Witness:
    """The samples of a claim: how many points satisfied its hypotheses, and at which its conclusion is false, or
    undefined, as is a quotient by 0."""

    points: int = 0
    failures: list = field(default_factory=list)
    undefined: list = field(default_factory=list)

    @property
    def smallest(self) -> Any:
        """The failing point that is shortest to write down, {symbol: value}, or None."""
        return min(self.failures, key=length, default=None)


def length(point: Mapping[Symbol, mpmath.mpf]) -> tuple[int, str]:
    """Return how long a point is to write down, as a key to sort by."""
    return sum(len(mpmath.nstr(value, 20)) for value in point.values()), str(point)


def printed(point: Mapping[Symbol, mpmath.mpf], digits: int = DIGITS) -> dict[str, str]:
    """Return a point as {name: its digits}."""
    return {str(s): mpmath.nstr(v, digits) for s, v in sorted(point.items(), key=lambda p: str(p[0]))}


def sample(
    claim: Claim | Induction,
    seed: str | int,
    points: int = 64,
    failures: int | None = None,
    attempts: int = 200,
    digits: int = WORKING_DIGITS,
) -> Witness:
    """Return the Witness of a claim at `points` random points that satisfy its hypotheses (or until `failures`)."""
    if isinstance(claim, Induction):
        return _sample_induction(claim, seed, points, attempts)
    with mpmath.workdps(digits):
        sampler, witness = Sampler(claim, seed), Witness()
        for _ in range(points * attempts):
            try:
                values = sampler.inputs_at_random()
            except mpmath.libmp.NoConvergence:  # a root that is a double one
                break
            verdict = None if values is None else sampler.verdict(values)
            if verdict is None:
                continue
            witness.points += 1
            if verdict != "holds":
                (witness.failures if verdict == "fails" else witness.undefined).append(values)
            if witness.points >= points or len(witness.failures) >= (failures or points):
                break
        return witness


def _sample_induction(claim, seed, points, attempts):
    """Sample an Induction as claims of the first numbers n."""
    witness = Witness()
    for number in range(NUMBERS):
        one = sample(claim.of(number), f"{seed}/{number}", -(-points // NUMBERS), attempts=attempts)
        witness.points += one.points
        witness.failures += [{claim.n: mpmath.mpf(number)} | point for point in one.failures]
        witness.undefined += one.undefined
    return witness


def _exact(point):
    """Return {symbol: 50-digit value} of ((symbol, exact value), …)."""
    return {s: Code((v,))({})[0] for s, v in point}


def outcome(claim: Claim, at: Point) -> str:
    """Return "holds", "fails" or "undefined" for the conclusions at values of the inputs; hypotheses are not asked."""
    with mpmath.workdps(WORKING_DIGITS):
        values = _exact(at)
        _, lines = claim.names()
        try:
            return "holds" if Relations(claim.shows, lines.definitions if lines else ())(values) else "fails"
        except Undefined:
            return "undefined"


def fails_at(claim: Claim, at: Point, attempts: int = 500) -> dict | None:
    """Return a point with the given coordinates where the hypotheses hold and a conclusion does not, or None."""
    with mpmath.workdps(WORKING_DIGITS):
        sampler, fixed = Sampler(claim, "fails_at"), _exact(at)
        for _ in range(attempts):
            values = sampler.inputs_at_random(fixed)
            if values is not None and sampler.verdict(values) == "fails":
                return values
        return None
