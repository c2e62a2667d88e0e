"""The translation of inductions: recurrences for the states, the addition formulas for cos nα and sin nα. Trusted."""

from sympy import S, Symbol, expand, sympify
from sympy.core.relational import Eq

from proofs.engine.angles import Angles, Untranslatable
from proofs.engine.claim import Claim, Induction
from proofs.engine.statement import VERSION, Derivation, plain, polynomial_data, sides
from proofs.formulas.half_turns import ordinary


class _Recurrence(Derivation):
    """A derivation's rules of translation, in n's states and the parameters; cos nα and sin nα are states."""

    def __init__(self, claim):
        super().__init__(Claim(claim.name, (), ()))
        self.n, self.turning, self.showing = claim.n, {}, False

    def _circle(self, atom):
        if not atom.has(self.n):
            return super()._circle(atom)
        if atom not in self.turning:
            names = (f"{f}({atom})".replace(" ", "") for f in ("cos", "sin"))
            self.turning[atom] = tuple(Symbol(name, real=True) for name in names)
        return self.turning[atom]

    def turns(self):
        """Return {name: (start, next)} of the cosines and sines of the multiples of n, by the addition formulas."""
        state = {}
        for atom, (c, s) in list(self.turning.items()):
            step, start = expand(atom.subs(self.n, self.n + 1) - atom), atom.subs(self.n, 0)
            if step.has(self.n) or start != 0:
                raise Untranslatable(f"{atom} is not a multiple of {self.n}")
            d, t = self._turn(step)
            state |= {c.name: (S.One, expand(c * d - s * t)), s.name: (S.Zero, expand(s * d + c * t))}
        return state


def induction(claim: Induction) -> dict:
    """Return the statement of an Induction. Raises Untranslatable where a quotient or a radical occurs."""
    t = _Recurrence(claim)
    relations = (*claim.given, *claim.shows)
    expressions = (*relations, *(sympify(e) for state in claim.states for e in state))
    if claim.n not in (Symbol(claim.n.name, integer=True), Symbol(claim.n.name, real=True)):
        raise Untranslatable(f"{claim.name}: of n it is known that it is whole, and nothing else")
    plain(set().union(*(e.free_symbols for e in expressions)) - {claim.n})
    if not all(isinstance(r, Eq) for r in claim.shows):
        raise Untranslatable(f"{claim.name}: an induction shows equations")
    t.angles = Angles(sides(expressions))
    if len({s for s, *_ in claim.states}) < len(claim.states):
        raise Untranslatable(f"{claim.name}: a state is given twice")
    state = {s.name: [t.polynomial(ordinary(sympify(e))) for e in two] for s, *two in claim.states}
    shows = [polynomial_data(t.relation(r)[0]) for r in claim.shows]
    for r in claim.given:
        t.assume(*t.relation(r))
    state |= t.turns()
    if any(step["step"] != "assume" for step in t.steps) or claim.n.name in t.variables:
        raise Untranslatable(f"{claim.name}: a radical, a quotient, or n itself, in an induction")
    start, following = ({name: polynomial_data(state[name][i]) for name in sorted(state)} for i in (0, 1))
    return {
        "version": VERSION,
        "kind": "induction",
        "variables": [v for v in t.variables if v not in state],
        "state": sorted(state),
        "assume": [{"of": step["of"], "is": step["is"]} for step in t.steps],
        "start": start,
        "next": following,
        "show": shows,
    }
