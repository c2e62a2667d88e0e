"""Run the proofs' checker when something that it can reach changed."""

from collections.abc import Iterator
from pathlib import Path

from book.assembly import report, stamps

# Whole folders, code and data: a proof may read what it does not import.
FOLDERS = ("proofs", "renderer", "verify", "book", "tests/data")
FILES = ("requirements.lock", "pyproject.toml", "conftest.py")
PROSE = {".md", ".bib", ".css", ".yml", ".toml"}


def checked_files() -> Iterator[Path]:
    """Every file that the proofs can depend on: all but the book's prose and looks."""
    for folder in FOLDERS:
        for path in stamps.files_in(stamps.ROOT / folder):
            if folder != "book" or path.suffix not in PROSE:
                yield path
    yield from (stamps.ROOT / name for name in FILES)


def run() -> None:
    """Run `pytest verify`, which writes the report that the book reads, or say why there is no need to."""
    now = stamps.hashes(checked_files())
    if stamps.read("check") == now | {"report": report.digest()}:
        print("  skipped: they passed, and nothing that they can reach has changed since")
        return
    stamps.remove("check")
    report.run("verify")
    stamps.write("check", now | {"report": report.digest()})
