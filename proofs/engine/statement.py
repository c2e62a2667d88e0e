"""Translation of a claim, in SymPy, into statements, data that the kernel checks. This file is trusted.

The rules (`proofs.engine.certificate` has the format). Symbols are plain real ones: a sign, a range, being whole is a
hypothesis. Both sides of a relation are translated as they stand, the factors of a product that is shown as names
(sum_1, …) of their own, so that the kernel multiplies. A quotient becomes an inverse, a radical a root, with their
obligations, before anything cancels: in an angle, too (`proofs.engine.angles`). |a| is √(a²), or ±a where the sign is
given. Max, Min, sign and Piecewise take the branch that is given, and its condition is shown; where none is, the claim
is split into two statements, one with the condition assumed and one with its negation. A Derivative is a name of its
own, for what the rules of `derivative` make of it where they show that it exists. In a relation sign and Piecewise may
be what SymPy made of one: that f ≠ 0 is shown of sign(f), and at the edge of a condition that all values agree. Of π
only 3 < π < 22/7 is used. Anything else is an error, never a guess.
"""

import json
from collections.abc import Iterable, Sequence
from functools import cache
from math import comb, prod
from typing import Any

from sympy import (
    Abs,
    And,
    Basic,
    Derivative,
    Expr,
    Max,
    Min,
    Piecewise,
    Poly,
    Pow,
    Rational,
    S,
    Symbol,
    expand,
    pi,
    sign,
)
from sympy.core.relational import Relational

from proofs.engine.angles import COSINES, SINES, angle_of, angles_in, circle_of, denominators_of, parts_of
from proofs.engine.claim import Claim
from proofs.engine.definitions import Reading
from proofs.engine.derivative import TRUE_FOR, Untranslatable, branch, few, inner, small
from proofs.engine.names import plain, symbols_of
from proofs.engine.program import flat

VERSION = 1
RELATIONS = {frozenset(s): (f, r) for f, r, s in (
    (1, "=", {0}), (1, "!=", {-1, 1}), (1, ">", {1}), (1, ">=", {0, 1}), (-1, ">", {-1}), (-1, ">=", {-1, 0})
)}  # fmt: skip
ANY = {-1, 0, 1}


class _Undecided(Untranslatable):
    """The error that a condition is neither given nor chosen yet."""


def _expanded(expression):
    expression = expand(expression)
    small(max((power.exp for power in expression.atoms(Pow)), default=0))
    return expression


@cache
def polynomial_data(expression: Expr) -> dict[str, str]:
    """Return a polynomial expression in symbols as {"x^2 y": "-3/2"}, sorted."""
    expression = _expanded(expression)
    symbols = sorted(expression.free_symbols, key=lambda s: s.name)
    if not symbols:
        return {} if expression == 0 else {"": str(Rational(expression))}
    data = {}
    for monomial, coefficient in Poly(expression, *symbols, domain="QQ").terms():
        factors = (s.name if e == 1 else f"{s.name}^{e}" for s, e in zip(symbols, monomial, strict=True) if e)
        data[" ".join(factors)] = str(coefficient)
    return dict(sorted(data.items()))


def _keyed(polynomial):
    """Return a key of a polynomial and of its multiples, and the key's sign in it."""
    data = polynomial_data(polynomial)
    leading = Rational(next(iter(data.values()), 1))
    return json.dumps({k: str(Rational(c) / leading) for k, c in data.items()}), 1 if leading > 0 else -1


def _fact(kind, difference, signs):
    """Return the step that assumes or shows the sign of a difference to be one of `signs`."""
    factor, relation = RELATIONS[frozenset(signs)]
    return {"step": kind, "is": relation, "of": polynomial_data(factor * difference)}


