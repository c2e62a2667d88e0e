"""The laboratory's notebooks: held by the link beside each cell, and written into the site for Colab.

:::{notebook} cell1
:::

A link to Colab stands beside it where `repository.url` of `_config.yml` names a repository of GitHub's: Colab opens a
notebook from a branch, so that it has to be the one that the site is published on, `repository.branch`.
"""

import base64
import re
from collections.abc import Iterable
from functools import partial
from itertools import groupby
from operator import itemgetter
from pathlib import Path
from typing import NamedTuple

import yaml
from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from book.assembly import stamps
from book.extension.elements import Page, directive, filled, on_page
from book.notebooks import WHOLE

FOLDER = "_downloads/notebooks"
GITHUB = re.compile(r"https://github\.com/(?P<repository>[\w.-]+/[\w.-]+?)(?:\.git)?/?")
CODE = (
    'cell_input docutils container">\n<div class="highlight-ipython3 notranslate">'
    '<div class="highlight"><pre><span></span>'
)
INPUT = re.compile(f"(?<={CODE}).*?(?=</pre>)", re.DOTALL)
PARAGRAPH = re.compile(r"(?:.+\n?)+\n*")
DEFINED = re.compile(r"^def (\w+)", re.MULTILINE)
FEWEST = 3  # lines that are worth a fold


def colab_address(settings: dict, name: str) -> str | None:
    """The address that opens a notebook in Colab, or None where `_config.yml` names no repository of GitHub's."""
    url, branch = settings["repository"]["url"], settings["repository"]["branch"]
    if match := GITHUB.fullmatch(url):
        return f"https://colab.research.google.com/github/{match['repository']}/blob/{branch}/{FOLDER}/{name}.ipynb"
    return None


@directive("notebook", arguments=1)
def notebook_links(here: SphinxDirective) -> list[nodes.Node]:
    from book.notebooks.laboratory import cells  # which imports this package
    from book.notebooks.notebook import notebooks, text_of

    name = here.arguments[0]
    titles = {cell.name: f"Cell {cell.number}" for cell in cells()} | {WHOLE: "all eight cells"}
    if name not in titles:
        raise ValueError(f"{name!r} is not allowed: one of {', '.join(titles)}")
    config = Path(here.env.srcdir, "_config.yml").read_text(encoding="utf-8")
    words = "notebook of all eight cells" if name == WHOLE else "notebook"
    colab = colab_address(yaml.safe_load(config), name)
    text = base64.b64encode(text_of(notebooks()[name]).encode()).decode()
    address = f"data:application/x-ipynb+json;base64,{text}"  # it is saved from a disk too, where a file is shown
    link = {"address": address, "file": f"{name}.ipynb", "words": words, "title": titles[name], "colab": colab}
    return [filled("notebook_links", **link)]


@partial(on_page, priority=400)
def offer_notebooks(page: Page) -> None:
    """Write the notebooks, which Colab opens from the site; the theme lists that of all cells in its download menu."""
    from book.notebooks.notebook import notebooks, text_of

    if not _has_cells(page):
        return
    out = Path(page.app.outdir)
    for name, notebook in notebooks().items():
        stamps.write_whole(out / FOLDER / f"{name}.ipynb", text_of(notebook).encode())
    stamps.write_whole(out / "_sources" / f"{page.name}.ipynb", (out / FOLDER / f"{WHOLE}.ipynb").read_bytes())
    page.context["ipynb_source"] = f"{page.name}.ipynb"


@on_page
def fold_what_repeats(page: Page) -> None:
    """Fold the lines that a cell shares with earlier ones, and mark those that are new in it."""
    from book.notebooks.laboratory import PAGE, cells

    if page.name == PAGE.stem and _has_cells(page):
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
        paragraphs = PARAGRAPH.findall(source)
        marked = [(paragraph.strip() in known, paragraph) for paragraph in paragraphs]
        known |= {paragraph.strip() for paragraph in paragraphs}
        of_source = []
        for repeats, some in groupby(marked, itemgetter(0)):
            text = "".join(paragraph for _, paragraph in some)
            of_source.append(Run(len(text.splitlines()), repeats, DEFINED.findall(text)))
        found.append(of_source)
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


def _has_cells(page: Page) -> bool:
    containers = page.doctree.findall(nodes.container) if page.doctree else ()
    return any(node.get("nb_element") == "cell_code" for node in containers)
