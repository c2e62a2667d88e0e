"""What a page carries: its sections' own ids, and a notebook where it has code cells."""

import json
from pathlib import Path

from docutils import nodes

from book import stamps

NOTE = (
    "This notebook is a page of the book, with the outputs it was built with. Run it in the book's "
    "environment, from the repository's root: it imports the repository's own packages."
)


def put_explicit_ids_first(app, document) -> None:
    """`(s1)=` before a heading gives `<section id="s1">`; Sphinx alone gives the section its title's id."""
    explicit = {document.nameids.get(name) for name, is_explicit in document.nametypes.items() if is_explicit}
    for number, section in enumerate(document.findall(nodes.section)):
        section["ids"].sort(key=lambda id: id not in explicit)
        if section["ids"] == ["proof-content"]:  # sphinx-proof gives every theorem's body this one id
            section["ids"] = [f"proof-content-{number}"]


def offer_notebook(app, pagename, templatename, context, doctree) -> None:
    """Write a page's notebook beside its source; the theme lists it in the download menu."""
    executed = Path(app.outdir).parent / "jupyter_execute" / f"{pagename}.ipynb"
    if doctree is None or not executed.is_file() or not _has_cells(doctree):
        return
    notebook = stable(json.loads(executed.read_text(encoding="utf-8")))
    text = json.dumps(notebook, indent=1, ensure_ascii=False, sort_keys=True) + "\n"
    stamps.write_whole(Path(app.outdir) / "_sources" / f"{pagename}.ipynb", text.encode())
    context["ipynb_source"] = f"{pagename}.ipynb"


def stable(notebook: dict) -> dict:
    """The notebook with cell ids and metadata that are the same in every build, and a note on top."""
    note = {"cell_type": "markdown", "metadata": {}, "source": NOTE}
    cells = [note, *notebook["cells"]]
    for number, cell in enumerate(cells):
        cell["id"] = f"cell-{number}"
        cell["metadata"] = {name: cell["metadata"][name] for name in ("tags",) if name in cell["metadata"]}
        if "outputs" in cell:
            cell["outputs"] = merged(cell["outputs"])
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    return notebook | {"cells": cells, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}


def merged(outputs: list[dict]) -> list[dict]:
    """The outputs with neighbouring pieces of one stream as one: how a kernel cuts its prints is chance."""
    whole = []
    for output in outputs:
        last = whole[-1] if whole else {}
        if output["output_type"] == "stream" and last.get("name") == output["name"]:
            whole[-1] = last | {"text": "".join(last["text"]) + "".join(output["text"])}
        else:
            whole.append(output | {"text": "".join(output["text"])} if "text" in output else output)
    return whole


def _has_cells(doctree) -> bool:
    return any(node.get("nb_element") == "cell_code" for node in doctree.findall(nodes.container))


def setup(app) -> None:
    """Connect to Sphinx: ids before contents are collected, the notebook before the buttons are made."""
    app.connect("doctree-read", put_explicit_ids_first, priority=100)
    app.connect("html-page-context", offer_notebook, priority=400)
