"""The laboratory's notebooks: held by the link beside each cell, and written into the site for Colab.

:::{notebook} cell1
:::

A link to Colab stands beside it where `repository.url` of `_config.yml` names a repository of GitHub's: it opens the
notebook from a branch, `repository.branch`, to which the workflow that publishes the site gives it too.
"""

import re
from base64 import b64decode
from itertools import groupby
from pathlib import Path

import nbformat
from nbformat import NotebookNode
from sphinx.util.docutils import SphinxDirective

from book.assembly import stamps
from book.editions.inlined import base64_address
from book.extension.elements import Nodes, Page, directive, filled, on_page
from book.notebooks import WHOLE
from book.notebooks.laboratory import PAGE, cells, notebooks

FOLDER = "_downloads/notebooks"
GITHUB = re.compile(r"https://github\.com/([\w.-]+/[\w.-]+?)(?:\.git)?/?")
CODE = (
    'cell_input docutils container">\n<div class="highlight-ipython3 notranslate">'
    '<div class="highlight"><pre><span></span>'
)
INPUT = re.compile(f"(?<={CODE}).*?(?=</pre>)", re.DOTALL)
HELD = re.compile(r'ipynb\+json;base64,([^"]+)"[^>]+download="(\w+\.ipynb)"')
PARAGRAPH = re.compile(r"(?:.+\n?)+\n*")
UNCOLOURED = re.compile(r'<span class="[npw]">([^<]*)</span>')  # names, signs and blanks, half of the page's bytes
SHOWN = ("# Knobs:", "# Here:")  # the beginnings of lines that are not folded


@directive("notebook", arguments=1)
def notebook_links(here: SphinxDirective) -> Nodes:
    name = here.arguments[0]
    titles = {cell.name: f"Cell {cell.number}" for cell in cells()} | {WHOLE: "all cells"}
    code = "" if name == WHOLE else f"#{name} .cell_input pre"
    return ways_to_run(here, name, titles[name], notebooks()[name], code)


def ways_to_run(here: SphinxDirective, name: str, title: str, notebook: NotebookNode, code: str) -> Nodes:
    """Return links to a notebook; code: the selector of the text that a button copies, if there is one."""
    config = stamps.table_in(Path(here.env.srcdir, "_config.yml"))["repository"]
    match, content = GITHUB.fullmatch(config["url"]), nbformat.writes(notebook).encode()
    link = {
        "name": name,
        "title": title,
        "code": code,
        "address": base64_address("application/x-ipynb+json", content),  # saved from a disk too, where a file is shown
        "repository": match and match[1],
        "branch": config["branch"],
        "folder": FOLDER,
    }
    return [filled("notebook_links", **link)]


@on_page
def write_notebooks(page: Page) -> None:
    for content, name in HELD.findall(page.context.get("body", "")):
        stamps.write_whole(Path(page.app.outdir, FOLDER, name), b64decode(content))


@on_page
def fold_the_rest(page: Page) -> None:
    """Fold all of a cell but its knobs and the lines that decide."""
    if page.name == PAGE.stem:
        sources = iter([part.text for cell in cells() for part in cell.parts if part.is_code])
        page.context["body"] = INPUT.sub(lambda code: _folded(code[0], next(sources)), page.context["body"])


def _folded(code: str, source: str) -> str:
    """Return a cell's lines as HTML."""
    lines, pieces = UNCOLOURED.sub(r"\1", code).splitlines(keepends=True), []
    for shown, paragraphs in groupby(PARAGRAPH.findall(source), lambda paragraph: paragraph.startswith(SHOWN)):
        count = len("".join(paragraphs).splitlines())
        piece, lines = "".join(lines[:count]), lines[count:]
        pieces.append(piece if shown else f"<details><summary># {count} lines</summary>{piece}</details>")
    return "".join(pieces + lines)
