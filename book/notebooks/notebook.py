"""The notebooks: one for every cell of the laboratory, and one of them all."""

import json
import re

from book.notebooks import WHOLE
from book.notebooks.first_cell import closure, first_cell, version
from book.notebooks.laboratory import EXPECTED, SKIPPED, cells, cited, plain
from book.notebooks.slices import needed

KERNEL = {"display_name": "Python 3", "language": "python", "name": "python3"}
ABOUT = (
    "From §5 of *Bump Mapping, or the Derivative Is the Texture*, version {version}. This notebook needs Python 3.11 "
    "or newer with NumPy, SymPy, mpmath and Matplotlib, and nothing else: no network, no other file. Where llvmlite "
    "is installed, LLVM compiles what draws; elsewhere NumPy does it, more slowly, to the same last bit."
)
LAST = 'print(f"{time.perf_counter() - BEGAN:.1f} s since the first cell, drawn by {machine().NAME}")'


def markdown(source):
    """Return a cell of prose, without an id."""
    return {"cell_type": "markdown", "metadata": {}, "source": source}


def code(source, outputs=(), **metadata):
    """Return a cell of code, without an id; what it printed when the page was built may be given."""
    ran = {"execution_count": None, "outputs": list(outputs)}
    return {"cell_type": "code", "metadata": metadata, "source": source} | ran


def _expectations(cell, source):
    """Return a cell's expectations, after the numbers that its prose cites if they ask for one."""
    if "cited[" not in source:
        return source
    numbers = cited("\n".join(part.text for part in cell.parts if not part.is_code))
    return f"cited = {json.dumps(numbers, indent=4, ensure_ascii=False)}\n\n{source}"


def _body(cell, outputs):
    """Return a cell's own cells."""
    found = [markdown(f"## Cell {cell.number}. {cell.title}")]
    for part in cell.parts:
        if not part.is_code:
            if text := plain(part.text):
                found.append(markdown(text))
        elif EXPECTED in part.tags:
            found.append(code(_expectations(cell, part.text)))
        else:
            found.append(code(part.text, () if SKIPPED in part.tags else outputs.get(part.text, ())))
    return found


def _earlier(own):
    """Return the source of what a cell needs of the cells before it, imports first; empty if nothing."""
    before = [cell.run_on_the_page for cell in cells() if cell.number < own.number]
    lines = needed(own.code, before)
    imports = [line for line in lines if line.startswith(("import ", "from "))]
    others = [f"\n\n{line}\n\n" if line.startswith("def ") else line for line in lines if line not in imports]
    text = "\n".join(["# From the cells before this one.", *imports, "", *others]).strip()
    return re.sub(r"\n{4,}", "\n\n\n", text) if lines else ""


def _whole(title, middle):
    """Return the notebook of some cells under a title, its first and last cell put around them."""
    code_cells = [cell["source"] for cell in middle if cell["cell_type"] == "code"]
    sources = closure("\n".join(["import renderer.machines", *code_cells]))
    top = markdown(f"# {title}\n\n{ABOUT.format(version=version())}")
    every = [top, code(first_cell(sources), jupyter={"source_hidden": True}), *middle, code(LAST)]
    for number, cell in enumerate(every):
        cell["id"] = f"cell-{number}"
    return {"cells": every, "metadata": {"kernelspec": KERNEL}, "nbformat": 4, "nbformat_minor": 5}


def notebooks(outputs=None):
    """Return {name: notebook}, nine of them. outputs: {a cell's source: what it printed when the page was built}."""
    outputs, found, everything = outputs or {}, {}, []
    for cell in cells():
        body, earlier = _body(cell, outputs), _earlier(cell)
        everything += body
        found[cell.name] = _whole(f"Cell {cell.number}. {cell.title}", ([code(earlier)] if earlier else []) + body[1:])
    found[WHOLE] = _whole("The laboratory", [dict(cell) for cell in everything])
    return found


def text_of(notebook):
    """Return a notebook as the text of its file: the same in every build."""
    return json.dumps(notebook, indent=1, ensure_ascii=False, sort_keys=True) + "\n"
