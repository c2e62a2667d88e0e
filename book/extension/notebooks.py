"""The laboratory's notebooks: held by the link beside each cell, and written into the site for Colab.

:::{notebook} cell1
:::

Links to Colab and Binder stand beside it where `repository.url` of `_config.yml` names a repository of GitHub's: they
open a notebook from a branch, `repository.branch`, to which the workflow that publishes the site gives it too.
"""

import base64
import re
from functools import partial
from pathlib import Path

import yaml
from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from book.assembly import stamps
from book.extension.elements import Page, directive, filled, on_page
from book.notebooks import WHOLE

FOLDER = "_downloads/notebooks"
GITHUB = re.compile(r"https://github\.com/(?P<repository>[\w.-]+/[\w.-]+?)(?:\.git)?/?")
PINNED = re.compile(r"^(?:matplotlib|mpmath|numpy|sympy)==[^\s;]+", re.MULTILINE)  # what the cells import
SUMMARY = "<summary># The scene of §2, line for line as in Cell 1</summary>"


def addresses(settings: dict, name: str) -> dict[str, str]:
    """Where a notebook is opened: {service: address}, empty where `_config.yml` names no repository of GitHub's."""
    url, branch = settings["repository"]["url"], settings["repository"]["branch"]
    if match := GITHUB.fullmatch(url):
        repository, path = match["repository"], f"{FOLDER}/{name}.ipynb"
        return {
            "Colab": f"https://colab.research.google.com/github/{repository}/blob/{branch}/{path}",
            "Binder": f"https://mybinder.org/v2/gh/{repository}/{branch}?urlpath=lab/tree/{path}",
        }
    return {}


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
    services = addresses(yaml.safe_load(config), name)
    text = base64.b64encode(text_of(notebooks()[name]).encode()).decode()
    address = f"data:application/x-ipynb+json;base64,{text}"  # it is saved from a disk too, where a file is shown
    link = {"address": address, "file": f"{name}.ipynb", "words": words, "title": titles[name], "services": services}
    return [filled("notebook_links", **link)]


@partial(on_page, priority=400)
def offer_notebooks(page: Page) -> None:
    """Write the notebooks, and what Binder installs; the theme lists that of all cells in its download menu."""
    from book.notebooks.notebook import notebooks, text_of

    if not _has_cells(page):
        return
    out = Path(page.app.outdir)
    for name, notebook in notebooks().items():
        stamps.write_whole(out / FOLDER / f"{name}.ipynb", text_of(notebook).encode())
    lock = stamps.LOCK_FILE.read_text(encoding="utf-8")
    stamps.write_whole(out / "requirements.txt", "\n".join([*PINNED.findall(lock), ""]).encode())
    stamps.write_whole(out / "_sources" / f"{page.name}.ipynb", (out / FOLDER / f"{WHOLE}.ipynb").read_bytes())
    page.context["ipynb_source"] = f"{page.name}.ipynb"


@on_page
def fold_scenes(page: Page) -> None:
    """Fold the lines that a cell shares with the first one: the scene, which is the same."""
    from book.notebooks.laboratory import PAGE
    from book.notebooks.printed import SCENE

    if page.name == PAGE.stem and _has_cells(page):
        length = SCENE.findall(PAGE.read_text(encoding="utf-8"))[0].rstrip().count("\n")
        scene = re.compile(rf'<span class="c1"># The scene of §2(?:[^\n]*\n){{{length}}}[^\n]*\n')
        body = page.context["body"]
        first = scene.search(body).end()
        folded = scene.sub(rf"<details>{SUMMARY}\g<0></details>", body[first:])
        page.context["body"] = body[:first] + folded


def _has_cells(page: Page) -> bool:
    containers = page.doctree.findall(nodes.container) if page.doctree else ()
    return any(node.get("nb_element") == "cell_code" for node in containers)
