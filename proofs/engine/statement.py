"""From SymPy to data: the translation of a claim into statements that the kernel checks. This file is trusted.

The rules (`proofs.engine.certificate` has the format). Symbols are plain real ones: a sign, a range, being whole is a
hypothesis. Both sides of a relation are translated as they stand, the factors of a product that is shown as names
(sum_1, …) of their own, so that the kernel multiplies. A quotient becomes an inverse, a radical a root, with their
obligations, before anything cancels: in an angle, too. Angles are sums of whole multiples of atoms, each divided by the
denominators that occur with it: sin and cos of a sum are expanded by the addition formulas; an atom gives two variables
with c² + s² = 1. |a| is √(a²), or ±a where the sign is given. Max, Min, sign and Piecewise take the branch that is
given, and its condition is shown; where none is, the claim is split into two statements, one with the condition assumed
and one with its negation. A Derivative is a name of its own, for what the rules of `derivative` make of it where they
show that it exists. In a relation sign and Piecewise may be what SymPy made of one: that f ≠ 0 is shown of sign(f), and
at the edge of a condition that all values agree. In an induction cos nα and sin nα are states. Of π only 3 < π < 22/7
is used. Anything else is an error, never a guess.
"""

import json
from collections.abc import Iterable, Sequence
from functools import cache
from math import comb, lcm, prod
from typing import Any

from sympy import (
    Abs,
    And,
    Basic,
    Derivative,
    Expr,
    Float,
    Max,
    Min,
    Piecewise,
    Poly,
    Rational,
    S,
    Symbol,
    cos,
    expand,
    expand_mul,
    pi,
    sign,
    sin,
)  # fmt: skip
from sympy.core.relational import Relational
from sympy.polys.polyerrors import BasePolynomialError

from proofs.engine.claim import Claim
from proofs.engine.derivative import LARGEST, TRUE_FOR, Untranslatable, branch, inner, small
from proofs.engine.names import plain, symbols_of
from proofs.formulas.half_turns import cospi, ordinary, sinpi

VERSION = 1
RELATIONS = {frozenset(s): (f, r) for f, r, s in (
    (1, "=", {0}), (1, "!=", {-1, 1}), (1, ">", {1}), (1, ">=", {0, 1}), (-1, ">", {-1}), (-1, ">=", {-1, 0})
)}  # fmt: skip
ANY = {-1, 0, 1}


class _Undecided(Untranslatable):
    """A condition is neither given nor chosen yet."""


@cache
def polynomial_data(expression: Expr) -> dict[str, str]:
    """Return a polynomial expression in symbols as {"x^2 y": "-3/2"}, sorted."""
    expression = expand(expression)
    symbols = sorted(expression.free_symbols, key=lambda s: s.name)
    if not symbols:
        return {} if expression == 0 else {"": str(Rational(expression))}
    data = {}
    for monomial, coefficient in Poly(expression, *symbols, domain="QQ").terms():
        factors = (s.name if e == 1 else f"{s.name}^{e}" for s, e in zip(symbols, monomial, strict=True) if e)
        data[" ".join(factors)] = str(coefficient)
    return dict(sorted(data.items()))


def _as_text(expression):
    return str(ordinary(expression))  # to sort by, and for nothing else: it simplifies


def _angle(e):
    return pi * e.args[0] if isinstance(e, sinpi | cospi) else e.args[0]


def _terms(angle):
    """Return [(rational, atom)] of an angle, which has to be a polynomial over the rationals in symbols and π."""
    terms = [term.as_coeff_Mul() for term in sorted(expand_mul(angle).as_ordered_terms(), key=str)]
    try:
        for _, atom in terms:
            Poly(atom, pi, *atom.free_symbols, domain="QQ")
        rational = all(multiple.is_Rational and not atom.has(Float) for multiple, atom in terms)
    except BasePolynomialError:
        rational = False
    if not rational:
        raise Untranslatable(f"the angle {angle} is no polynomial over the rationals: it may have no value")
    return terms


def _fact(kind, difference, signs):
    """Return the step that assumes or shows the sign of a difference to be one of `signs`."""
    factor, relation = RELATIONS[frozenset(signs)]
    return {"step": kind, "is": relation, "of": polynomial_data(factor * difference)}


