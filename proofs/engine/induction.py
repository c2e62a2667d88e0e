"""Translation of an Induction into the statement that the kernel checks. This file is trusted."""

from collections.abc import Sequence

from sympy import Basic, Expr, S, Symbol, expand, sympify
from sympy.core.relational import Eq

from proofs.engine.angles import angles_in, circle_of
from proofs.engine.claim import Induction
from proofs.engine.derivative import Untranslatable, few
from proofs.engine.names import plain, symbols_of
from proofs.engine.program import flat
from proofs.engine.statement import VERSION, Translation, polynomial_data


class Turning(Translation):
    """A translation in which the cosine and the sine of a multiple of n are states."""

    def __init__(self, expressions: Sequence[Basic], n: Symbol):
        self.n = n
        self.turning: dict[Expr, tuple[Symbol, Symbol]] = {}  # {multiple of n: its cosine and sine}
        super().__init__(expressions)

    def circle(self, part: Expr) -> tuple[Symbol, Symbol]:
        """Return the names of a part's cosine and sine; those of a multiple of n are kept apart."""
        if not part.has(self.n):
            return super().circle(part)
        return self.turning.setdefault(part, circle_of(part))

    def turns(self) -> dict[str, Sequence[Expr]]:
        """Return {name: (start, next)} of the cosines and sines of the multiples of n, by the addition formulas."""
        state: dict[str, Sequence[Expr]] = {}
        for part, (c, s) in list(self.turning.items()):
            step, start = expand(part.subs(self.n, self.n + 1) - part), part.subs(self.n, 0)
            if step.has(self.n) or start != 0:
                raise Untranslatable(f"{part} is not a multiple of {self.n}")
            d, t = self.turned(step)
            state |= {c.name: (S.One, expand(c * d - s * t)), s.name: (S.Zero, expand(s * d + c * t))}
        return state


def induction(claim: Induction) -> dict:
    """Return the statement of an Induction. Raises Untranslatable where a quotient or a radical occurs."""
    expressions = tuple(map(sympify, flat((claim.given, claim.shows, claim.states))))
    if claim.n not in (Symbol(claim.n.name, integer=True), Symbol(claim.n.name, real=True)):
        raise Untranslatable(f"{claim.name}: of n it is known that it is whole, and nothing else")
    few(len(expressions))
    plain([*(symbols_of(expressions) - {claim.n}), Symbol(claim.n.name, real=True)])
    if not all(isinstance(r, Eq) for r in claim.shows):
        raise Untranslatable(f"{claim.name}: an induction shows equations")
    states = {s for s, *_ in claim.states}
    if len(states) < len(claim.states):
        raise Untranslatable(f"{claim.name}: a state is given twice")
    if symbols_of(angles_in(expressions)) & states:
        raise Untranslatable(f"{claim.name}: a state in an angle, which changes with it")
    if symbols_of([*claim.given, *(sympify(start) for _, start, _ in claim.states)]) & {*states, claim.n}:
        raise Untranslatable(f"{claim.name}: a state, or n, in what is given or in what a state starts from")
    t = Turning(expressions, claim.n)
    state: dict[str, Sequence[Expr]]
    state = {s.name: [t.polynomial(sympify(e)) for e in two] for s, *two in claim.states}
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
