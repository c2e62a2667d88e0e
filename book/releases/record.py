"""The record of a release: grades of theorems, numbers with their tolerances, measured ratios, digests of pictures.

It is made from what `python -m book figures` and the theorems' run have left in book/_generated, and from the committed
results of `make bench`; it has no date and no commit, so that the same sources give the same bytes. A tolerance says
how far a number may move between releases without being named.
"""

import math
from fnmatch import fnmatchcase
from functools import cache
from pathlib import Path

from book.assembly import report, stamps
from book.releases.pictures import arrays_of, digest
from proofs.engine.project import PROJECT
from proofs.engine.theorem import Theorem, all_theorems
from proofs.printers.coq_statements import statements
from verify.coq import recorded

GENERATED, BENCHMARKS = PROJECT.generated, PROJECT.root / PROJECT.benchmarks
RULES = stamps.ROOT / "releases" / "tolerances.toml"
ANY = "any"  # of a label, which may be anything


def version() -> str:
    return stamps.table_in(stamps.ROOT / "pyproject.toml")["project"]["version"]


def make() -> dict:
    """Return the record of what is built now. NoReport if the theorems' report is missing or stale."""
    paths = [path for path in sorted(GENERATED.glob("*.json")) if path.name != report.REPORT.name]
    figures = [stamps.table_in(path) for path in paths]
    return {
        "version": version(),
        "theorems": theorems(),
        "numbers": {k: v for figure in figures for k, v in _numbers(figure["id"], figure["numbers"]).items()},
        "measured": {path.stem: _measured(path) for path in sorted(BENCHMARKS.glob("*.json"))},
        "pictures": {f["id"]: _picture(f) for f in figures if f["kind"] != "numbers"},
    }


def theorems() -> dict[str, dict]:
    """Return {id: its grade in the last run, the words of its statement, the digests of claims and pins, by name}."""
    entries, stated = report.load(), all_theorems()
    return {
        id: {
            "grade": entry["grade"],
            "given": entry["given_cited"],
            "statement": stated[id].words,
            "says": says(stated[id]),
        }
        for id, entry in sorted(entries.items())
    }


def says(theorem: Theorem) -> dict[str, str]:
    """Return the digests of a theorem's hypotheses, of its claims as they are printed for Coq, and of what it pins."""
    printed = {"hypotheses": " ".join(theorem.hypotheses)} | statements(theorem)
    return {name: recorded.digest(text) for name, text in printed.items()} | {
        pin.name: pin.digest for pin in theorem.pinned
    }


def _numbers(source: str, numbers: dict) -> dict[str, dict]:
    named = {f"{source}.{key}": value for key, value in sorted(numbers.items())}
    return {name: {"value": value, "tolerance": tolerance(name, value)} for name, value in named.items()}


def _measured(path: Path) -> dict:
    content = stamps.table_in(path)
    return {"numbers": _numbers(f"bench:{path.stem}", content["numbers"])}


def _picture(figure: dict) -> dict[str, str]:
    """Return the name of a picture's file of data, and the digest of its pixels or of the curves that it has."""
    return {"data": figure["data"], "content": digest(arrays_of(GENERATED / figure["data"]))}


@cache
def rules(path: Path = RULES) -> dict:
    """Return the file of rules; ValueError where a rule lacks its reason or its tolerance is not a number ≥ 0."""
    content = stamps.table_in(path)
    for rule in content["rule"]:
        if not rule.get("why", "").strip():
            raise ValueError(f"{path.name}: the rule for {rule['numbers']} needs a why")
        if not rule["within"] >= 0:
            raise ValueError(f"{path.name}: within = {rule['within']} is not allowed: a number ≥ 0, or inf")
    return content


def tolerance(name: str, value: int | float | str) -> float | str:
    """Return the tolerance of a number: relative, 0 for exact, "any" for a label."""
    for rule in rules()["rule"]:
        if any(fnmatchcase(name, pattern) for pattern in rule["numbers"]):
            if rule["within"] == float("inf"):
                return ANY
            return 0 if isinstance(value, str) else rule["within"]
    return rules()["floats"] if isinstance(value, float) else 0


def is_within(before: int | float | str, after: int | float | str, allowed: float | str) -> bool:
    """Return whether a number is still what it was, as far as its tolerance says."""
    if allowed == ANY or (before == after and type(before) is type(after)):
        return True
    if isinstance(before, str) or isinstance(after, str):
        return False
    return math.isclose(before, after, rel_tol=float(allowed))
