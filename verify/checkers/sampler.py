"""Random points that satisfy a claim's hypotheses: the equations among them are solved for one symbol each."""

import random
from collections.abc import Iterable, Mapping
from fractions import Fraction
from graphlib import CycleError, TopologicalSorter

import mpmath
from sympy import Eq, Max, Min, Piecewise, Poly, PolynomialError, Rational, Symbol

from proofs.engine.claim import Claim
from verify.checkers.digits import TOLERANCE, Code, Relations, Undefined, parts_of

MOST_COEFFICIENTS = 9  # of a polynomial whose roots are sought: those of longer ones take minutes
SIMPLE = [Fraction(p, q) for q in (1, 2, 3, 4, 5, 13) for p in range(-2 * q, 2 * q + 1)]


class Sampler:
    """Random points for a claim: its inputs, with the equations among its hypotheses solved for one symbol each."""

    def __init__(self, claim: Claim, seed: str | int):
        self.random, self.ranges = random.Random(seed), dict(claim.ranges)
        used, lines = claim.names()
        definitions = lines.definitions if lines else ()
        defined = {s for s, _ in definitions}
        self.inputs = sorted((used | set(lines.inputs if lines else ())) - defined, key=lambda s: s.name)
        early = [r for r in claim.given if not r.free_symbols & defined]
        self.early = Relations(early, slack=0)
        self.given, self.claimed, self.definitions = parts_of(claim.given), claim.shows, definitions
        equations = {_written_out(r, definitions): r for r in claim.given if isinstance(r, Eq)}
        self.late = Relations([r for r in claim.given if r.free_symbols & defined], definitions, slack=0)
        self.shows = Relations(claim.shows, definitions)
        solvable = _solvable([r for r in equations if not r.free_symbols & defined])
        self.solved = [(symbol, coefficients) for symbol, coefficients, _ in solvable]
        self.solved_relations = {equations[r]: symbol for symbol, _, r in solvable}
        self.pools = {s: self._pool(s) for s in self.inputs}

    def _box(self, symbol):
        """Return the interval for a symbol without a range: by the hypotheses about it alone, else [−3, 3]."""
        ordered = [(r.gts, r.lts) for r in self.given if r.rel_op in ("<", "<=", ">", ">=")]
        low = max((less for more, less in ordered if more == symbol and less.is_Rational), default=None)
        high = min((more for more, less in ordered if less == symbol and more.is_Rational), default=None)
        if low is None:
            return (-3 if high is None or high > -3 else high - 6), (3 if high is None else high)
        return low, max(low + 3, 3) if high is None else high

    def _pool(self, symbol):
        low, high = self.ranges.get(symbol) or self._box(symbol)
        low, high = (Fraction(str(Rational(end))) for end in (low, high))
        simple = [mpmath.mpf(q.numerator) / q.denominator for q in SIMPLE if low <= q <= high]
        ends = [mpmath.mpf(q.numerator) / q.denominator for q in (low, high)]
        return simple, ends

    def _draw(self, symbol):
        simple, (low, high) = self.pools[symbol]
        if simple and self.random.random() < 0.5:
            return self.random.choice(simple)
        return low + (high - low) * mpmath.ldexp(self.random.getrandbits(200), -200)

    def inputs_at_random(self, fixed: Mapping | Iterable[tuple] = ()) -> dict[Symbol, mpmath.mpf] | None:
        """Return values of the inputs that satisfy the hypotheses about inputs, with some of them fixed, or None."""
        values, solved = dict(fixed), {symbol for symbol, _ in self.solved}
        scale = self.random.choice((1,) * 7 + (10, 1000))  # now and then beyond the box
        for symbol in self.inputs:
            if symbol not in solved and symbol not in values:
                values[symbol] = self._draw(symbol) * (1 if symbol in self.ranges else scale)
        try:
            for symbol, coefficients in self.solved:
                if symbol not in values:
                    roots = real_roots(coefficients(values))
                    if not roots:
                        return None
                    values[symbol] = self.random.choice(roots)
            return values if self.early(values) else None
        except Undefined:
            return None

    def verdict(self, values: Mapping[Symbol, mpmath.mpf]) -> str | None:
        """Return "holds", "fails" or "undefined" for the conclusions at the inputs; None if a hypothesis fails."""
        try:
            return None if not self.late(values) else "holds" if self.shows(values) else "fails"
        except Undefined:
            return "undefined"


def _written_out(relation, definitions):
    """Return an equation in the inputs, if all that it uses is defined by rational expressions; else as it stands."""
    expanded = relation
    for symbol, expression in reversed(definitions):
        if symbol in expanded.free_symbols:
            if expression.has(Piecewise, Max, Min):
                return relation
            expanded = expanded.xreplace({symbol: expression})
    return expanded if isinstance(expanded, Eq) else relation


def _solvable(relations):
    """Return [(symbol, code of an equation's coefficients in it, the equation)], each after those that it needs."""
    solved, needs, origin = {}, {}, {}
    for relation in relations:
        if not isinstance(relation, Eq):
            continue
        for symbol in sorted(relation.free_symbols - solved.keys(), key=lambda s: s.name, reverse=True):
            others = relation.free_symbols - {symbol}
            try:
                TopologicalSorter(needs | {symbol: others}).prepare()
                coefficients = Poly(relation.lhs - relation.rhs, symbol).all_coeffs()
            except (CycleError, PolynomialError):
                continue
            if len(coefficients) > MOST_COEFFICIENTS:
                continue
            origin[symbol] = relation
            solved[symbol], needs[symbol] = Code(coefficients), others
            break
    order = TopologicalSorter({s: {n for n in needs[s] if n in solved} for s in solved}).static_order()
    return [(symbol, solved[symbol], origin[symbol]) for symbol in order]


def real_roots(coefficients: list) -> list:
    """Return the real roots of a polynomial of mpf coefficients, or of balls if it is linear or quadratic."""
    while coefficients and coefficients[0] == 0:
        coefficients = coefficients[1:]
    if len(coefficients) == 2:
        return [-coefficients[1] / coefficients[0]]
    if len(coefficients) == 3:
        a, b, c = coefficients
        d = b * b - 4 * a * c
        return [] if d < 0 else [(-b + s * d**0.5) / (2 * a) for s in (1, -1)]
    if len(coefficients) < 2:
        return []
    return [r.real for r in mpmath.polyroots(coefficients, maxsteps=200, extraprec=300) if abs(r.imag) < TOLERANCE]
