"""Hold the ledger against a run: grades, numbers, tests, sources; and see that nothing is left without a claim."""

import re
from collections.abc import Callable
from dataclasses import dataclass

from book.ledger.entries import CONDITIONAL, FINDINGS, NUMBER_ROLE, OUTSIDE, Claim, Evidence, Ledger
from book.ledger.relations import relation

THEOREM_ROLE = re.compile(r"\{theorem-ref\}`([^`|]+)")


@dataclass(frozen=True)
class Run:
    """What a run has found: grades of theorems by id, pages, bibliography keys; and two questions.

    number: the value of "figure.key", or ValueError. test: whether a node id "file.py::name" exists.
    """

    grades: dict[str, str]
    pages: frozenset[str]
    sources: frozenset[str]
    number: Callable[[str], int | float | str | bool]
    test: Callable[[str], bool]


def check(ledger: Ledger, run: Run) -> list[str]:
    """Every fault, one line each: the entry, the field, what is wrong."""
    faults = [fault for claim in ledger.claims for fault in _claim(claim, ledger, run)]
    return faults + _orphans(ledger, run)


def refutes(piece: Evidence, run: Run) -> bool:
    """Whether a piece of evidence speaks against its claim."""
    if piece.kind == "number":
        return bool(piece.claimed) and not relation(piece.claimed).holds(run.number(piece.name))
    if piece.refutes is None:
        return piece.kind == "theorem" and piece.wants == "refuted"
    return piece.refutes


def _claim(claim: Claim, ledger: Ledger, run: Run) -> list[str]:
    faults = []
    place = claim.where.removeprefix("seed:")
    if claim.of_seed and place not in ledger.places:
        faults.append(f"{claim.id}: where: {place!r} is no place of the seed; there are: {', '.join(ledger.places)}")
    if not claim.of_seed and claim.where not in run.pages:
        faults.append(f"{claim.id}: where: {claim.where!r} is no page; there are: {', '.join(sorted(run.pages))}")
    for field, text in claim.texts().items():
        for name in NUMBER_ROLE.findall(text):
            faults += _asked(claim.id, field, name, run)
        for name in THEOREM_ROLE.findall(text):
            if name not in run.grades:
                faults.append(f"{claim.id}: {field}: unknown theorem {name!r}")
    broken = [fault for piece in claim.evidence for fault in _piece(claim.id, piece, run)]
    return faults + (broken or _verdict(claim, run))


def _asked(id: str, field: str, name: str, run: Run) -> list[str]:
    try:
        run.number(name)
    except ValueError as error:
        return [f"{id}: {field}: {error}"]
    return []


def _piece(id: str, piece: Evidence, run: Run) -> list[str]:
    """What is wrong with one piece of evidence."""
    at = f"{id}: evidence {piece.name}"
    if piece.kind == "theorem":
        if piece.name not in run.grades:
            return [f"{at}: theorem: no theorem has this id"]
        grade = run.grades[piece.name]
        return [] if grade == piece.wants else [f"{at}: grade: {piece.wants} is expected, the run made it {grade}"]
    if piece.kind == "test":
        return [] if run.test(piece.name) else [f"{at}: test: there is no such test"]
    if piece.kind == "source":
        return [] if piece.name in run.sources else [f"{at}: source: the bibliography has no such key"]
    try:
        value = run.number(piece.name)
    except ValueError as error:
        return [f"{at}: number: {error}"]
    if isinstance(value, str):
        return [f"{at}: number: it is the text {value!r}"]
    return [] if relation(piece.wants).holds(value) else [f"{at}: is: {piece.wants} is expected, the run has {value}"]


def _verdict(claim: Claim, run: Run) -> list[str]:
    """Whether the evidence bears out the verdict; the evidence itself is in order."""
    against = [piece.name for piece in claim.evidence if refutes(piece, run)]
    if claim.verdict == "holds" and against:
        return [f"{claim.id}: verdict: 'holds', but {', '.join(against)} refutes it"]
    if claim.verdict in ("false", "corrected") and not against:
        return [f"{claim.id}: verdict: {claim.verdict!r}, and none of its evidence refutes it"]
    if claim.verdict == CONDITIONAL and len(against) == len(claim.evidence):
        return [f"{claim.id}: verdict: {claim.verdict!r}, but all of its evidence refutes it"]
    return []


def _orphans(ledger: Ledger, run: Run) -> list[str]:
    """Theorems, findings and places of the seed that no claim accounts for; background that is none."""
    claims = [claim for claim in ledger.claims if claim.verdict != OUTSIDE]
    needed = ledger.resting_on()
    faults = []
    for id in run.grades:
        if id not in needed and id not in ledger.background:
            faults.append(f"theorem {id}: no claim rests on it, and background.toml does not list it")
        if id in needed and id in ledger.background:
            faults.append(f"background {id}: theorem: {needed[id][0].id} rests on it, so it is no background")
    faults += [f"background {id}: theorem: no theorem has this id" for id in ledger.background if id not in run.grades]
    codes = {code for claim in claims for code in claim.findings}
    faults += [f"finding {code}: no claim has it" for code in FINDINGS if code not in codes]
    used = {claim.where for claim in ledger.claims}
    return faults + [
        f"place {place}: no claim of the seed stands there" for place in ledger.places if f"seed:{place}" not in used
    ]
