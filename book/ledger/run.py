"""What the last run found, gathered for the ledger: the report, the figures' numbers, the tests, the bibliography."""

import ast
import re
from functools import cache
from pathlib import Path

from book.build import report, stamps
from book.build.contents import page_files
from book.extension.results import look_up
from book.extension.theorems import kind
from book.ledger.check import Run

KEY = re.compile(r"^@\w+\{\s*([^,\s]+)\s*,", re.MULTILINE)


def last_run(root: Path = stamps.ROOT) -> Run:
    """The last run over the sources as they are; raises report.NoReport where there is none."""
    book = root / "book"
    return Run(
        grades={id: kind(entry["grade"]) for id, entry in report.load().items()},
        pages=frozenset(page_files(book)),
        sources=frozenset(KEY.findall((book / "references.bib").read_text(encoding="utf-8"))),
        number=lambda name: look_up(book, *split(name)),
        test=lambda node: node_exists(root, node),
    )


def split(name: str) -> tuple[str, str]:
    """The figure and the key of "figure.key"; a key may hold dots, an id none."""
    id, dot, key = name.partition(".")
    if not (id and dot and key):
        raise ValueError(f"{name!r} is not of the form figure.key")
    return id, key


def node_exists(root: Path, node: str) -> bool:
    """Whether a test of this node id, "tests/test_x.py::test_y", is there; its parameters are not looked at."""
    file, _, name = node.partition("::")
    return bool(name) and name.partition("[")[0] in _tests(root / file)


@cache
def _tests(path: Path) -> frozenset[str]:
    if not path.is_file():
        return frozenset()
    found = set()
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.FunctionDef):
            found.add(node.name)
        if isinstance(node, ast.ClassDef):
            found |= {f"{node.name}::{inner.name}" for inner in node.body if isinstance(inner, ast.FunctionDef)}
    return frozenset(name for name in found if name.rpartition("::")[2].startswith("test"))
