"""The laboratory's notebooks: held by the link beside each cell, and written into the site for Colab.

:::{notebook} cell1
:::

Links to Colab and Binder stand beside it where `repository.url` of `_config.yml` names a repository of GitHub's: they
open a notebook from a branch, `repository.branch`, to which the workflow that publishes the site gives it too.
"""

import re
from collections.abc import Iterable
from functools import partial
from itertools import groupby
from pathlib import Path
from typing import NamedTuple

import nbformat
from sphinx.util.docutils import SphinxDirective

from book.assembly import stamps
from book.editions.inlined import base64_address
from book.extension.elements import Nodes, Page, directive, filled, on_page
from book.notebooks import WHOLE
from book.notebooks.laboratory import PAGE, cells, notebooks

FOLDER = "_downloads/notebooks"
GITHUB = re.compile(r"https://github\.com/([\w.-]+/[\w.-]+?)(?:\.git)?/?")
PINNED = re.compile(r"^(?:matplotlib|mpmath|numpy|sympy)==[^\\\n]*[^\\\s]", re.MULTILINE)  # what the cells import
CODE = (
    'cell_input docutils container">\n<div class="highlight-ipython3 notranslate">'
    '<div class="highlight"><pre><span></span>'
)
INPUT = re.compile(f"(?<={CODE}).*?(?=</pre>)", re.DOTALL)
PARAGRAPH = re.compile(r"(?:.+\n?)+\n*")
DEFINED = re.compile(r"^def (\w+)", re.MULTILINE)
FEWEST = 3  # lines that are worth a fold


@directive("notebook", arguments=1)
def notebook_links(here: SphinxDirective) -> Nodes:
    name = here.arguments[0]
    titles = {cell.name: f"Cell {cell.number}" for cell in cells()} | {WHOLE: "all cells"}
    if name not in titles:
        raise ValueError(f"{name!r} is not allowed: one of {', '.join(titles)}")
    config = stamps.table_in(Path(here.env.srcdir, "_config.yml"))["repository"]
    match, content = GITHUB.fullmatch(config["url"]), nbformat.writes(notebooks()[name]).encode()
    link = {
        "name": name,
        "title": titles[name],
        "words": "notebook of all cells" if name == WHOLE else "notebook",
        "address": base64_address("application/x-ipynb+json", content),  # saved from a disk too, where a file is shown
        "repository": match and match[1],
        "branch": config["branch"],
        "folder": FOLDER,
    }
    return [filled("notebook_links", **link)]


@partial(on_page, priority=400)
def offer_notebooks(page: Page) -> None:
    """Write the notebooks, and what Binder installs; the theme lists that of all cells in its download menu."""
    if page.name != PAGE.stem:
        return
    out = Path(page.app.outdir)
    for name, notebook in notebooks().items():
        stamps.write_whole(out / FOLDER / f"{name}.ipynb", nbformat.writes(notebook).encode())
    lock = stamps.LOCK_FILE.read_text(encoding="utf-8")
    stamps.write_whole(out / "requirements.txt", "\n".join([*PINNED.findall(lock), ""]).encode())
    stamps.write_whole(out / "_sources" / f"{page.name}.ipynb", (out / FOLDER / f"{WHOLE}.ipynb").read_bytes())
    page.context["ipynb_source"] = f"{page.name}.ipynb"


@on_page
def fold_what_repeats(page: Page) -> None:
    """Fold the lines that a cell shares with earlier ones, and mark those that are new in it."""
    if page.name == PAGE.stem:
        runs = iter(repeated([part.text for cell in cells() for part in cell.parts if part.is_code]))
        page.context["body"] = INPUT.sub(lambda code: _folded(code[0], next(runs)), page.context["body"])


class Run(NamedTuple):
    """Lines of a cell that follow each other: all in earlier cells too, or all new; and the functions they define."""

    lines: int
    repeats: bool
    functions: list[str]


def repeated(sources: Iterable[str]) -> list[list[Run]]:
    """Return the Runs of every source. A paragraph repeats if an earlier source has it, word for word."""
    known: set[str] = set()
    found = []
    for source in sources:
        paragraphs, runs = PARAGRAPH.findall(source), []
        for repeats, some in groupby(paragraphs, lambda paragraph: paragraph.strip() in known):
            text = "".join(some)
            runs.append(Run(len(text.splitlines()), repeats, DEFINED.findall(text)))
        known.update(map(str.strip, paragraphs))
        found.append(runs)
    return found


def _folded(code: str, runs: list[Run]) -> str:
    """Return a cell's lines as HTML; where none is from another cell, nothing is marked."""
    lines, pieces = code.splitlines(keepends=True), []
    if not any(run.repeats for run in runs):
        return code
    for run in runs:
        piece, lines = "".join(lines[: run.lines]), lines[run.lines :]
        said = f": {', '.join(run.functions)}" if run.functions else ""
        summary = f"<summary># As before{said} ({run.lines} lines)</summary>"
        folds = run.repeats and run.lines >= FEWEST
        pieces.append(f"<details>{summary}{piece}</details>" if folds else f'<span class="new-lines">{piece}</span>')
    return "".join(pieces + lines)
