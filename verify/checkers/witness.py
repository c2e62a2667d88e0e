"""The second witness: the claims themselves, as SymPy states them, evaluated at random points with 50 digits.

It knows nothing of the kernel, of certificates, or of the translation into polynomials. A fixed seed for each claim.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from operator import sub
from typing import Any

import mpmath
from sympy import Derivative, Mul, Ne, Rational, Symbol, evaluate, factor_list
from sympy.polys.polyerrors import BasePolynomialError

from proofs.engine.claim import CitedLemma, Claim, Induction, equation
from proofs.engine.theorem import Point
from verify.checkers.digits import (
    DIGITS,
    ROUNDING,
    TOLERANCE,
    WORKING_DIGITS,
    Code,
    Relations,
    Undefined,
    differentiated,
)
from verify.checkers.sampler import Sampler

NUMBERS, STARTS, BARREN, LEMMA_DIGITS, EDGE = 13, 12, 256, 150, mpmath.mpf(10) ** -30
STEPS = tuple(sign * Rational(10) ** power for power in (-6, -45, -55) for sign in (1, -1))


@dataclass
class Witness:
    """The samples of a claim: how many points satisfied its hypotheses, where its conclusion is false, where
    it, or a quotient or radical that it is about, is undefined (which is not false)."""

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
    """Return a point as {name: text}."""
    return {str(s): mpmath.nstr(v, digits) for s, v in sorted(point.items(), key=lambda p: str(p[0]))}


def sample(
    claim: Claim | Induction,
    seed: str | int,
    points: int = 64,
    failures: int | None = None,
    attempts: int = 200,
    slack: mpmath.mpf = TOLERANCE,
    digits: int = WORKING_DIGITS,
    barren: float = mpmath.inf,
) -> Witness:
    """Return the Witness of a claim at `points` random points that satisfy its hypotheses (or until `failures`).

    barren: after how many attempts without such a point none is expected.
    """
    if isinstance(claim, Induction):
        return _sample_induction(claim, seed, points, attempts)
    with mpmath.workdps(digits):
        sampler, witness = Sampler(claim, seed, slack), Witness()
        for attempt in range(points * attempts):
            if attempt >= barren and not witness.points:
                break
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
    """Sample what is claimed of each of the first numbers."""
    witness = Witness()
    for number in range(NUMBERS):
        one = sample(claim.of(number), f"{seed}/{number}", -(-points // NUMBERS), attempts=attempts)
        witness.points += one.points
        witness.failures += [{claim.n: mpmath.mpf(number)} | point for point in one.failures]
        witness.undefined += one.undefined
    return witness


def lemma_fails_at(lemma: CitedLemma, seed: str | int, points: int) -> dict | None:
    """Return a point under the source's conditions alone where a lemma is false, or None.

    Tried are points inside, far away and close to 0; where a symbol is 0; on the edge of each condition and beside it;
    and where the two sides are equal, or their difference is least or largest.
    """
    relation, symbols = lemma.relation, sorted(lemma.relation.free_symbols, key=str)
    apart = relation.rel_op in (">", "<", "!=")
    shown = Ne(relation.lhs, relation.rhs, evaluate=False) if apart else relation
    edges = [equation(c.lhs, c.rhs + step) for c in lemma.given for step in (0, *STEPS)]
    claims = [Claim("cited", (relation,), (*lemma.given, *edge)) for edge in ((), *zip(edges))]
    claims += [Claim("cited", (relation,), (*lemma.given, equation(symbol, 0))) for symbol in symbols]
    claims += [Claim("apart", (shown,), (*lemma.given, equation(relation.lhs, relation.rhs)))] if apart else []
    sizes = [Rational(10) ** power for power in (-30, -9, 9, 30)]
    claims += [claims[0].but(ranges=tuple((s, (-size, size)) for s in symbols)) for size in sizes]
    smallest = (sample(claim, seed, points, 1, 50, ROUNDING, LEMMA_DIGITS, BARREN).smallest for claim in claims)
    return next((point for point in smallest if point), None) or _turning_point(lemma, shown, symbols, seed)


def _turning_point(lemma, shown, symbols, seed):
    """Return a point where a lemma is false among those where its sides are equal, or beside, or turn, or None.

    The sides turn along one symbol, or along all at once.
    """
    with mpmath.workdps(LEMMA_DIGITS), evaluate(True):
        sampler = Sampler(Claim("cited", (shown,), lemma.given), seed, ROUNDING)
        difference = _once(lemma.relation.lhs - lemma.relation.rhs)
        slopes = [differentiated(Derivative(difference, symbol)) for symbol in symbols]
        sought = [
            ((symbol,), [of], of is slope)
            for symbol, slope in zip(symbols, slopes, strict=True)
            for of in (difference, slope, difference / slope)  # the last at a root of several, too
            if slope != 0
        ]
        sought += [(symbols, slopes, True)] if len(symbols) > 1 else []
        for along, expressions, turns in sought:
            code = Code([*map(_once, expressions)])
            for values in filter(None, (sampler.inputs_at_random() for _ in range(STARTS))):
                root = _root(code, along, values)
                beside = (
                    [] if turns else [{s: at + (EDGE + abs(at)) * step} for s, at in root.items() for step in STEPS]
                )
                for point in (values | at for at in (root, *beside) if at):
                    if _fails(sampler, lemma.given, point):
                        return point
    return None


def _once(e):
    """Return an expression with each of its factors once, as far as it is a polynomial: near its roots it is steep."""
    try:
        number, factors = factor_list(e)
    except BasePolynomialError:
        return e
    return Mul(number, *(factor for factor, _ in factors))


def _fails(sampler, conditions, values):
    """Return whether what is sampled is false; no nearer to an edge than a root is known, nothing is."""
    try:
        apart = all(abs(sub(*Code((c.lhs, c.rhs))(values))) >= EDGE for c in conditions)
        return apart and sampler.early(values) and sampler.verdict(values) == "fails"
    except Undefined:
        return False


def _root(code, symbols, values):
    """Return the symbols' values where expressions in them are 0, from where they are now on; {} if none is found."""
    starts, step = [values[symbol] for symbol in symbols], mpmath.mpf(1) / 8
    try:
        if len(starts) == 1:
            root = [
                mpmath.findroot(lambda x: code(values | {symbols[0]: x})[0], (*starts, starts[0] + step), tol=1e-120)
            ]
        else:
            root = mpmath.findroot(lambda *x: code(values | dict(zip(symbols, x, strict=True))), starts, tol=1e-120)
        return dict(zip(symbols, root, strict=True))
    except (ValueError, TypeError, ZeroDivisionError, Undefined):  # of a singular system mpmath finds no pivot
        return {}


def _exact(point):
    """Return {symbol: 50-digit value} of ((symbol, exact value), …)."""
    return {s: Code((v,))({})[0] for s, v in point}


def outcome(claim: Claim, at: Point) -> str:
    """Return "holds", "fails" or "undefined" for the conclusions at the values of the inputs, whatever is given."""
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
