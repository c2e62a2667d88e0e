"""The report of the proofs' run, which the book prints from: whether it belongs to the sources as they are."""

import hashlib
import subprocess
import sys
from pathlib import Path

from book.assembly import stamps
from verify import formal

REPORT = stamps.ROOT / "book" / "_generated" / "proofs.json"
REMEDY = "python -m book check makes it"


class NoReport(ValueError):
    """There is no report, or it was made from other sources."""


def packages() -> list[Path]:
    """Every file of the packages: a proof may read what it does not import."""
    return [path for folder in ("proofs", "renderer", "verify") for path in stamps.files_in(stamps.ROOT / folder)]


def reported_hashes() -> dict[str, str]:
    return stamps.hashes([*packages(), stamps.LOCK_FILE, stamps.ROOT / "book" / "references.bib"])


def digest() -> str:
    """The hash of the report as it lies there, or "none"."""
    return hashlib.sha256(REPORT.read_bytes()).hexdigest() if REPORT.is_file() else "none"


def _stamp(sources):
    return {"sources": stamps.key(sources), "report": digest()}


def remember(before: dict[str, str]) -> None:
    stamps.write("report", _stamp(before) | {"Coq": formal.accepted_here()})


def run(tests: str) -> None:
    """Run tests of the checker, which write the report, and note from which sources it was made."""
    before = reported_hashes()
    stamps.remove("report")
    subprocess.run([sys.executable, "-m", "pytest", tests, "-q", "-n", "2"], cwd=stamps.ROOT, check=True)
    remember(before)


def is_fresh() -> bool:
    """Whether the report is the one that a run over the sources as they are has written."""
    return REPORT.is_file() and (stamps.read("report") or {}).items() >= _stamp(reported_hashes()).items()


def make() -> None:
    """Run the theorems, and nothing else of the checker, unless their report is fresh, and says if Coq was asked."""
    if is_fresh() and (stamps.read("report") or {})["Coq"] == formal.accepted_here():
        print("  the report of the proofs is up to date")
    else:
        run("verify/test_theorems.py")


def load() -> dict[str, dict]:
    """The report's entries, {id: entry}; raises NoReport if it is missing or stale."""
    if not REPORT.is_file():
        raise NoReport(f"there is no report of the proofs; {REMEDY}")
    if not is_fresh():
        raise NoReport(f"the report of the proofs is stale: proofs/, renderer/ or verify/ changed since; {REMEDY}")
    return {entry["id"]: entry for entry in stamps.table_in(REPORT)["theorems"]}


def asked() -> dict[str, bool]:
    """Whether the second checker and Coq have read, on this machine, what the report is about."""
    return stamps.table_in(REPORT)["asked"]
