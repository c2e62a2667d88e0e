"""A theorem as data, and how theorems are found and ordered. To add one, see `proofs/theorems/language.py`."""

import importlib
import pkgutil
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from graphlib import CycleError, TopologicalSorter
from typing import Any

from sympy import Symbol

from proofs.engine.claim import AnyClaim, Parts, point
from proofs.engine.program import Some, flat, put
from proofs.engine.project import PROJECT

WITHOUT_CLAIMS = ("measured", "certified")
GRADES = ("failed", *WITHOUT_CLAIMS, "proved", "refuted")

Point = tuple[tuple[Symbol, object], ...]


@dataclass(frozen=True)
class Step(Parts):
    """A step of the argument for the reader: `what` is concluded, and `why`. uses: ids of theorems that it cites."""

    what: str
    why: str
    uses: Some = ()


@dataclass(frozen=True)
class Pinned:
    """A theorem ID__NAME that Coq proves from a file written by hand: the digest of its text, as it was read.

    The text is Coq's print, with every definition by hand that it names (`verify.coq.recorded`). A theorem that pins it
    fails where the text has changed, or where Coq has refuted no false variant of it, ID__NAME__false.
    """

    name: str
    digest: str


def coq(*pinned: str) -> tuple[Pinned, ...]:
    """Return a Pinned for each text "NAME DIGEST".

    >>> from proofs.theorems.language import coq
    >>> coq("binades__tie e5e620cbf1c26408")[0].name
    'binades__tie'
    """
    return tuple(Pinned(*text.split()) for text in pinned)


@dataclass(frozen=True)
class Clause(Parts):
    """A part of a statement, as the reader sees it, and the claims, or the Pinned of Coq's, that state it."""

    text: str
    claims: Some = ()


@dataclass(frozen=True)
class SideCondition(Parts):
    """A condition without which the claim named `claim` is not claimed, and points on, or just past, its edge.

    holds, fails, undefined (a division by zero, the root of a negative number, a comparison with infinity): the points
    {symbol or vector: value or values} for every input, by the outcome of the claim there, which every run tests.

    >>> from proofs.theorems.language import SideCondition, real
    >>> SideCondition("x > 0", "root_is_positive", fails={real("x"): 0}).edges
    [(((x, 0),), 'fails')]
    """

    text: str
    claim: str
    holds: Some = ()
    fails: Some = ()
    undefined: Some = ()

    @property
    def edges(self) -> list[tuple[Point, str]]:
        """The points, each with its outcome."""
        outcomes = {"holds": self.holds, "fails": self.fails, "undefined": self.undefined}
        return [(point(at), outcome) for outcome, points in outcomes.items() for at in points]


@dataclass(frozen=True)
class Mutant:
    """A false variant of a claim, whose name it has and of which it changes one field.

    The checker has to refuse it, and a counterexample has to be found that is exact or enclosed.

    at: a point where it fails, as a side condition's, for those that sampling is unlikely to hit.
    """

    text: str
    claim: AnyClaim
    at: Any = ()

    def __post_init__(self):
        put(self, at=point(self.at))


def variant(text: str, claim: AnyClaim, *shows: Some, at: Any = (), **changes: Any) -> Mutant:
    """Return the mutant of a claim with other conclusions, if any are given, and other changes.

    >>> from proofs.theorems.language import Claim, equation, real, variant
    >>> x = real("x")
    >>> square = Claim("square", equation((x + 1) ** 2, x**2 + 2 * x + 1))
    >>> variant("without the product", square, equation((x + 1) ** 2, x**2 + 1), at={x: 1}).claim.shows
    (Eq((x + 1)**2, x**2 + 1),)
    """
    return Mutant(text, claim.but(**(changes | ({"shows": shows} if shows else {}))), at)


