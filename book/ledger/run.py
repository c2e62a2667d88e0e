"""What the last run found, gathered for the ledger: the report, the figures' numbers, the tests, the bibliography."""

import ast
import re
from functools import cache
from pathlib import Path

from book.assembly import report, stamps
from book.assembly.contents import page_files
from book.assembly.results import look_up, parse
from book.ledger.check import Run

KEY = re.compile(r"^@\w+\{\s*([^,\s]+)\s*,", re.MULTILINE)


def last_run() -> Run:
    """The last run over the sources as they are; raises report.NoReport where there is none."""
    book, entries = stamps.ROOT / "book", report.load()
    return Run(
        grades={id: entry["grade"] for id, entry in entries.items()},
        expected={id: entry["expected"] for id, entry in entries.items()},
        pages=frozenset(page_files(book)),
        sources=frozenset(KEY.findall((book / "references.bib").read_text(encoding="utf-8"))),
        number=lambda name: look_up(book, *parse(name)[:2]),
        test=lambda node: node_exists(stamps.ROOT, node),
    )


def node_exists(root: Path, node: str) -> bool:
    """Whether a test of this node id, "tests/test_x.py::test_y", is there; its parameters are not looked at."""
    file, _, name = node.partition("::")
    return name.partition("[")[0] in tests_in(root / file)


@cache
def tests_in(path: Path) -> dict[str, int]:
    """The tests of a file, and the line where each begins."""
    body = ast.parse(path.read_text(encoding="utf-8")).body if path.is_file() else ()
    functions = (node for node in body if isinstance(node, ast.FunctionDef))
    return {node.name: node.lineno for node in functions if node.name.startswith("test")}
