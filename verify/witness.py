"""The second witness: the claims themselves, as SymPy states them, evaluated at random points with 50 digits.

It knows nothing of the kernel, of certificates, or of the translation into polynomials. A fixed seed for each claim.
"""

import random
from dataclasses import dataclass, field
from fractions import Fraction
from graphlib import TopologicalSorter

import mpmath
from sympy import And, Eq, Max, Min, Piecewise, Poly, PolynomialError, Rational, sympify
from sympy.printing.pycode import MpmathPrinter

from proofs.claim import Induction

DIGITS = 50
WORKING_DIGITS = DIGITS + 15
TOLERANCE = mpmath.mpf(10) ** -40
SIMPLE = [Fraction(p, q) for q in (1, 2, 3, 4, 5, 13) for p in range(-2 * q, 2 * q + 1)]
_NAMES = {name: getattr(mpmath, name) for name in dir(mpmath) if not name.startswith("_")} | {
    "mpf": mpmath.mpf,
    "rint": mpmath.nint,
    "atan2pi": lambda y, x: mpmath.atan2(y, x) / mpmath.pi if (x, y) != (0, 0) else mpmath.mpf(0),
    "max": max,
    "min": min,
    "abs": abs,
}


class Undefined(ArithmeticError):
    """A division by zero, the root of a negative number, or an infinity."""


class _Printer(MpmathPrinter):
    def _print_Symbol(self, expr):
        return f"v_{expr.name}"


_printer = _Printer({"fully_qualified_modules": False, "allow_unknown_functions": True})


class Code:
    """Definitions and expressions over some inputs, printed as one Python function of 50-digit numbers."""

    def __init__(self, inputs, expressions, definitions=()):
        self.inputs = list(inputs)
        body = [f"v_{s.name} = {_printer.doprint(e)}" for s, e in definitions]
        body.append(f"return [{', '.join(_printer.doprint(sympify(e)) for e in expressions)}]")
        arguments = ", ".join(f"v_{s.name}" for s in self.inputs)
        scope = dict(_NAMES)
        exec(f"def code({arguments}):\n    " + "\n    ".join(body), scope)
        self.code = scope["code"]

    def __call__(self, values):
        """Return the expressions' real values, or raise Undefined."""
        try:
            results = [mpmath.mpmathify(r) for r in self.code(*(values[s] for s in self.inputs))]
        except (ZeroDivisionError, ValueError, TypeError) as error:
            raise Undefined(str(error)) from None
        if not all(isinstance(r, mpmath.mpf) and mpmath.isfinite(r) for r in results):
            raise Undefined("complex or infinite")
        return results


def _parts(relations):
    """Return the single relations of conjunctions, the true ones left out."""
    flat = [part for r in relations for part in (r.args if isinstance(r, And) else (r,))]
    return [part for part in flat if part != True]  # noqa: E712  (SymPy's true is not Python's)


class Relations:
    """Relations over inputs and definitions, as code: called with values, whether all of them hold, to 40 digits.

    exactly: inequalities hold without that tolerance, as what is given has to.
    """

    def __init__(self, inputs, relations, definitions=(), exactly=False):
        self.slack = 0 if exactly else TOLERANCE
        self.parts = _parts(relations)
        sides = [side for r in self.parts for side in ((0, 1) if r == False else (r.lhs, r.rhs))]  # noqa: E712
        self.code = Code(inputs, sides, definitions)
        self.operators = ["==" if r == False else r.rel_op for r in self.parts]  # noqa: E712

    def __call__(self, values):
        sides = self.code(values)
        return all(
            _holds(op, a, b, self.slack) for op, a, b in zip(self.operators, sides[::2], sides[1::2], strict=True)
        )


def _holds(operator, left, right, tolerance):
    gap, size = left - right, 1 + abs(left) + abs(right)
    return {
        "==": abs(gap) <= TOLERANCE * size,
        "!=": abs(gap) > TOLERANCE * size,
        ">": gap > 0,
        ">=": gap >= -tolerance * size,
        "<": gap < 0,
        "<=": gap <= tolerance * size,
    }[operator]


