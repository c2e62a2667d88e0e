"""The laboratory's page as data: its cells, each of prose and code; and as notebooks, each alone and all together."""

import re
from dataclasses import dataclass
from functools import cache

from myst_nb.core.read import read_myst_markdown_notebook
from nbformat import NotebookNode
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

from book.assembly.results import E_NOTATION, formatted, look_up, measured, parse
from book.assembly.website import BOOK
from book.notebooks import WHOLE
from book.releases.record import version
from proofs.engine.project import PROJECT

PAGE = BOOK / PROJECT.laboratory
HEADING = re.compile(r"^### Cell (\d+)\. (.+)$", re.MULTILINE)
ROLE = re.compile(r"\{(?P<role>[\w-]+)\}`(?P<text>[^`]*)`")
DIRECTIVE = re.compile(r"^:::\{(?P<name>[\w-]+)\} *(?P<argument>\S*)\n(?:.*\n)*?:::$", re.MULTILINE)


@dataclass(frozen=True)
class Part:
    """A piece of a cell: `text` is Markdown of the book, or code."""

    text: str
    is_code: bool = False


@dataclass(frozen=True)
class Cell:
    """A cell of the laboratory: its number, its title, its parts in order."""

    number: int
    title: str
    parts: tuple

    @property
    def name(self) -> str:
        return f"cell{self.number}"

    @property
    def code(self) -> str:
        """Return the code that it runs."""
        return "\n".join(part.text for part in self.parts if part.is_code)


@cache
def cells() -> tuple[Cell, ...]:
    """Return the laboratory's Cells."""
    _, *headed = HEADING.split(PAGE.read_text(encoding="utf-8"))  # number, title and text of each
    parts = [
        tuple(Part(cell.source.strip(), cell.cell_type == "code") for cell in read_myst_markdown_notebook(text).cells)
        for text in headed[2::3]
    ]
    return tuple(map(Cell, map(int, headed[::3]), headed[1::3], parts))


def number(text: str) -> str:
    """Return a figure's number in the format that a role's text asks for."""
    id, key, spec = parse(text)
    return formatted(look_up(BOOK, id, key), spec)


def _typeset(text: str) -> str:
    match = E_NOTATION.fullmatch(number(text))
    return rf"${match['mantissa']} \times 10^{{{int(match['exponent'])}}}$" if match else number(text)


def _said(match: re.Match) -> str:
    if match["role"] != "number":
        raise ValueError(f"the role {match['role']!r} of {PAGE.name} is not allowed: number")
    return _typeset(match["text"])


def _directive(match: re.Match) -> str:
    if match["name"] == "notebook":
        return ""
    if match["name"] != "benchmark-label":
        raise ValueError(f"the directive {match['name']!r} of {PAGE.name} is not allowed: notebook or benchmark-label")
    return measured(BOOK, match["argument"])


def plain(text: str) -> str:
    """Return prose of the page as plain Markdown: no targets, no roles, links as their words.

    Raises ValueError on a role or directive that a notebook cannot say.
    """
    text = re.sub(r"^\([\w-]+\)=\n?", "", text + "\n", flags=re.MULTILINE)
    text = ROLE.sub(_said, DIRECTIVE.sub(_directive, text))
    return re.sub(r"\[([^\]]+)\]\(#[^)]*\)", r"\1", text).strip()


KERNEL = {"display_name": "Python 3", "language": "python", "name": "python3"}
ABOUT = (
    "From *Bump Mapping, or the Derivative Is the Texture*, version {version}. It runs with Python 3.11 or "
    "newer, NumPy, SymPy, mpmath and Matplotlib: no network, no other file."
)


def a_notebook(title: str, body: list[dict]) -> NotebookNode:
    """Return a notebook that begins with its title."""
    top = new_markdown_cell(f"# {title}\n\n{ABOUT.format(version=version())}")
    every = [NotebookNode(cell, id=f"cell-{number}") for number, cell in enumerate([top, *body])]
    return new_notebook(cells=every, metadata={"kernelspec": KERNEL})


def notebooks() -> dict[str, NotebookNode]:
    """Return {name: notebook}, one of each cell and one of all."""
    alone: dict[str, NotebookNode] = {}
    everything: list[dict] = []
    for cell in cells():
        title = f"Cell {cell.number}. {cell.title}"
        body = [new_code_cell(p.text) if p.is_code else new_markdown_cell(plain(p.text)) for p in cell.parts]
        body = [part for part in body if part["source"]]
        alone[cell.name] = a_notebook(title, body)
        everything += [new_markdown_cell(f"## {title}"), *body]
    return alone | {WHOLE: a_notebook("The laboratory", everything)}
