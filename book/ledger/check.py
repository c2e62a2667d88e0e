"""The ledger's check against a run: grades, numbers, tests, sources; and that nothing is left without a claim.

The site's build, which prints an entry's texts, checks their citations and numbers.
"""

import ast
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from book.assembly import report, stamps
from book.assembly.contents import page_files
from book.assembly.results import look_up, parse
from book.ledger.entries import CONDITIONAL, FINDINGS, OUTSIDE, BadLedger, Evidence, Ledger, LedgerClaim, load, relation
from proofs.engine.project import PROJECT

KEY = re.compile(r"^@\w+\{\s*([^,\s]+)\s*,", re.MULTILINE)  # of the bibliography


@dataclass(frozen=True)
class Run:
    """Results of a run: the report's entries of theorems by id; pages, bibliography keys; and a question.

    number: the value of "figure.key", or ValueError.
    """

    entries: dict[str, dict]
    pages: frozenset[str]
    sources: frozenset[str]
    number: Callable[[str], Any]


def last_run() -> Run:
    """Return the last run over the sources as they are; raises report.NoReport where there is none."""
    book = PROJECT.pages
    return Run(
        entries=report.load(),
        pages=frozenset(page_files(book)),
        sources=frozenset(KEY.findall(PROJECT.bibliography.read_text(encoding="utf-8"))),
        number=lambda name: look_up(book, *parse(name)[:2]),
    )


def node_exists(node: str) -> bool:
    """Return whether a test of this node id, "tests/test_x.py::test_y", is there; its parameters are not looked at."""
    file, _, name = node.partition("::")
    return name.partition("[")[0] in tests_in(stamps.ROOT / file)


@cache
def tests_in(path: Path) -> dict[str, int]:
    """Return the tests of a file, and the line where each begins."""
    body = ast.parse(path.read_text(encoding="utf-8")).body if path.is_file() else ()
    functions = (node for node in body if isinstance(node, ast.FunctionDef))
    return {node.name: node.lineno for node in functions if node.name.startswith("test")}


def standing() -> tuple[Ledger, Run]:
    """Return the ledger, and the last run, which bears it out; raises BadLedger or NoReport."""
    ledger, run = load(), last_run()
    if faults := faults_in(ledger, run):
        raise BadLedger(faults)
    return ledger, run


def faults_in(ledger: Ledger, run: Run) -> list[str]:
    """Return every fault, one line each: the entry, the field, what is wrong."""
    of_claims = [f"{c.file}: {c.id}: {fault}" for c in ledger.claims for fault in _claim(c, ledger, run)]
    return [*ledger.faults, *of_claims, *(() if ledger.faults else _orphans(ledger, run))]


def refutes(piece: Evidence, run: Run) -> bool:
    """Return whether a piece of evidence speaks against its claim."""
    if piece.kind == "number":
        return bool(piece.claimed) and not relation(piece.claimed).holds(run.number(piece.name))
    if piece.refutes is None:
        return piece.kind == "theorem" and run.entries[piece.name]["grade"] == "refuted"
    return piece.refutes


def _claim(claim: LedgerClaim, ledger: Ledger, run: Run) -> Iterator[str]:
    place = claim.where.removeprefix("seed:")
    allowed, kind = (ledger.places, "place of the seed") if claim.of_seed else (sorted(run.pages), "page")
    if place and place not in allowed:
        yield f"where: {place!r} is no {kind}; there are: {', '.join(allowed)}"
    broken = [f"evidence {piece.name}: {why}" for piece in claim.evidence if (why := _odd(piece, run))]
    yield from broken or _verdict(claim, run)


def _odd(piece: Evidence, run: Run) -> str:
    """Return the fault of a piece of evidence; or ""."""
    if piece.kind == "number":
        try:
            value = run.number(piece.name)
        except ValueError as error:
            return f"number: {error}"
        if isinstance(value, str):
            return f"number: it is the text {value!r}"
        return "" if relation(piece.wants).holds(value) else f"is: {piece.wants} is expected, the run has {value}"
    if piece.kind == "test":
        return "" if node_exists(piece.name) else "test: there is no such test"
    if piece.kind == "source":
        return "" if piece.name in run.sources else "source: the bibliography has no such key"
    if piece.name not in run.entries:
        return "theorem: no theorem has this id"
    grade, expected = (run.entries[piece.name][of] for of in ("grade", "expected"))
    return "" if grade == expected else f"grade: {expected} is expected, the run made it {grade}"


def _verdict(claim: LedgerClaim, run: Run) -> Iterator[str]:
    """Return whether the evidence bears out the verdict; the evidence itself is in order."""
    against = [piece.name for piece in claim.evidence if refutes(piece, run)]
    if claim.verdict == "holds" and against:
        yield f"verdict: 'holds', but {', '.join(against)} refutes it"
    if claim.verdict in ("false", "corrected") and not against:
        yield f"verdict: {claim.verdict!r}, and none of its evidence refutes it"
    if claim.verdict == CONDITIONAL and len(against) == len(claim.evidence):
        yield f"verdict: {claim.verdict!r}, but all of its evidence refutes it"


def _orphans(ledger: Ledger, run: Run) -> Iterator[str]:
    """Return the theorems, findings and places of the seed that no claim accounts for."""
    needed = {piece.name for claim in ledger.claims for piece in claim.evidence if piece.kind == "theorem"}
    yield from (f"theorem {id}: no claim rests on it" for id in run.entries if id not in needed)
    codes = {code for claim in ledger.claims if claim.verdict != OUTSIDE for code in claim.findings}
    yield from (f"finding {code}: no claim has it" for code in FINDINGS if code not in codes)
    yield from (f"finding {code}: findings.toml has no name for it" for code in sorted(codes - FINDINGS.keys()))
    used = {claim.where for claim in ledger.claims}
    idle = (place for place in ledger.places if f"seed:{place}" not in used)
    yield from (f"place {place}: no claim of the seed stands there" for place in idle)