@dataclass
class Witness:
    """What sampling a claim showed: how many points satisfied its hypotheses, and where its conclusion failed."""

    points: int = 0
    failures: list = field(default_factory=list)

    @property
    def smallest(self):
        """The failing point that is shortest to write down, {symbol: value}, or None."""
        return min(self.failures, key=_length, default=None)


def _length(point):
    return sum(len(mpmath.nstr(value, 20)) for value in point.values()), str(point)


def printed(point, digits=DIGITS):
    """Return a point as {name: text}."""
    return {str(s): mpmath.nstr(v, digits) for s, v in sorted(point.items(), key=lambda p: str(p[0]))}


class Sampler:
    """Random points for a claim: its inputs, with the equations among its givens solved for one symbol each."""

    def __init__(self, claim, seed):
        self.random, self.ranges = random.Random(seed), dict(claim.ranges)
        used, lines = claim.names()
        definitions = lines.definitions if lines else ()
        defined = {s for s, _ in definitions}
        self.inputs = sorted((used | set(lines.inputs if lines else ())) - defined, key=lambda s: s.name)
        early = [r for r in claim.given if not r.free_symbols & defined]
        self.early = Relations(self.inputs, early, exactly=True)
        equations = [_written_out(r, definitions) for r in claim.given if isinstance(r, Eq)]
        self.late = Relations(self.inputs, [r for r in claim.given if r.free_symbols & defined], definitions, True)
        self.shows = Relations(self.inputs, claim.shows, definitions)
        self.solved = _solvable([r for r in equations if not r.free_symbols & defined])
        self.pools = {s: self._pool(s) for s in self.inputs}

    def _pool(self, symbol):
        low, high = self.ranges.get(symbol, (Rational(1, 4) if symbol.is_positive else -3, 3))
        low, high = (Fraction(str(Rational(end))) for end in (low, high))
        simple = [mpmath.mpf(q.numerator) / q.denominator for q in SIMPLE if low <= q <= high]
        ends = [mpmath.mpf(q.numerator) / q.denominator for q in (low, high)]
        return simple, ends, (int(low), int(high)) if symbol.is_integer else None

    def _draw(self, symbol):
        simple, (low, high), whole = self.pools[symbol]
        if whole:
            return mpmath.mpf(self.random.randint(*whole))
        if simple and self.random.random() < 0.5:
            return self.random.choice(simple)
        return low + (high - low) * mpmath.ldexp(self.random.getrandbits(200), -200)

    def inputs_at_random(self, fixed=()):
        """Return values of the inputs that satisfy the givens about inputs, with some of them fixed, or None."""
        values, solved = dict(fixed), {symbol for symbol, _ in self.solved}
        for symbol in self.inputs:
            if symbol not in solved and symbol not in values:
                values[symbol] = self._draw(symbol)
        for symbol, coefficients in self.solved:
            if symbol not in values:
                roots = _real_roots(coefficients(values))
                if not roots:
                    return None
                values[symbol] = self.random.choice(roots)
        try:
            return values if self.early(values) else None
        except Undefined:
            return None

    def fails_at(self, values):
        """Return None if the other givens fail at the inputs, else whether a conclusion fails or is undefined."""
        try:
            return not self.shows(values) if self.late(values) else None
        except Undefined:
            return True


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
    """Return [(symbol, code of the coefficients of an equation in it)], each after those that it needs."""
    solved, needs = {}, {}
    for relation in relations:
        if not isinstance(relation, Eq):
            continue
        for symbol in sorted(relation.free_symbols - solved.keys(), key=lambda s: s.name, reverse=True):
            others = relation.free_symbols - {symbol}
            if symbol in _reached(others, needs):
                continue
            try:
                coefficients = Poly(relation.lhs - relation.rhs, symbol).all_coeffs()
            except PolynomialError:
                continue
            solved[symbol], needs[symbol] = Code(sorted(others, key=lambda s: s.name), coefficients), others
            break
    order = TopologicalSorter({s: {n for n in needs[s] if n in solved} for s in solved}).static_order()
    return [(symbol, solved[symbol]) for symbol in order]


