"""The parts of a claim's evidence that a template cannot print: numbers with links, and where a test begins."""

import re
from functools import cache
from pathlib import Path, PurePosixPath

from docutils import nodes

from book.assembly import stamps
from book.assembly.contents import placed
from book.assembly.results import BENCHMARK_PREFIX
from book.extension.cards import link
from book.extension.figures import file_link
from book.extension.listings import listing_address
from book.extension.numbers import mark, typeset
from book.extension.theorems import Here
from book.ledger.check import refutes, tests_in
from book.ledger.entries import WORDS, Evidence, relation
from renderer.picture.differences import Interval


def number_nodes(book: Here, piece: Evidence) -> list[nodes.Node]:
    """A number with its link, and what the claim has in its place where that is something else."""
    value = book.run.number(piece.name)
    large = not isinstance(value, Interval) and abs(value) >= 1000
    spec = (",.0f" if isinstance(value, float) else ",") if large else None
    told = [nodes.Text(", where the claim has "), *in_signs(piece.claimed)] if refutes(piece, book.run) else []
    marked = mark(Path(book.env.srcdir), piece.name.partition(".")[0])
    return [_place_of_number(book, piece.name), nodes.Text(" = "), *typeset(value, spec), *marked, *told]


def in_signs(text: str) -> list[nodes.Node]:
    """A relation as it is set in type: = 0, ≥ 2, 0.45 to 0.65."""
    asked = relation(text)
    numbers = [
        typeset(int(n) if n.is_integer() and abs(n) < 1e6 else n, None if n.is_integer() else ".4g")
        for n in asked.numbers
    ]
    if asked.sign == "in":
        return [*numbers[0], nodes.Text(" to "), *numbers[1]]
    return [nodes.Text({"==": "", "!=": "not ", "<=": "≤ ", ">=": "≥ "}.get(asked.sign, f"{asked.sign} ")), *numbers[0]]


def _place_of_number(book: Here, name: str) -> nodes.Node:
    """A link to the figure that a number belongs to, to the benchmark's page, or to the file of the numbers."""
    figure, _, key = name.partition(".")
    text = WORDS.get(name) or re.sub("_+", " ", key)
    if figure.startswith(BENCHMARK_PREFIX):
        return link(text, book.page("benchmark"))
    if page := figure_pages(Path(book.env.srcdir)).get(figure):
        return link(text, f"{book.page(page)}#fig-{figure}")
    target = f"/_generated/{figure}.json"
    return file_link(text, target, f"{figure}.json")


@cache
def figure_pages(book: Path) -> dict[str, str]:
    """The page on which each figure is placed."""
    return dict(placed(book, "chapter-figure"))


def test_address(node: str) -> str:
    """The address of a test, "file.py::name", on the page of its file."""
    file, _, name = node.partition("::")
    return f"{listing_address(PurePosixPath(file))}#L-{tests_in(stamps.ROOT / file)[name.partition('[')[0]]}"
