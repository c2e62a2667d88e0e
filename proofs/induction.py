"""The translation of inductions: recurrences for the states, the addition formulas for cos nα and sin nα. Trusted."""

from sympy import S, expand, sympify
from sympy.core.relational import Eq

from .claim import Claim
from .half_turns import ordinary
from .statement import VERSION, Derivation, Untranslatable, polynomial_data


class _Recurrence(Derivation):
    """A derivation's rules of translation, for polynomials in n's states and the parameters."""

    def __init__(self, claim):
        super().__init__(Claim(claim.name, (), ()))
        self.n, self.angles = claim.n, {}

    def _circle(self, atom):
        c, s = super()._circle(atom)
        self.angles[atom] = c, s
        return c, s


def _polynomials(translation, expressions):
    return [translation.polynomial(ordinary(sympify(e))) for e in expressions]


def induction(claim):
    """Return the statement of an Induction. Raises Untranslatable where a quotient or a radical occurs."""
    t = _Recurrence(claim)
    relations = (*claim.given, *claim.shows, *claim.strengthen)
    if not all(isinstance(r, Eq) for r in (*claim.shows, *claim.strengthen)):
        raise Untranslatable(f"{claim.name}: an induction shows equations")
    t._collect_angles([*relations, *(sympify(e) for _, *two in claim.states for e in two)])
    state = {symbol.name: _polynomials(t, two) for symbol, *two in claim.states}
    shows, strengthen = ([t.relation(r)[0] for r in rs] for rs in (claim.shows, claim.strengthen))
    for r in claim.given:
        t.assume(*t.relation(r))
    for atom, (c, s) in list(t.angles.items()):
        if not atom.has(t.n):
            continue
        step = expand(atom.subs(t.n, t.n + 1) - atom)
        if step.has(t.n):
            raise Untranslatable(f"{claim.name}: {atom} is not linear in {t.n}")
        d, e = t._turn(step)
        state |= {c.name: (S.One, expand(c * d - s * e)), s.name: (S.Zero, expand(s * d + c * e))}
    return _data(t, claim, state, shows, strengthen)


def _data(t, claim, state, shows, strengthen):
    kinds = {step["step"] for step in t.steps}
    if kinds & {"root", "inverse"} or claim.n.name in t.variables:
        raise Untranslatable(f"{claim.name}: a radical, a quotient, or n itself, in an induction")
    circles = [c for atom, c in t.angles.items() if not atom.has(t.n)]
    parameters = sorted({v for v in t.variables if v not in state} | {x.name for pair in circles for x in pair})
    assume = [{"of": step["of"], "is": step["is"]} for step in t.steps if step["step"] == "assume"]
    assume += [{"of": polynomial_data(c**2 + s**2 - 1), "is": "="} for c, s in circles]
    return {
        "version": VERSION,
        "kind": "induction",
        "variables": parameters,
        "state": sorted(state),
        "assume": assume,
        "start": {name: polynomial_data(state[name][0]) for name in sorted(state)},
        "next": {name: polynomial_data(state[name][1]) for name in sorted(state)},
        "show": [polynomial_data(p) for p in shows],
        "strengthen": [polynomial_data(p) for p in strengthen],
    }
