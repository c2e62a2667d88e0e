"""From SymPy to data: the translation of a claim into statements that the kernel checks. This file is trusted.

The rules (`proofs.engine.statement_data` has the format). Symbols are plain real ones: a sign, a range, being whole is
a hypothesis. Both sides of a relation are translated as they stand, the factors of a product that is shown as names
(sum_1, …) of their own, so that the kernel multiplies. A quotient becomes an inverse, a radical a root, with their
obligations. sin and cos of a sum of whole multiples are expanded by the addition formulas (`proofs.engine.angles`);
an atom gives two variables with c² + s² = 1. |a| is √(a²), or ±a where the sign is given. Max, Min, sign and
Piecewise take the branch that is given, and its condition is shown; where none is, the claim is split into two
statements, one with the condition assumed and one with its negation. Of π only 3 < π < 22/7 is used.
Derivatives are SymPy's `diff`. Anything else is an error, never a guess.
"""

import json
import re
from collections.abc import Iterable, Sequence
from functools import cache
from typing import Any

from sympy import Abs, And, Basic, Expr, Max, Min, Piecewise, Rational, S, Symbol, cos, expand, pi, sign, sin
from sympy.core.relational import Relational

from proofs.engine.angles import Angles, Untranslatable
from proofs.engine.claim import Claim
from proofs.engine.statement_data import RELATIONS, TRUE_FOR, VERSION, polynomial_data
from proofs.formulas.half_turns import ordinary

__all__ = ["VERSION", "derivations", "polynomial_data"]


NAME = re.compile(r"(?!(?:pi|(?:root|inverse|sum)_\d+)$)[A-Za-z][A-Za-z0-9_]*", re.ASCII)  # the others are taken


def plain(symbols: Iterable[Symbol]) -> None:
    """Raise Untranslatable unless every symbol is real, nothing more, and has a name of its own.

    extended_real says less than real, and is allowed: of a quantity that may be infinite where no claim is made.
    """
    seen = set()
    for symbol in sorted(symbols, key=str):
        if not NAME.fullmatch(symbol.name):
            raise Untranslatable(f"{symbol.name!r} is no name, or one that the translation makes itself")
        if symbol not in (Symbol(symbol.name, real=True), Symbol(symbol.name, extended_real=True)):
            raise Untranslatable(
                f"{symbol} is not a plain real symbol: what is known of it is a hypothesis to be stated"
            )
        if symbol.name in seen:
            raise Untranslatable(f"two symbols are called {symbol}")
        seen.add(symbol.name)


class _Undecided(Exception):
    """A condition is neither given nor chosen yet."""


