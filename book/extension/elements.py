"""HTML from templates with nodes in it, theorems' texts as nodes, and what the book's directives and roles share.

filled("card", theorem=theorem)        # templates/card.html
"""

import re
from collections.abc import Iterable
from itertools import chain, count
from pathlib import Path
from typing import Any

from docutils import nodes
from jinja2 import Environment, FileSystemLoader, StrictUndefined
from markupsafe import Markup
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective, SphinxRole

SUBSCRIPT = re.compile(r"(?<![\w])([A-Za-zα-ωΑ-Ω])_([A-Za-z0-9α-ω])(?![\w])")
PLACE = re.compile("(\0\\d+\0)")
_waiting: dict[str, list[nodes.Node]] = {}
_numbers = count()


class Filled(nodes.General, nodes.TextElement):
    """A filled template: pieces of HTML and the nodes between them, written without a tag around."""


def _hold(value):
    """What Jinja prints for a value: for nodes, a place that is theirs."""
    if isinstance(value, nodes.Node):
        value = [value]
    if not isinstance(value, list) or not value:
        return "" if value == [] else value
    place = f"\0{next(_numbers)}\0"
    _waiting[place] = value
    return Markup(place)


TEMPLATES = Environment(
    loader=FileSystemLoader(Path(__file__).with_name("templates")),
    autoescape=True,
    finalize=_hold,
    trim_blocks=True,
    undefined=StrictUndefined,
)


def filled(template: str, **values: Any) -> Filled:
    """A template's HTML; nodes, and lists of nodes, may be among the values that it prints."""
    parts = PLACE.split(TEMPLATES.get_template(f"{template}.html").render(values))
    # A piece ends with its tag: the search would take words for one that have nothing else between them.
    pieces = [_waiting.pop(part, None) or map(raw, re.findall(r"[^>]+>?|>", part)) for part in parts if part]
    return Filled("", "", *chain.from_iterable(pieces))


def raw(text: str) -> nodes.raw:
    """HTML as it stands."""
    return nodes.raw("", str(text), format="html")


def section(title: str, id: str, *children: nodes.Node, classes: Iterable[str] = ()) -> nodes.section:
    """A section of a page, in its contents too."""
    return nodes.section("", nodes.title("", title), *children, ids=[id], names=[], classes=list(classes))


def typeset(text: str) -> list[nodes.Node]:
    """A theorem's text: what is between dollars as mathematics, k_u outside them with a subscript."""
    parts = []
    for number, part in enumerate(re.split(r"(?<!\\)\$", text)):
        if number % 2:
            parts.append(nodes.math(part, part))
        else:
            parts += _plain(part)
    return parts


def _plain(text: str) -> list[nodes.Node]:
    found, end = [], 0
    for match in SUBSCRIPT.finditer(text):
        found += [nodes.Text(text[end : match.start()] + match[1]), nodes.subscript("", match[2])]
        end = match.end()
    return [*found, nodes.Text(text[end:])] if text[end:] else found


def prose(text: str) -> nodes.Text:
    """Words as Sphinx sets them, with the quotation marks of print."""
    return nodes.Text(text)


def literal(text: str) -> nodes.literal:
    """Code in a line."""
    return nodes.literal("", text)


class BookDirective(SphinxDirective):
    """A directive that prints `content_nodes()`; the ValueError of what is not there fails the build."""

    def run(self) -> list[nodes.Node]:
        try:
            return self.content_nodes()
        except ValueError as error:
            raise self.error(f"{self.name}: {error}") from error


class BookRole(SphinxRole):
    """A role that prints `content_nodes()`; the ValueError of what is not there fails the build."""

    def run(self) -> tuple[list[nodes.Node], list[nodes.system_message]]:
        try:
            return self.content_nodes(), []
        except ValueError as error:
            message = self.inliner.reporter.error(f"{self.name}: {error}", line=self.lineno)
            return [nodes.problematic(self.rawtext, self.rawtext)], [message]


def _nothing(translator, node) -> None:
    """A filled template has no tag of its own."""


def setup(app: Sphinx) -> None:
    """Register the node."""
    app.add_node(Filled, html=(_nothing, _nothing))


TEMPLATES.globals.update(typeset=typeset, raw=raw, prose=prose, literal=literal)