def _reached(symbols, needs):
    found, pending = set(), list(symbols)
    while pending:
        symbol = pending.pop()
        if symbol not in found:
            found.add(symbol)
            pending += needs.get(symbol, ())
    return found


def _real_roots(coefficients):
    while coefficients and coefficients[0] == 0:
        coefficients = coefficients[1:]
    if len(coefficients) == 2:
        return [-coefficients[1] / coefficients[0]]
    if len(coefficients) == 3:
        a, b, c = coefficients
        d = b * b - 4 * a * c
        return [] if d < 0 else [(-b + s * mpmath.sqrt(d)) / (2 * a) for s in (1, -1)]
    if len(coefficients) < 2:
        return []
    return [r.real for r in mpmath.polyroots(coefficients, maxsteps=200, extraprec=300) if abs(r.imag) < TOLERANCE]


def sample(claim, seed, points=64, failures=None, attempts=200):
    """Return the Witness of a claim at `points` random points that satisfy its hypotheses (or until `failures`)."""
    with mpmath.workdps(WORKING_DIGITS):
        if isinstance(claim, Induction):
            return _sample_induction(claim, seed, points)
        sampler, witness = Sampler(claim, seed), Witness()
        for _ in range(points * attempts):
            values = sampler.inputs_at_random()
            failed = None if values is None else sampler.fails_at(values)
            if failed is None:
                continue
            witness.points += 1
            if failed:
                witness.failures.append(values)
            if witness.points >= points or len(witness.failures) >= (failures or points):
                break
        return witness


def _exact(point):
    """Return {symbol: 50-digit value} of ((symbol, exact value), …)."""
    return {s: Code((), (v,))({})[0] for s, v in point}


def outcome(claim, at):
    """Return "holds", "fails" or "undefined" for the conclusions at the values of the inputs, whatever is given."""
    with mpmath.workdps(WORKING_DIGITS):
        values = _exact(at)
        _, lines = claim.names()
        try:
            return "holds" if Relations(values, claim.shows, lines.definitions if lines else ())(values) else "fails"
        except Undefined:
            return "undefined"


def fails_at(claim, at, attempts=500):
    """Return a point with the given coordinates where the hypotheses hold and a conclusion does not, or None."""
    with mpmath.workdps(WORKING_DIGITS):
        sampler, fixed = Sampler(claim, "fails_at"), _exact(at)
        for _ in range(attempts):
            values = sampler.inputs_at_random(fixed)
            if values is not None and sampler.fails_at(values):
                return values
        return None


def _sample_induction(claim, seed, points):
    rng, witness = random.Random(seed), Witness()
    starts, nexts = ([sympify(e) for e in column] for column in list(zip(*claim.states, strict=True))[1:] or ((), ()))
    states = [s for s, _, _ in claim.states]
    used = set().union(*(e.free_symbols for e in (*claim.shows, *claim.given, *starts, *nexts)))
    inputs = sorted(used - set(states) - {claim.n}, key=lambda s: s.name)
    everything = [*inputs, *states, claim.n]
    given, shows = Relations(inputs, claim.given), Relations(everything, claim.shows)
    start, following = Code(inputs, starts), Code(everything, nexts)
    while witness.points < points:
        values = {s: 4 * mpmath.ldexp(rng.getrandbits(200), -200) - 2 for s in inputs}
        if not given(values):
            continue
        now = start(values)
        for n in range(rng.randint(1, 12) + 1):
            at = values | dict(zip(states, now, strict=True)) | {claim.n: mpmath.mpf(n)}
            witness.points += 1
            if not shows(at):
                witness.failures.append(at)
                break
            now = following(at)
    return witness