class Translation:
    """The steps that some expressions become; `choices` decide the conditions that are not given."""

    def __init__(self, expressions: Iterable[Basic], choices: Sequence[bool] = (), lines: Sequence = (), n: Any = None):
        """n: what an induction is over."""
        self.choices, self.lines, self.n = list(choices), {symbol for symbol, _ in lines}, n
        self.in_line, self.showing, self.shown = False, False, 0
        self.steps: list[dict] = []
        self.variables: list[str] = []
        self.generators: dict[tuple, Any] = {}
        self.turning: dict[Expr, tuple[Symbol, Symbol]] = {}  # {multiple of n: its cosine and sine}
        self.signs: dict[str, set[int]] = {}
        self.abbreviated: dict[Symbol, Expr] = {}
        self.denominators: dict[Expr, int] = {}
        for side in sides(expressions):
            for e in side.atoms(sin, cos, sinpi, cospi):
                for multiple, atom in _terms(_angle(e)):
                    self.denominators[atom] = lcm(self.denominators.get(atom, 1), int(multiple.q))

    def introduce(self, kind: str, symbol: Symbol, of: Expr) -> None:
        """Add the step that makes a new symbol of a polynomial: "define", "root" or "inverse"."""
        self.steps.append({"step": kind, "new": symbol.name, "of": polynomial_data(of)})

    def define(self, symbol: Symbol, value: Expr) -> None:
        """Let a symbol abbreviate a polynomial."""
        self.introduce("define", symbol, value)
        self.abbreviated[symbol] = self._written_out(value)

    def _written_out(self, polynomial):
        """Return the polynomial with its abbreviations written out: equal ones then look the same."""
        for term in polynomial.as_ordered_terms():
            powers = [(self.abbreviated[s], n) for s, n in term.as_powers_dict().items() if s in self.abbreviated]
            small(prod(comb(len(p.as_ordered_terms()) + n - 1, n) for p, n in powers) // 20)
        return expand(polynomial.xreplace(self.abbreviated))

    # Relations and signs

    def relation(self, relation: Basic) -> tuple[Expr, set[int]]:
        """Return (left − right, the signs for which the relation holds)."""
        if not isinstance(relation, Relational):
            raise Untranslatable(f"{relation} is not a relation")
        left, right = (self.polynomial(side) for side in (relation.lhs, relation.rhs))
        return left - right, TRUE_FOR[relation.rel_op]

    def _known(self, difference):
        """Return a key of a polynomial and of its multiples, the key's sign in it, and the signs that it may have."""
        data = polynomial_data(self._written_out(difference))
        leading = Rational(next(iter(data.values()))) if data else S.One
        orientation = 1 if leading > 0 else -1
        key = json.dumps({k: str(Rational(c) / abs(leading) * orientation) for k, c in data.items()})
        return key, orientation, {orientation * s for s in self.signs.get(key, ANY)}

    def assume(self, difference: Expr, signs: set[int]) -> None:
        """Add a given: the sign of `difference` is one of `signs`."""
        key, orientation, possible = self._known(difference)
        self.signs[key] = {orientation * s for s in possible & signs}
        self.steps.append(_fact("assume", difference, signs))

    def show(self, difference: Expr, signs: set[int]) -> None:
        """Add what is to be proved: the sign of `difference` is one of `signs`. The branches taken are shown, too."""
        fact = _fact("show", difference, signs)
        self.shown += 1
        self.steps += [fact] * (fact not in self.steps)

    def decide(self, condition: Basic) -> bool:
        """Return whether a condition holds: as given, or else as chosen."""
        if condition in (True, False):
            return bool(condition)
        if isinstance(condition, And):
            return all(self.decide(part) for part in sorted(condition.args, key=str))
        return self._decided(*self.relation(condition))

    def _decided(self, difference, wanted):
        whole = self._written_out(difference)
        if whole.is_Rational:
            return int(sign(whole)) in wanted
        _, _, possible = self._known(difference)
        if possible <= wanted or not possible & wanted:
            self.show(difference, wanted if possible <= wanted else ANY - wanted)
            return possible <= wanted
        if not self.choices:
            raise _Undecided(f"the sign of {difference} is neither given nor chosen")
        choice = self.choices.pop(0)
        self.assume(difference, possible & wanted if choice else possible - wanted)
        return choice

    def _exceeds(self, left, right):
        """Return whether left ≥ right, or False if it is known to be ≤ (where they are equal both answers do)."""
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
        if e.is_Add:
            return e.func(*(self.polynomial(a) for a in sorted(e.args, key=_as_text)))
        if e.is_Mul:
            factors = [self.polynomial(a) for a in sorted(e.args, key=_as_text)]
            several = sum(not f.is_Rational for f in factors) > 1
            factors = [self._named(f) if several else expand(f) for f in factors]
            small(prod(len(f.as_ordered_terms()) for f in factors))
            return e.func(*factors)
        if e.is_Pow and e.exp.is_Rational and (2 * e.exp).is_Integer:
            base, power = self.polynomial(e.base), 2 * e.exp
            base, power = (base, power / 2) if power % 2 == 0 else (self._generator("root", base), power)
            base = self._named(base)
            small(max(n := abs(int(power)), comb(len(base.as_ordered_terms()) + min(n, 999) - 1, min(n, 999))))
            return base**power if power > 0 else self._generator("inverse", base) ** -power
        if isinstance(e, sin | cos | sinpi | cospi):
            if not e.args[0].is_polynomial():
                self.polynomial(e.args[0])  # for its obligations, before anything cancels
            return self._turn(_angle(e))[isinstance(e, sin | sinpi)]
        if isinstance(e, Abs):
            return self._absolute(e.args[0])
        if isinstance(e, sign):
            return S(self._sign(self.polynomial(e.args[0])) if self.in_line else self._side(e.args[0]))
        if isinstance(e, Max | Min):
            best, *others = sorted(e.args, key=_as_text)
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
            if abbreviation:
                self.define(new, of)
            else:
                self.introduce(kind, new, of)
            if kind == "root":
                self.signs[self._known(new)[0]] = {0, 1}
        return self.generators[key]

    def _side(self, f):
        """Return the sign of f, and make an obligation of f ≠ 0."""
        difference = self.polynomial(f)
        whole, (key, _, possible) = self._written_out(difference), self._known(difference)
        if 0 in possible and not (whole.is_Rational and whole != 0):
            self.show(difference, {-1, 1})
            self.signs[key] = self.signs.get(key, ANY) - {0}
        return self._sign(difference)

    def _sign(self, difference):
        return next((s for s in (1, -1) if self._decided(difference, {s})), 0)

    def _beside(self, e):
        """Return the value of a relation's Piecewise; at the edge of a condition all its values are shown to agree."""
        signs = []
        value = self.polynomial(branch(e, lambda f: signs.append(self._sign(self.polynomial(f))) or signs[-1]))
        if 0 in signs:
            for other, _ in e.args:
                self.show(self.polynomial(other) - value, {0})
        return value

    def _derivative(self, e):
        """Return the name of a derivative; what is differentiated has a value, and is written out."""
        if lines := symbols_of([e]) & self.lines:
            raise Untranslatable(f"{e} is of what a line defines: {', '.join(sorted(map(str, lines)))}")
        value = self.polynomial(inner(e, self._side))
        self.polynomial(e.expr)
        return self._generator("derivative", expand(value))

    def _absolute(self, argument):
        of = self.polynomial(argument)
        _, _, signs = self._known(of)
        if of.is_Rational:
            return abs(of)
        if {-1, 1} <= signs and argument.is_Mul:
            return argument.func(*(self._absolute(a) for a in sorted(argument.args, key=_as_text)))
        if {-1, 1} <= signs:
            return self._generator("root", of**2)
        factor = -1 if -1 in signs else 1
        self.show(factor * of, {0, 1})
        return factor * of

    def _turn(self, angle):
        """Return (cos, sin) of an angle, by the addition formulas."""
        c, s = S.One, S.Zero
        for multiple, atom in _terms(angle):
            whole = 1
            if atom is pi or multiple == 0:
                d, t = cos(multiple * atom), sin(multiple * atom)
                if d.has(cos) or t.has(sin):
                    raise Untranslatable(f"no closed form of cos({multiple * atom})")
                d, t = self.polynomial(d), self.polynomial(t)
            else:
                whole = multiple * self.denominators.get(atom, 0)
                if not whole.is_Integer or not 0 < abs(whole) <= LARGEST:
                    raise Untranslatable(f"{multiple * atom} is no whole multiple of an angle that occurs")
                d, t = self._circle(atom / self.denominators[atom])
            t = -t if whole < 0 else t
            for _ in range(abs(whole)):
                c, s = self._named(c * d - s * t), self._named(s * d + c * t)
        return c, s

    def _circle(self, atom):
        names = tuple(f"{f}({atom})".replace(" ", "") for f in ("cos", "sin"))
        if ("circle", names) not in self.generators:
            c, s = self.generators["circle", names] = tuple(Symbol(name, real=True) for name in names)
            if self.n is not None and atom.has(self.n):
                self.turning[atom] = c, s
            else:
                self.variables += names
                self.assume(c**2 + s**2 - 1, {0})
        return self.generators["circle", names]

    def turns(self) -> dict[str, Sequence[Expr]]:
        """Return {name: (start, next)} of the cosines and sines of the multiples of n, by the addition formulas."""
        state: dict[str, Sequence[Expr]] = {}
        for atom, (c, s) in list(self.turning.items()):
            step, start = expand(atom.subs(self.n, self.n + 1) - atom), atom.subs(self.n, 0)
            if step.has(self.n) or start != 0:
                raise Untranslatable(f"{atom} is not a multiple of {self.n}")
            d, t = self._turn(step)
            state |= {c.name: (S.One, expand(c * d - s * t)), s.name: (S.Zero, expand(s * d + c * t))}
        return state


def sides(expressions: Iterable[Basic]) -> list[Basic]:
    """Return the expressions, and the sides of those that are relations (a relation itself may evaluate to true)."""
    parts = [part for e in expressions for part in (e.args if isinstance(e, And) else [e])]
    return [side for part in parts for side in (part.args if isinstance(part, Relational) else [part])]


@cache
def _cases(claim: Claim) -> list[tuple[dict, list[int]]]:
    """Return [(statement, numbers of the relations that hold by definition)], one for each choice of conditions."""
    pending: list[tuple[bool, ...]] = [()]
    cases: list[tuple[dict, list[int]]] = []
    while pending:
        small(10 * (len(cases) + len(pending)))
        choices = pending.pop()
        try:
            cases.append(_case(claim, choices))
        except _Undecided:
            pending += [(*choices, False), (*choices, True)]
        except TypeError as why:  # SymPy compares what has no order, such as 1/0
            raise Untranslatable(f"{claim.name}: {why}") from why
    return cases


def derivations(claim: Claim) -> list[dict]:
    """Return the statements of a Claim."""
    return [statement for statement, _ in _cases(claim)]


def by_definition(claim: Claim) -> list[int]:
    """Return the numbers of the relations of `shows` that hold by definition: they read 0 = 0, or are given."""
    return sorted(set.intersection(*(set(idle) for _, idle in _cases(claim))))


def _case(claim, choices):
    """Return the statement of one case of a claim. What is given comes as soon as its names are defined."""
    _, lines = claim.names()
    definitions = lines.definitions if lines else ()
    lemmas = [(lemma.relation, lemma.given) for lemma in claim.cited]
    cited = [r for relation, conditions in lemmas for r in (relation, *conditions)]
    expressions = (*claim.given, *claim.shows, *cited, *(e for line in definitions for e in line))
    plain(symbols_of([*expressions, *claim.everywhere()]))
    t = Translation(expressions, choices, definitions)
    undefined, pending = set(t.lines), [*((given, ()) for given in claim.given), *lemmas]
    for symbol, expression in ((None, None), *definitions):
        if symbol is not None:
            t.in_line = True
            t.define(symbol, t.polynomial(expression))
            t.in_line = False
            undefined.discard(symbol)
        ready = [p for p in pending if not any(r.free_symbols & undefined for r in (p[0], *p[1]))]
        pending = [p for p in pending if p not in ready]
        for relation, conditions in ready:
            for condition in conditions:
                t.show(*t.relation(condition))
            for part in relation.args if isinstance(relation, And) else [relation]:
                t.assume(*t.relation(part))
    t.showing, idle = True, []
    given = [step for step in t.steps if step["step"] == "assume"]
    for number, relation in enumerate(claim.shows):
        before = t.shown
        difference, signs = t.relation(relation)
        fact = _fact("assume", difference, signs)
        if (not fact["of"] or fact in given) and before == t.shown:  # no branch was taken
            idle.append(number)
        t.show(difference, signs)
    return {"version": VERSION, "kind": "derivation", "variables": t.variables, "steps": t.steps}, idle
