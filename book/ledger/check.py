"""Hold the ledger against a run: grades, numbers, tests, sources; and see that nothing is left without a claim."""

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from book.ledger.entries import CONDITIONAL, FINDINGS, NUMBER_ROLE, OUTSIDE, Evidence, Ledger, LedgerClaim
from book.ledger.relations import relation

THEOREM_ROLE = re.compile(r"\{theorem-ref\}`([^`|]+)")


@dataclass(frozen=True)
class Run:
    """What a run has found: grades of theorems by id, and those expected; pages, bibliography keys; and two questions.

    number: the value of "figure.key", or ValueError. test: whether a node id "file.py::name" exists.
    """

    grades: dict[str, str]
    expected: dict[str, str]
    pages: frozenset[str]
    sources: frozenset[str]
    number: Callable[[str], Any]
    test: Callable[[str], bool]


def faults_in(ledger: Ledger, run: Run) -> list[str]:
    """Every fault, one line each: the entry, the field, what is wrong."""
    of_claims = [f"{claim.id}: {fault}" for claim in ledger.claims for fault in _claim(claim, ledger, run)]
    return [*of_claims, *_orphans(ledger, run)]


def refutes(piece: Evidence, run: Run) -> bool:
    """Whether a piece of evidence speaks against its claim."""
    if piece.kind == "number":
        return bool(piece.claimed) and not relation(piece.claimed).holds(run.number(piece.name))
    if piece.refutes is None:
        return piece.kind == "theorem" and run.grades[piece.name] == "refuted"
    return piece.refutes


def _claim(claim: LedgerClaim, ledger: Ledger, run: Run) -> Iterator[str]:
    place = claim.where.removeprefix("seed:")
    if claim.of_seed and place not in ledger.places:
        yield f"where: {place!r} is no place of the seed; there are: {', '.join(ledger.places)}"
    if not claim.of_seed and place not in run.pages:
        yield f"where: {place!r} is no page; there are: {', '.join(sorted(run.pages))}"
    for field, text in claim.texts().items():
        yield from (f"{field}: {why}" for name in NUMBER_ROLE.findall(text) if (why := _odd_number(name, None, run)))
        unknown = (name for name in THEOREM_ROLE.findall(text) if name not in run.grades)
        yield from (f"{field}: unknown theorem {name!r}" for name in unknown)
    broken = [f"evidence {piece.name}: {why}" for piece in claim.evidence if (why := _odd(piece, run))]
    yield from broken or _verdict(claim, run)


def _odd(piece: Evidence, run: Run) -> str:
    if piece.kind == "number":
        return _odd_number(piece.name, piece.wants, run)
    if piece.kind == "test":
        return "" if run.test(piece.name) else "test: there is no such test"
    if piece.kind == "source":
        return "" if piece.name in run.sources else "source: the bibliography has no such key"
    if piece.name not in run.grades:
        return "theorem: no theorem has this id"
    grade, expected = run.grades[piece.name], run.expected[piece.name]
    return "" if grade == expected else f"grade: {expected} is expected, the run made it {grade}"


def _odd_number(name: str, wants: str | None, run: Run) -> str:
    """What is wrong with a number, or with what is asked of it; or ""."""
    try:
        value = run.number(name)
    except ValueError as error:
        return f"number: {error}" if wants else str(error)
    if wants is None:
        return ""
    if isinstance(value, str):
        return f"number: it is the text {value!r}"
    return "" if relation(wants).holds(value) else f"is: {wants} is expected, the run has {value}"


def _verdict(claim: LedgerClaim, run: Run) -> Iterator[str]:
    """Whether the evidence bears out the verdict; the evidence itself is in order."""
    against = [piece.name for piece in claim.evidence if refutes(piece, run)]
    if claim.verdict == "holds" and against:
        yield f"verdict: 'holds', but {', '.join(against)} refutes it"
    if claim.verdict in ("false", "corrected") and not against:
        yield f"verdict: {claim.verdict!r}, and none of its evidence refutes it"
    if claim.verdict == CONDITIONAL and len(against) == len(claim.evidence):
        yield f"verdict: {claim.verdict!r}, but all of its evidence refutes it"


def _orphans(ledger: Ledger, run: Run) -> Iterator[str]:
    """Theorems, findings and places of the seed that no claim accounts for."""
    needed = {piece.name for claim in ledger.claims for piece in claim.evidence if piece.kind == "theorem"}
    yield from (f"theorem {id}: no claim rests on it" for id in run.grades if id not in needed)
    codes = {code for claim in ledger.claims if claim.verdict != OUTSIDE for code in claim.findings}
    yield from (f"finding {code}: no claim has it" for code in FINDINGS if code not in codes)
    yield from (f"finding {code}: findings.toml has no name for it" for code in sorted(codes - FINDINGS.keys()))
    used = {claim.where for claim in ledger.claims}
    idle = (place for place in ledger.places if f"seed:{place}" not in used)
    yield from (f"place {place}: no claim of the seed stands there" for place in idle)
