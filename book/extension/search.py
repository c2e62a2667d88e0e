"""The sentences that a search has found: every paragraph of the book in a script, which needs no server to be read."""

import json
import re
from collections.abc import Iterator
from pathlib import Path

from docutils import nodes
from sphinx.application import Sphinx

from book.extension.elements import Filled, Page, on, on_page
from book.extension.mathematics import mathml

BREAK, BLOCK = "\0", re.compile(r"\s*</?(?:div|li|p|section|summary)\b")
RAISED = str.maketrans("0123456789−", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
FORMULA = re.compile(r"\\\((.*?)\\\)")
SCRIPTS = ("search-text.js", "search.js")
COMPACT = {"ensure_ascii": False, "separators": (",", ":")}


def paragraphs(document: nodes.document) -> Iterator[tuple[str, str]]:
    """A page's texts in order: the id of the section, and some words with their mathematics between \\( and \\)."""
    for node in document.findall(lambda node: isinstance(node, nodes.paragraph | Filled | nodes.caption)):
        for text in "".join(_words(node)).split(BREAK):
            if " " in (text := " ".join(text.split())):
                yield _section(node), text


def _words(node: nodes.Node) -> Iterator[str]:
    if isinstance(node, nodes.math):
        yield f"\\({node.astext().strip()}\\)"
    elif isinstance(node, nodes.raw):
        yield BREAK if BLOCK.match(node.astext()) else " "
    elif isinstance(node, nodes.superscript):
        yield node.astext().translate(RAISED)
    elif isinstance(node, nodes.Text):
        yield node.astext()
    else:
        for child in node.children:
            yield from _words(child)


def _section(node: nodes.Node) -> str:
    while node and not (isinstance(node, nodes.section) and node["ids"]):
        node = node.parent
    return node["ids"][0] if node else ""


@on("doctree-read")
def keep_texts(app: Sphinx, document: nodes.document) -> None:
    app.env.metadata[app.env.docname]["texts"] = list(paragraphs(document))


@on("build-finished")
def write_texts(app: Sphinx, error: Exception | None) -> None:
    if error is None and app.builder.format == "html":
        pages = {name: app.env.metadata[name]["texts"] for name in sorted(app.env.found_docs)}
        found = sorted({tex for page in pages.values() for _, text in page for tex in FORMULA.findall(text)})
        kept = mathml(app.env, [(tex, False) for tex in found])
        data = {"SearchText": pages, "SearchFormulas": {tex: kept[tex, False] for tex in found}}
        scripts = [f"var {name} = {json.dumps(what, **COMPACT)};\n" for name, what in data.items()]
        (Path(app.outdir) / "_static" / SCRIPTS[0]).write_text("".join(scripts), encoding="utf-8")


@on_page
def add_scripts(page: Page) -> None:
    """Load the texts, and what shows them, on the page of the search alone."""
    if page.name == "search":
        page.load(*SCRIPTS)
