"""The notebooks: the laboratory's cells as they stand on the page, each alone and all together."""

import json

from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

from book.notebooks import WHOLE
from book.notebooks.laboratory import cells, plain
from book.releases.record import version

KERNEL = {"display_name": "Python 3", "language": "python", "name": "python3"}
ABOUT = (
    "From §5 of *Bump Mapping, or the Derivative Is the Texture*, version {version}. It runs with Python 3.11 or "
    "newer, NumPy, SymPy, mpmath and Matplotlib: no network, no other file."
)


def _notebook(title: str, body: list[dict]) -> dict:
    top = new_markdown_cell(f"# {title}\n\n{ABOUT.format(version=version())}")
    every = [cell | {"id": f"cell-{number}"} for number, cell in enumerate([top, *body])]
    return new_notebook(cells=every, metadata={"kernelspec": KERNEL})


def notebooks() -> dict[str, dict]:
    """Return {name: notebook}, one of each cell and one of all."""
    alone: dict[str, dict] = {}
    everything: list[dict] = []
    for cell in cells():
        title = f"Cell {cell.number}. {cell.title}"
        body = [new_code_cell(p.text) if p.is_code else new_markdown_cell(plain(p.text)) for p in cell.parts]
        body = [part for part in body if part["source"]]
        alone[cell.name] = _notebook(title, body)
        everything += [new_markdown_cell(f"## {title}"), *body]
    return alone | {WHOLE: _notebook("The laboratory", everything)}


def text_of(notebook: dict) -> str:
    """Return a notebook as the text of its file: the same in every build."""
    return json.dumps(notebook, indent=1, ensure_ascii=False, sort_keys=True) + "\n"
