"""The report of the proofs' run, which the book prints from: whether it belongs to the sources as they are."""

import hashlib
import subprocess
import sys
from pathlib import Path

from book.assembly import stamps
from proofs.engine.project import FILE, PROJECT
from verify.checkers import second_checker
from verify.coq import formal

REPORT = PROJECT.report


class NoReport(ValueError):
    """There is no report, or it was made from other sources."""


def packages() -> list[Path]:
    """Return every file of the packages: a proof may read what it does not import."""
    folders = [*map(PROJECT.folder, PROJECT.packages), *map(stamps.HOME.joinpath, ("proofs", "renderer", "verify"))]
    return [path for folder in folders for path in stamps.files_in(folder)]


def reported_hashes() -> dict[str, str]:
    files = (stamps.LOCK_FILE, PROJECT.root / FILE, PROJECT.bibliography, second_checker.SCRIPT)
    return stamps.hashes([*packages(), *files])


def _stamp(sources):
    return {"sources": stamps.key(sources), "report": hashlib.sha256(REPORT.read_bytes()).hexdigest()}


def remember(before: dict[str, str]) -> None:
    stamps.write("report", _stamp(before) | {"Coq": formal.accepted_here()})


def is_fresh() -> bool:
    """Return whether the report is the one that a run over the sources as they are has written."""
    return REPORT.is_file() and (stamps.read("report") or {}).items() >= _stamp(reported_hashes()).items()


def make() -> None:
    """Run the theorems, which writes their report, unless it is fresh, and says if Coq was asked."""
    if is_fresh() and (stamps.read("report") or {})["Coq"] == formal.accepted_here():
        print("  the report of the proofs is up to date")
        return
    before = reported_hashes()
    stamps.remove("report")
    command = [sys.executable, "-m", "pytest", str(stamps.HOME / "verify" / "test_theorems.py"), "-q", "-n", "2"]
    cache = f"cache_dir={stamps.ROOT / '.pytest_cache'}"
    subprocess.run([*command, "-o", cache], cwd=stamps.ROOT, check=True)
    remember(before)


def load() -> dict[str, dict]:
    """Return the report's entries, {id: entry}; raises NoReport if it is missing or stale."""
    if not is_fresh():
        raise NoReport("there is no report of the proofs, or it is stale: python -m book makes it")
    return {entry["id"]: entry for entry in stamps.table_in(REPORT)["theorems"]}


def asked() -> dict[str, bool]:
    """Return whether the second checker and Coq have read, on this machine, what the report is about."""
    return stamps.table_in(REPORT)["asked"]