class Derivation:
    """One derivation of a claim under construction; `choices` decide the conditions that are not given."""

    def __init__(self, claim: Claim, choices: Sequence[bool] = ()):
        self.choices, self.showing = list(choices), False
        self.steps: list[dict] = []
        self.variables: list[str] = []
        self.generators: dict[tuple, Any] = {}
        self.signs: dict[str, set[int]] = {}
        self.abbreviated: dict[Symbol, Expr] = {}
        _, lines = claim.names()
        definitions = lines.definitions if lines else ()
        lemmas = [(lemma.relation, lemma.given) for lemma in claim.cited]
        cited = (r for relation, conditions in lemmas for r in (relation, *conditions))
        expressions = (*claim.given, *claim.shows, *cited, *(e for line in definitions for e in line))
        plain(set().union(*(e.free_symbols for e in expressions)))
        self.angles = Angles(sides(expressions))
        undefined, pending = {s for s, _ in definitions}, [*((given, ()) for given in claim.given), *lemmas]
        for symbol, expression in ((None, None), *definitions):
            if symbol is not None:
                value = self.polynomial(ordinary(expression))
                self.step("define", value, new=symbol.name)
                self.abbreviated[symbol] = self.written_out(value)
                undefined.discard(symbol)
            ready = [p for p in pending if not any(r.free_symbols & undefined for r in (p[0], *p[1]))]
            pending = [p for p in pending if p not in ready]
            for relation, conditions in ready:
                for condition in conditions:
                    self.show(*self.relation(condition))
                for part in relation.args if isinstance(relation, And) else [relation]:
                    self.assume(*self.relation(part))
        self.showing = True
        for relation in claim.shows:
            self.show(*self.relation(relation))

    def statement(self) -> dict:
        """Return the statement."""
        return {"version": VERSION, "kind": "derivation", "variables": self.variables, "steps": self.steps}

    def step(self, kind: str, polynomial: Expr, new: str | None = None, is_: str | None = None) -> None:
        named = ({"new": new} if new else {}) | ({"is": is_} if is_ else {})
        self.steps.append({"step": kind, **named, "of": polynomial_data(polynomial)})

    def written_out(self, polynomial: Expr) -> Expr:
        """Return the polynomial with its abbreviations written out: equal ones then look the same."""
        return expand(polynomial.xreplace(self.abbreviated))

    # Relations and signs

    def relation(self, relation: Basic) -> tuple[Expr, set[int]]:
        """Return (left − right, the signs for which the relation holds)."""
        if not isinstance(relation, Relational):
            raise Untranslatable(f"{relation} is not a relation")
        left, right = (self.polynomial(ordinary(side)) for side in (relation.lhs, relation.rhs))
        return left - right, TRUE_FOR[relation.rel_op]

    def _normal(self, difference):
        data = polynomial_data(self.written_out(difference))
        leading = Rational(next(iter(data.values()))) if data else S.One
        key = json.dumps({k: str(Rational(c) / abs(leading) * (1 if leading > 0 else -1)) for k, c in data.items()})
        return data, key, 1 if leading > 0 else -1

    def assume(self, difference: Expr, signs: set[int]) -> None:
        """Add a given: the sign of `difference` is one of `signs`."""
        _, key, orientation = self._normal(difference)
        self.signs[key] = self.signs.get(key, {-1, 0, 1}) & {orientation * s for s in signs}
        factor, is_ = RELATIONS[frozenset(signs)]
        self.step("assume", factor * difference, is_=is_)

    def show(self, difference: Expr, signs: set[int]) -> None:
        """Add what is to be proved: the sign of `difference` is one of `signs`. The branches taken are shown, too."""
        factor, is_ = RELATIONS[frozenset(signs)]
        shown = polynomial_data(factor * difference)
        if {"step": "show", "is": is_, "of": shown} not in self.steps:
            self.step("show", factor * difference, is_=is_)

    def decide(self, condition: Basic) -> bool:
        """Return whether a condition holds: as given, or else as chosen."""
        if condition in (True, False):
            return bool(condition)
        if isinstance(condition, And):
            return all(self.decide(part) for part in sorted(condition.args, key=str))
        return self._decided(*self.relation(condition))

    def _decided(self, difference, wanted):
        data, key, orientation = self._normal(difference)
        if set(data) <= {""}:
            value = Rational(data.get("", 0))
            return bool({int(bool(value > 0)) - int(bool(value < 0))} & wanted)
        possible = {orientation * s for s in self.signs.get(key, {-1, 0, 1})}
        if possible <= wanted or not possible & wanted:
            self.show(difference, wanted if possible <= wanted else {-1, 0, 1} - wanted)
            return possible <= wanted
        if not self.choices:
            raise _Undecided
        choice = self.choices.pop(0)
        self.assume(difference, possible & wanted if choice else possible - wanted)
        return choice

    def _exceeds(self, left, right):
        """Return whether left ≥ right, or False if it is known to be ≤ (where they are equal both answers do)."""
        difference = self.polynomial(left) - self.polynomial(right)
        _, key, orientation = self._normal(difference)
        return orientation in self.signs.get(key, {-1, 0, 1}) and self._decided(difference, {0, 1})

    # Expressions

    def polynomial(self, e: Expr) -> Expr:
        """Return the expression as a polynomial in variables and generators, adding the steps that it needs."""
        if e.is_Rational:
            return e
        if e.is_Symbol or e is pi:
            return self._variable(e)
        if e.is_Add:
            return e.func(*(self.polynomial(a) for a in sorted(e.args, key=str)))
        if e.is_Mul:
            return e.func(*(self._named(self.polynomial(a)) for a in sorted(e.args, key=str)))
        if e.is_Pow and (2 * e.exp).is_Integer:
            base, power = self.polynomial(e.base), 2 * e.exp
            base, power = (base, power / 2) if power % 2 == 0 else (self._generator("root", base), power)
            base = self._named(base)
            return base**power if power > 0 else self._generator("inverse", base) ** -power
        if isinstance(e, sin | cos):
            return self._turn(e.args[0])[isinstance(e, sin)]
        if isinstance(e, Abs):
            return self._absolute(e.args[0])
        if isinstance(e, sign):
            return S(1 if self.decide(e.args[0] > 0) else -1 if self.decide(e.args[0] < 0) else 0)
        if isinstance(e, Max | Min):
            best, *others = sorted(e.args, key=str)
            for other in others:
                best = other if self._exceeds(*((other, best) if isinstance(e, Max) else (best, other))) else best
            return self.polynomial(best)
        if isinstance(e, Piecewise):
            return self.polynomial(next(value for value, condition in e.args if self.decide(condition)))
        raise Untranslatable(f"no rule translates {e}")

    def _variable(self, symbol):
        name = str(symbol)
        if name not in self.variables and not any(s.get("new") == name for s in self.steps):
            self.variables.append(name)
            if symbol is pi:
                self.step("assume", Symbol(name) - 3, is_=">")
                self.step("assume", Rational(22, 7) - Symbol(name), is_=">")
        return Symbol(name) if symbol is pi else symbol

    def _named(self, polynomial):
        """Return a name for a sum that is multiplied in what is shown: the kernel multiplies it, not SymPy."""
        polynomial = expand(polynomial)
        if not (self.showing and polynomial.is_Add):
            return polynomial
        key = "sum", json.dumps(polynomial_data(polynomial))
        if key not in self.generators:
            new = Symbol(f"sum_{1 + sum(kind == 'sum' for kind, _ in self.generators)}", real=True)
            self.step("define", polynomial, new=new.name)
            self.generators[key], self.abbreviated[new] = new, self.written_out(polynomial)
        return self.generators[key]

    def _generator(self, kind, of):
        whole = self.written_out(of)
        if kind == "inverse" and whole.is_Rational and whole != 0:
            return 1 / whole
        key = kind, json.dumps(polynomial_data(whole))
        if key not in self.generators:
            new = Symbol(f"{kind}_{1 + sum(k == kind for k, _ in self.generators)}", real=True)
            self.step(kind, of, new=new.name)
            self.generators[key] = new
            if kind == "root":
                self.signs[self._normal(new)[1]] = {0, 1}
        return self.generators[key]

    def _absolute(self, argument):
        of = self.polynomial(argument)
        _, key, orientation = self._normal(of)
        signs = {orientation * s for s in self.signs.get(key, {-1, 0, 1})}
        if signs == {-1, 0, 1} or signs == {-1, 1}:
            return self._generator("root", of**2)
        factor = -1 if -1 in signs else 1
        self.show(factor * of, {0, 1})
        return factor * of

    def _turn(self, angle):
        """Return (cos, sin) of an angle, by the addition formulas."""
        c, s = S.One, S.Zero
        for number, atom, whole in self.angles.parts(angle):
            d, t = [self.polynomial(f) for f in number] if atom is None else self._circle(atom)
            t = -t if whole < 0 else t
            for _ in range(abs(whole)):
                c, s = self._named(c * d - s * t), self._named(s * d + c * t)
        return c, s

    def _circle(self, atom):
        if not atom.is_polynomial():
            raise Untranslatable(f"the angle {atom} is no polynomial: it may have no value")
        names = tuple(f"{f}({atom})".replace(" ", "") for f in ("cos", "sin"))
        if ("circle", names) not in self.generators:
            c, s = self.generators["circle", names] = tuple(Symbol(name, real=True) for name in names)
            self.variables += names
            self.assume(c**2 + s**2 - 1, {0})
        return self.generators["circle", names]


def sides(expressions: Iterable[Basic]) -> list[Basic]:
    """Return the expressions, and the sides of those that are relations (a relation itself may evaluate to true)."""
    parts = [part for e in expressions for part in (e.args if isinstance(e, And) else [e])]
    return [side for part in parts for side in (part.args if isinstance(part, Relational) else [part])]


@cache
def derivations(claim: Claim) -> list[dict]:
    """Return the statements of a Claim: one, or one for each combination of conditions that are not given."""
    pending: list[tuple[bool, ...]] = [()]
    statements: list[dict] = []
    while pending:
        choices = pending.pop()
        try:
            statements.append(Derivation(claim, choices).statement())
        except _Undecided:
            pending += [(*choices, False), (*choices, True)]
    return statements
