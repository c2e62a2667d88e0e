"""The laboratory's notebooks: written into the site, with a link beside each cell.

:::{notebook} cell1
:::

A link to Colab stands beside it where `repository.url` of `_config.yml` names a repository of GitHub's: Colab opens a
notebook from a branch, so that it has to be the one that the site is published on, `repository.branch`.
"""

import json
import re
from pathlib import Path

import nbformat
import yaml
from docutils import nodes
from jupyter_cache import get_cache
from sphinx.application import Sphinx

from book.build import stamps
from book.extension.elements import BookDirective, filled
from book.extension.streams import joined
from book.notebooks import WHOLE

FOLDER = "_downloads/notebooks"
GITHUB = re.compile(r"https://github\.com/(?P<repository>[\w.-]+/[\w.-]+?)(?:\.git)?/?")
SITE_BRANCH = "gh-pages"


def colab_address(settings: dict, name: str) -> str | None:
    """The address that opens a notebook in Colab, or None where `_config.yml` names no repository of GitHub's."""
    repository = settings.get("repository") or {}
    match = GITHUB.fullmatch(repository.get("url") or "")
    if match is None:
        return None
    branch = repository.get("branch") or SITE_BRANCH
    return f"https://colab.research.google.com/github/{match['repository']}/blob/{branch}/{FOLDER}/{name}.ipynb"


class Notebook(BookDirective):
    """The links of one notebook."""

    required_arguments = 1

    def content_nodes(self) -> list[nodes.Node]:
        from book.notebooks.laboratory import cells  # which imports this package

        name = self.arguments[0]
        titles = {cell.name: f"Cell {cell.number}" for cell in cells()} | {WHOLE: "all eight cells"}
        if name not in titles:
            raise ValueError(f"{name!r} is not allowed: one of {', '.join(titles)}")
        config = Path(self.env.srcdir) / "_config.yml"
        self.env.note_dependency(str(config))
        words = "notebook of all eight cells" if name == WHOLE else "notebook"
        colab = colab_address(yaml.safe_load(config.read_text(encoding="utf-8")), name)
        address = f"{FOLDER}/{name}.ipynb"
        return [filled("notebook_links", address=address, words=words, title=titles[name], colab=colab)]


def printed(executed: Path, cache: str | None) -> dict[str, list[dict]]:
    """What the cells of an executed page printed, by their source.

    Where the cells did not run, since the cache had them, myst-nb writes the page's notebook without their outputs.
    """
    page = nbformat.read(executed, 4)
    if cache:
        _, page = get_cache(cache).merge_match_into_notebook(page)
    ran = [cell for cell in page.cells if cell.cell_type == "code"]
    return {cell.source: [_without_metadata(output) for output in joined(cell.outputs)] for cell in ran}


def _without_metadata(output: dict) -> dict:
    return output | {"metadata": {}} if "metadata" in output else output


def offer_notebooks(
    app: Sphinx, pagename: str, templatename: str, context: dict, doctree: nodes.document | None
) -> None:
    """Write the notebooks with what the page printed; the theme lists that of all cells in the download menu."""
    from book.notebooks.notebook import notebooks, text_of

    executed = Path(app.outdir).parent / "jupyter_execute" / f"{pagename}.ipynb"
    if doctree is None or not executed.is_file() or not _has_cells(doctree):
        return
    out = Path(app.outdir)
    for name, notebook in notebooks(printed(executed, app.config.nb_execution_cache_path)).items():
        text, file = text_of(notebook), f"{name}.ipynb"
        stamps.write_whole(out / FOLDER / file, text.encode())
        script = f"saveNotebook({json.dumps(file)}, {json.dumps(text, ensure_ascii=False)});\n"
        stamps.write_whole(out / FOLDER / f"{file}.js", script.encode())  # for static/notebooks.js
    whole = (out / FOLDER / f"{WHOLE}.ipynb").read_bytes()
    stamps.write_whole(out / "_sources" / f"{pagename}.ipynb", whole)
    context["ipynb_source"] = f"{pagename}.ipynb"


def _has_cells(doctree) -> bool:
    return any(node.get("nb_element") == "cell_code" for node in doctree.findall(nodes.container))


def setup(app: Sphinx) -> None:
    """Register the directive; write the notebooks before a page's buttons are made."""
    app.add_directive("notebook", Notebook)
    app.connect("html-page-context", offer_notebooks, priority=400)