class Translation:
    """The steps that some expressions become; `choices` decide the conditions that are not given."""

    def __init__(self, expressions: Iterable[Basic], choices: Sequence[bool] = (), lines: Sequence = ()):
        self.choices, self.lines = list(choices), set(dict(lines))
        self.in_line, self.showing, self.shown = False, False, 0
        self.steps: list[dict] = []
        self.variables: list[str] = []
        self.generators: dict[tuple, Any] = {}
        self.signs: dict[str, set[int]] = {}
        self.abbreviated: dict[Symbol, Expr] = {}
        self.denominators = denominators_of(angles_in(expressions))

    def introduce(self, kind: str, symbol: Symbol, of: Expr) -> None:
        """Add the step that gives a polynomial's "root", its "inverse", or itself a new symbol."""
        self._add({"step": kind, "new": symbol.name, "of": polynomial_data(of)})
        if kind == "define":
            self.abbreviated[symbol] = self._written_out(of)

    def line(self, symbol: Symbol, expression: Expr) -> None:
        """Let a symbol abbreviate what a line of a program defines it to be."""
        self.in_line = True
        self.introduce("define", symbol, self.polynomial(expression))
        self.in_line = False

    def _written_out(self, polynomial):
        """Return the polynomial with its abbreviations written out: equal ones then look the same."""
        for term in polynomial.as_ordered_terms():
            powers = [(self.abbreviated[s], n) for s, n in term.as_powers_dict().items() if s in self.abbreviated]
            small(prod(comb(len(p.as_ordered_terms()) + n - 1, n) for p, n in powers) // 20)
        return _expanded(polynomial.xreplace(self.abbreviated))

    # Relations and signs

    def relation(self, relation: Basic) -> tuple[Expr, set[int]]:
        """Return (left − right, the signs for which the relation holds)."""
        if not isinstance(relation, Relational):
            raise Untranslatable(f"{relation} is not a relation")
        left, right = (self.polynomial(side) for side in (relation.lhs, relation.rhs))
        return left - right, TRUE_FOR[relation.rel_op]

    def _known(self, difference):
        """Return a key of a polynomial and of its multiples, the key's sign in it, and the signs that it may have."""
        written_out = self._written_out(difference)
        key, orientation = _keyed(written_out)
        known = {int(written_out != 0)} if written_out.is_Rational else self.signs.get(key, ANY)
        return key, orientation, {orientation * s for s in known}

    def assume(self, difference: Expr, signs: set[int]) -> None:
        """Add a hypothesis: the sign of `difference` is one of `signs`."""
        key, orientation, possible = self._known(difference)
        self.signs[key] = {orientation * s for s in possible & signs}
        self._add(_fact("assume", difference, signs))

    def show(self, difference: Expr, signs: set[int]) -> None:
        """Add a goal: the sign of `difference` is one of `signs`. Conditions of branches taken become goals, too."""
        fact = _fact("show", difference, signs)
        self.shown += 1
        if fact not in self.steps:
            self._add(fact)

    def _add(self, step):
        self.steps.append(step)
        few(len(self.steps))

    def decide(self, condition: Basic) -> bool:
        """Return whether a condition holds: as given, or else as chosen."""
        parts = sorted(condition.args, key=str) if isinstance(condition, And) else [condition]
        return all(part == S.true or self._decided(*self.relation(part)) for part in parts)

    def _decided(self, difference, wanted):
        _, _, possible = self._known(difference)
        if possible <= wanted or not possible & wanted:
            if not self._written_out(difference).is_Rational:
                self.show(difference, wanted if possible <= wanted else ANY - wanted)
            return possible <= wanted
        if not self.choices:
            raise _Undecided(f"the sign of {difference} is neither given nor chosen")
        choice = self.choices.pop(0)
        self.assume(difference, possible & wanted if choice else possible - wanted)
        return choice

    def _exceeds(self, left, right):
        """Return whether left ≥ right; where they are equal either answer is right."""
        difference = self.polynomial(left) - self.polynomial(right)
        known_below = self._known(difference)[2] <= {-1, 0}
        return not self._decided(difference, {-1, 0}) if known_below else self._decided(difference, {0, 1})

    # Expressions

    def polynomial(self, e: Expr) -> Expr:
        """Return the expression as a polynomial in variables and generators, adding the steps that it needs."""
        if e.is_Rational:
            return e
        if e.is_Symbol or e is pi:
            return self._variable(e)
        parts = sorted(e.args, key=str)
        if e.is_Add:
            return e.func(*map(self.polynomial, parts))
        if e.is_Mul:
            factors = [self.polynomial(a) for a in parts]
            several = sum(not f.is_Rational for f in factors) > 1
            factors = [self._named(f) if several else expand(f) for f in factors]
            small(prod(len(f.as_ordered_terms()) for f in factors))
            return e.func(*factors)
        if e.is_Pow and e.exp.is_Rational and (2 * e.exp).is_Integer:
            base, power = self.polynomial(e.base), 2 * e.exp
            base, power = (base, power / 2) if power % 2 == 0 else (self._generator("root", base), power)
            base = self._named(base)
            small(n := abs(int(power)))
            small(comb(len(base.as_ordered_terms()) + n - 1, n))
            return base**power if power > 0 else self._generator("inverse", base) ** -power
        if isinstance(e, (*COSINES, *SINES)):
            if not e.args[0].is_polynomial():
                self.polynomial(e.args[0])  # for its obligations, before anything cancels
            return self.turned(angle_of(e))[isinstance(e, SINES)]
        if isinstance(e, Abs):
            return self._absolute(e.args[0])
        if isinstance(e, sign):
            return S(self._sign(self.polynomial(e.args[0])) if self.in_line else self._side(e.args[0]))
        if isinstance(e, Max | Min):
            best, *others = parts
            for other in others:
                best = other if self._exceeds(*((other, best) if isinstance(e, Max) else (best, other))) else best
            return self.polynomial(best)
        if isinstance(e, Derivative):
            return self._derivative(e)
        if isinstance(e, Piecewise) and not self.in_line:
            return self._beside(e)
        if isinstance(e, Piecewise):
            value = next((value for value, condition in e.args if self.decide(condition)), None)
            if value is None:
                raise Untranslatable(f"{e} has no value where none of its conditions holds")
            return self.polynomial(value)
        raise Untranslatable(f"no rule translates {e}")

    def _variable(self, symbol):
        name = str(symbol)
        if name not in self.variables and not any(s.get("new") == name for s in self.steps):
            self.variables.append(name)
            if symbol is pi:
                self.steps += [_fact("assume", of, {1}) for of in (Symbol(name) - 3, Rational(22, 7) - Symbol(name))]
        return Symbol(name) if symbol is pi else symbol

    def _named(self, polynomial):
        """Return a name for a sum that is multiplied in what is shown: the kernel multiplies it, not SymPy."""
        polynomial = expand(polynomial)
        return self._generator("sum", polynomial) if self.showing and polynomial.is_Add else polynomial

    def _generator(self, kind, of):
        """Return the name of a sum, a root or an inverse: the same one for the same polynomial."""
        whole = self._written_out(of)
        if kind == "inverse" and whole.is_Rational and whole != 0:
            return 1 / whole
        abbreviation = kind in ("sum", "derivative")
        key = kind, json.dumps(polynomial_data(of if abbreviation else whole))
        if key not in self.generators:
            new = Symbol(f"{kind}_{1 + sum(k == kind for k, _ in self.generators)}", real=True)
            self.generators[key] = new
            self.introduce("define" if abbreviation else kind, new, of)
            if kind == "root":
                self.signs[self._known(new)[0]] = {0, 1}
        return self.generators[key]

    def _side(self, f):
        """Return the sign of f, and make an obligation of f ≠ 0."""
        difference = self.polynomial(f)
        key, _, possible = self._known(difference)
        if 0 in possible:
            self.show(difference, {-1, 1})
            self.signs[key] = self.signs.get(key, ANY) - {0}
        return self._sign(difference)

    def _sign(self, difference):
        return next((s for s in (1, -1) if self._decided(difference, {s})), 0)

    def _beside(self, e):
        """Return the value of a relation's Piecewise; at a condition's edge the goal is that all its values agree."""
        signs = []
        value = self.polynomial(branch(e, lambda f: signs.append(self._sign(self.polynomial(f))) or signs[-1]))
        if 0 in signs:
            for other, _ in e.args:
                self.show(self.polynomial(other) - value, {0})
        return value

    def _derivative(self, e):
        """Return the name of a derivative, whose expression is written out and shown to have a value."""
        if lines := symbols_of([e]) & self.lines:
            raise Untranslatable(f"{e} is of what a line defines: {', '.join(sorted(map(str, lines)))}")
        value = self.polynomial(inner(e, self._side))
        self.polynomial(e.expr)
        return self._generator("derivative", expand(value))

    def _absolute(self, argument):
        of = self.polynomial(argument)
        _, _, signs = self._known(of)
        if {-1, 1} <= signs and argument.is_Mul:
            return argument.func(*(self._absolute(a) for a in sorted(argument.args, key=str)))
        if {-1, 1} <= signs:
            return self._generator("root", of**2)
        factor = -1 if -1 in signs else 1
        if not of.is_Rational:
            self.show(factor * of, {0, 1})
        return factor * of

    def turned(self, angle: Expr) -> tuple[Expr, Expr]:
        """Return (cos, sin) of an angle as polynomials, by the addition formulas."""
        c, s = S.One, S.Zero
        for times, part, known in parts_of(angle, self.denominators):
            d, t = map(self.polynomial, known) if known else self.circle(part)
            t = -t if times < 0 else t
            for _ in range(abs(times)):
                c, s = self._named(c * d - s * t), self._named(s * d + c * t)
        return c, s

    def circle(self, part: Expr) -> tuple[Symbol, Symbol]:
        """Return the names of a part's cosine and sine, of which c² + s² = 1 is given."""
        c, s = circle_of(part)
        if c.name not in self.variables:
            self.variables += [c.name, s.name]
            self.assume(c**2 + s**2 - 1, {0})
        return c, s


def _follows(difference, signs, given):
    """Return whether a sign is that of 0, or given of the same polynomial or of a multiple."""
    key, orientation = _keyed(difference)
    said = [(other, {orientation * turn * s for s in of}) for d, of in given for other, turn in [_keyed(d)]]
    return not expand(difference) or ANY.intersection(*(of for other, of in said if other == key)) <= signs


@cache
def cases_of(claim: Claim) -> list[tuple[dict, set[int]]]:
    """Return [(statement, numbers of the relations that read 0 = 0, 2 > 1, or are given)], for each choice."""
    pending: list[tuple[bool, ...]] = [()]
    found: list[tuple[dict, set[int]]] = []
    while pending:
        small(10 * (len(found) + len(pending)))
        choices = pending.pop()
        try:
            found.append(_case(claim, choices))
        except _Undecided:
            pending += [(*choices, False), (*choices, True)]
        except TypeError as why:  # SymPy compares what has no order, such as 1/0
            raise Untranslatable(f"{claim.name}: {why}") from why
    return found


def _case(claim, choices):
    """Return the statement of one case of a claim. Each hypothesis stands where its names have just been defined."""
    pending = [*((given, ()) for given in claim.given), *((lemma.relation, lemma.given) for lemma in claim.cited)]
    plain(symbols_of(flat((claim.shows, pending, claim.everywhere()))))
    _, lines = claim.names()
    definitions = lines.definitions if lines else ()
    t = Translation(flat((claim.shows, pending, definitions)), choices, definitions)
    undefined, given, reading = set(t.lines), [], Reading()
    for line in (None, *definitions):
        if line:
            t.line(*line)
            reading.line(*line)
            undefined.discard(line[0])
        ready = [p for p in pending if not any(r.free_symbols & undefined for r in flat(p))]
        pending = [p for p in pending if p not in ready]
        for relation, conditions in ready:
            for condition in conditions:
                t.show(*t.relation(condition))
            for part in relation.args if isinstance(relation, And) else [relation]:
                given += [t.relation(part), (reading.difference(part), TRUE_FOR[part.rel_op])]
                t.assume(*given[-2])
    t.showing, idle = True, set()
    for number, relation in enumerate(claim.shows):
        before = t.shown
        difference, signs = t.relation(relation)
        read = reading.difference(relation)
        said = before == t.shown and _follows(difference, signs, given)  # where no branch was taken
        if said or read.is_Rational or _follows(read, signs, given):
            idle.add(number)
        t.show(difference, signs)
    return {"version": VERSION, "kind": "derivation", "variables": t.variables, "steps": t.steps}, idle
