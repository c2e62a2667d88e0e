"""The sentences that a search has found: every paragraph of the book in a script, which needs no server to be read."""

import json
import pickle
import re
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

from docutils import nodes
from sphinx.addnodes import pending_xref
from sphinx.application import ENV_PICKLE_FILENAME, Sphinx

from book.extension.elements import Filled, Page, on, on_page
from book.extension.mathematics import typeset
from book.extension.theorems import proofs_of

BREAK, NOT_READ = "\0", "\1"  # where a text ends; what begins one that no sentence is found in
BLOCK = re.compile(r"\s*</?(?:div|li|p|section|summary)\b")
RAISED = str.maketrans("0123456789−", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
SCRIPTS = ("search-text.js", "search.js")
COMPACT = {"ensure_ascii": False, "separators": (",", ":")}


def paragraphs(document: nodes.document) -> Iterator[tuple[str, str]]:
    """Return a page's texts in order: the id of the section or the card, and some words."""
    for node in document.findall(lambda node: isinstance(node, nodes.paragraph | Filled | nodes.caption)):
        for text in "".join(_words(node)).split(BREAK):
            if " " in (text := " ".join(text.split())) and NOT_READ not in text:
                yield _section(node), text


def _words(node: nodes.Node) -> Iterator[str]:
    if isinstance(node, nodes.math):
        yield in_a_line(ElementTree.fromstring(typeset(node.astext().strip())))
    elif isinstance(node, nodes.raw):
        yield BREAK if BLOCK.match(node.astext()) else " "
        yield NOT_READ * ('class="provenance"' in node.astext())
    elif isinstance(node, pending_xref) and node["refdomain"] == "cite":
        yield re.sub(r"(?<=\D)(?=\d{4})", " ", node.astext())  # a key: Blinn1978
    elif isinstance(node, nodes.superscript):
        yield node.astext().translate(RAISED)
    elif isinstance(node, nodes.Text):
        yield node.astext()
    else:
        for child in node.children:
            yield from _words(child)


def in_a_line(part: ElementTree.Element) -> str:
    """Return a formula's MathML as plain text: x², sin x, N_x′, 1/(1−x)."""
    pieces = [*map(in_a_line, part)]
    apart = [f"({text})" if len(child) else text for text, child in zip(pieces, part, strict=True)]
    if part.tag == "mfrac":
        return "/".join(apart)
    if part.tag in ("msup", "msubsup"):
        high = pieces[-1]
        pieces[-1] = high.translate(RAISED) if re.fullmatch("[0-9−]+|[′″‴]", high) else f"^{apart[-1]}"
    if part.tag in ("msub", "msubsup"):
        pieces[1] = f"_{apart[1]}"
    if part.tag == "msqrt":
        pieces = ["√(", *pieces, ")"]
    text = " " if part.tag == "mspace" else (part.text or "").replace("\N{FUNCTION APPLICATION}", " ")
    return text + "".join(pieces)


def _section(node: nodes.Node) -> str:
    while node and not (isinstance(node, nodes.section | Filled) and node["ids"]):
        node = node.parent
    return node["ids"][0] if node else ""


@on("doctree-read")
def keep_texts(app: Sphinx, document: nodes.document) -> None:
    app.env.metadata[app.env.docname]["texts"] = list(paragraphs(document))


@on("build-finished")
def write_texts(app: Sphinx, error: Exception | None) -> None:
    if error is None and app.builder.format == "html":
        pages = {name: app.env.metadata[name]["texts"] for name in sorted(app.env.found_docs)}
        texts = [text for page in pages.values() for text in reversed(page)]
        titles = {f"theorem-{id}": theorem.title for id, theorem in proofs_of(app).theorems.items()}
        first = {f"#{id}": text.replace(titles[id], f"{titles[id]}.", 1) for id, text in texts if id in titles}
        for script, name, known in ((SCRIPTS[0], "SearchText", pages), ("statements.js", "Statements", first)):
            text = f"var {name} = {json.dumps(known, **COMPACT)};\n"
            (Path(app.outdir) / "_static" / script).write_text(text, encoding="utf-8")
        # With what pages gave the search's index, for a build of some of them: Sphinx keeps it before that.
        Path(app.doctreedir, ENV_PICKLE_FILENAME).write_bytes(pickle.dumps(app.env))


@on_page
def add_scripts(page: Page) -> None:
    """Load the texts, and what shows them, on the page of the search alone."""
    if page.name == "search":
        page.load(*SCRIPTS)