@dataclass(frozen=True)
class Theorem(Parts):
    """A statement with everything that its evidence is made of.

    id: identifier. title, statement (TeX between dollars where it is mathematics), hypotheses: for the reader. The
    statement may be {text: what says it}, or Clauses. short: the same in fewer words, for a page where the statement is
    folded, said by some of what says that.
    claims: those to check; of clauses, theirs. steps: the argument, {what: why, or (why, ids of the
    theorems that it cites)}, or Steps. side_conditions: each with its edge tests. mutants: at least two.
    refuted_at: of a false statement, the exact point, as a side condition's, where its one claim fails; such a theorem
    is `refuted`, and its mutants are the true variants, which that point must not refute. expected: the grade that a
    run has to reach, where the rest does not say it. Without claims it is `measured` or `certified`, by a function in
    verify/measurements. rounded: what Coq alone proves, of float64's own operations.

    >>> from proofs.theorems.language import Claim, Theorem, equation, real, variant
    >>> x = real("x")
    >>> square = Claim("square", equation((x + 1) ** 2, x**2 + 2 * x + 1))
    >>> theorem = Theorem(
    ...     "binomial",
    ...     "The square of a sum",
    ...     {"$(x + 1)^2 = x^2 + 2x + 1$ for every real $x$.": square},
    ...     mutants=(
    ...         variant("without 2x", square, equation((x + 1) ** 2, x**2 + 1)),
    ...         variant("without 1", square, equation((x + 1) ** 2, x**2 + 2 * x)),
    ...     ),
    ... )
    >>> theorem.expected, theorem.claims == (square,)
    ('proved', True)
    """

    id: str
    title: str
    statement: Any
    claims: Some = ()
    mutants: Some = ()
    steps: Some = ()
    hypotheses: Some = ()
    side_conditions: Some = ()
    refuted_at: Any = None
    expected: str = ""
    rounded: Some = ()
    short: Any = ()

    def __post_init__(self):
        hypotheses = tuple(map(_line, flat(self.hypotheses)))
        put(self, statement=_clauses(self.statement), steps=_steps(self.steps), hypotheses=hypotheses)
        put(self, short=_clauses(self.short))
        super().__post_init__()
        if not isinstance(self.statement, str):
            elsewhere = flat(self.rounded)
            claims = [c for c in dict.fromkeys(self._named) if not isinstance(c, Pinned) and c not in elsewhere]
            put(self, claims=tuple(claims))
        shown = "proved"
        if self.refuted_at is not None:
            put(self, refuted_at=point(self.refuted_at))
            shown = "refuted"
        put(self, expected=self.expected or shown)
        if self.expected not in GRADES:
            raise ValueError(f"{self.id}: expected = {self.expected!r} is not one of {', '.join(GRADES)}")
        checked = bool(self.claims) or not (self.pinned or self.rounded or self.expected in WITHOUT_CLAIMS)
        if checked and len(self.mutants) < 2:
            raise ValueError(f"{self.id}: needs at least two mutants")
        names = [claim.name for claim in (*self.claims, *self.rounded)]
        if len(set(names)) < len(names) or (checked and not self.claims):
            raise ValueError(f"{self.id}: claims need different names")
        if others := [pin.name for pin in self.pinned if not pin.name.startswith(f"{self.id}__")]:
            raise ValueError(f"{self.id}: pins what is another theorem's: {', '.join(others)}")
        if unknown := {c.claim for c in self.side_conditions}.difference(names):
            raise ValueError(f"{self.id}: side conditions of unknown claims {sorted(unknown)}")
        if (self.claims or self.pinned) and not all(clause.claims for clause in self.clauses):
            raise ValueError(f"{self.id}: a clause without a claim")
        if any(not clause.claims or {*clause.claims}.difference(self._named) for clause in self.short):
            raise ValueError(f"{self.id}: a short text needs claims, some of the statement's")
        if (self.expected == "refuted") != (self.refuted_at is not None and len(self.claims) == 1):
            raise ValueError(f"{self.id}: a refuted statement, and no other, has a point, and one claim")

    @property
    def clauses(self) -> tuple[Clause, ...]:
        """The statement's clauses: a text is one clause, stated by all the claims."""
        if isinstance(self.statement, str):
            return (Clause(self.statement, self.claims),)
        return self.statement

    @property
    def words(self) -> str:
        """The statement as one text."""
        return " ".join(clause.text for clause in self.clauses)

    @property
    def uses(self) -> tuple[str, ...]:
        """The ids of the theorems that it rests on: those that a step cites."""
        return tuple(dict.fromkeys(id for step in self.steps for id in step.uses))

    @property
    def _named(self) -> tuple:
        return tuple(claim for clause in self.clauses for claim in clause.claims)

    @property
    def pinned(self) -> tuple[Pinned, ...]:
        """The Pinned theorems of Coq's that clauses name."""
        return tuple(dict.fromkeys(claim for claim in self._named if isinstance(claim, Pinned)))

    def claim(self, name: str) -> AnyClaim:
        """Return the claim of that name."""
        return next(claim for claim in self.claims if claim.name == name)


def _line(text):
    """Return a text in one line."""
    return " ".join(text.split())


def _clauses(statement):
    """Return Clauses of {text: its claims}; or a text or Clauses as they are."""
    if isinstance(statement, str):
        return _line(statement)
    if not isinstance(statement, Mapping):
        return statement
    return tuple(Clause(_line(text), by) for text, by in statement.items())


def _steps(taken):
    """Return Steps of {what: why, or why and the ids of theorems that it cites}; or Steps as they are."""
    if not isinstance(taken, Mapping):
        return taken
    return tuple(Step(_line(what), _line(why), uses) for what, reason in taken.items() for why, *uses in [flat(reason)])


Theorems = dict[str, Theorem]


def in_order(theorems: Sequence[Theorem]) -> Theorems:
    """Return {id: Theorem}, each after those that it uses.

    Raises ValueError on a double id, an unknown use or a cycle, and names it.
    """
    by_id: Theorems = {}
    for theorem in theorems:
        if by_id.setdefault(theorem.id, theorem) is not theorem:
            raise ValueError(f"two theorems are called {theorem.id}")
    for theorem in theorems:
        if unknown := set(theorem.uses) - by_id.keys():
            raise ValueError(f"{theorem.id} uses unknown theorems: {', '.join(sorted(unknown))}")
    try:
        return {id: by_id[id] for id in TopologicalSorter({t.id: t.uses for t in theorems}).static_order()}
    except CycleError as error:
        raise ValueError(f"theorems use each other in a cycle: {' → '.join(error.args[1])}") from None


def all_theorems() -> Theorems:
    """Return {id: Theorem} of every Theorem in the project's modules of theorems, each after those that it uses."""
    package = PROJECT.theorems
    names = [module.name for module in pkgutil.iter_modules(importlib.import_module(package).__path__)]
    modules = [vars(importlib.import_module(f"{package}.{name}")) for name in names]
    return in_order([value for module in modules for value in module.values() if isinstance(value, Theorem)])
