"""HTML from templates with nodes in it, theorems' texts as nodes, and how the extension's parts are registered.

filled("card", theorem=theorem)        # templates/card.html
@directive("grades")                   # the function gives a directive's nodes; so does @role for a role
@on("builder-inited")                  # the function hears an event of Sphinx's
@on_page                               # the function is given each page before it is written
"""

import re
from collections.abc import Callable, Iterable
from itertools import chain, count
from pathlib import Path
from typing import Any, NamedTuple

from docutils import nodes
from jinja2 import Environment, FileSystemLoader, StrictUndefined
from markupsafe import Markup
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective, SphinxRole

Nodes = list[nodes.Node]
SUBSCRIPT = re.compile(r"(?<=\b[A-Za-zα-ωΑ-Ω])_([A-Za-z0-9α-ω])(?!\w)")
STRESSED = re.compile(r"\*(\w+)\*")
PLACE = re.compile("(\0\\d+\0)")
NOT_THERE = (ValueError, LookupError, OSError)
_waiting: dict[str, Nodes] = {}
_numbers = count()
REGISTERED: list[tuple] = []  # the method of Sphinx's application that takes it, and what it is given


class Page(NamedTuple):
    """A page that is about to be written; no document where it is made of none, such as the search's."""

    app: Sphinx
    name: str
    context: dict[str, Any]
    doctree: nodes.document | None

    def load(self, *scripts: str, style: str | None = None) -> None:
        """Let it load scripts, which wait for the document, and a style sheet."""
        for script in scripts:
            self.app.add_js_file(script, loading_method="defer")
        if style:
            self.app.add_css_file(style)


class Filled(nodes.General, nodes.TextElement):
    """A filled template: pieces of HTML and the nodes between them, written without a tag around."""


class Formula(nodes.General, nodes.Inline, nodes.Element):
    """A formula, its attribute `tex`, that the search does not read."""


def _hold(value):
    """Return the text that Jinja prints for a value: for nodes, a place that is theirs."""
    parts = [value] if isinstance(value, nodes.Node) else value
    if not isinstance(parts, list):
        return value
    place = f"\0{next(_numbers)}\0"
    _waiting[place] = parts
    return Markup(place)


TEMPLATES = Environment(
    loader=FileSystemLoader(Path(__file__).with_name("templates")),
    autoescape=True,
    finalize=_hold,
    trim_blocks=True,
    undefined=StrictUndefined,
)


def filled(template: str, **values: Any) -> Filled:
    """Return a template's HTML; nodes, and lists of nodes, may be among the values that it prints."""
    parts = PLACE.split(TEMPLATES.get_template(f"{template}.html").render(values))
    # A piece ends with its tag: the search would take words for one that have nothing else between them.
    pieces = [_waiting.pop(part) if part in _waiting else map(raw, re.findall("[^>]+>?|>", part)) for part in parts]
    return Filled("", "", *chain.from_iterable(pieces))


def raw(text: str) -> nodes.raw:
    return nodes.raw("", str(text), format="html")


def section(title: str, id: str, *children: nodes.Node, classes: Iterable[str] = ()) -> nodes.section:
    """Return a section of a page, in its contents too."""
    return nodes.section("", nodes.title("", title), *children, ids=[id], names=[], classes=list(classes))


def typeset(text: str) -> Nodes:
    """Return a theorem's text: what is between dollars as mathematics, outside them k_u with a subscript, *u* stressed.

    Raises ValueError for a formula that does not end, or is empty.
    """
    pieces = re.split(r"(?<!\\)\$", text)
    if len(pieces) % 2 == 0 or "" in pieces[1::2]:
        raise ValueError(f"a formula does not end: {text}")
    parts = [[nodes.math(piece, piece)] if odd % 2 else _plain(piece) for odd, piece in enumerate(pieces)]
    return [*chain.from_iterable(parts)]


def _plain(text: str) -> Nodes:
    parts = []
    for odd, words in enumerate(STRESSED.split(text)):
        pieces = SUBSCRIPT.split(words)  # words, a letter's index, words, …
        each = [nodes.subscript("", piece) if at % 2 else nodes.Text(piece) for at, piece in enumerate(pieces)]
        parts += [nodes.emphasis("", "", *each)] if odd % 2 else each
    return [node for node in parts if node.astext()]


def directive(name: str, arguments: int = 0, content: bool = False, **options: Callable) -> Callable:
    """Make a function of the directive its nodes; the error of what is not there fails the build."""

    def register(nodes_of: Callable[[SphinxDirective], Nodes]) -> Callable:
        def run(self):
            try:
                return nodes_of(self)
            except NOT_THERE as error:
                raise self.error(f"{name}: {error}") from error

        members = {"required_arguments": arguments, "has_content": content, "option_spec": options, "run": run}
        REGISTERED.append(("add_directive", name, type(name, (SphinxDirective,), members)))
        return nodes_of

    return register


def role(name: str) -> Callable:
    """Make a function of the role its nodes; the error of what is not there fails the build."""

    def register(nodes_of: Callable[[SphinxRole], Nodes]) -> Callable:
        def run(self):
            try:
                return nodes_of(self), []
            except NOT_THERE as error:
                message = self.inliner.reporter.error(f"{name}: {error}", line=self.lineno)
                return [nodes.problematic(self.rawtext, self.rawtext)], [message]

        REGISTERED.append(("add_role", name, type(name, (SphinxRole,), {"run": run})()))
        return nodes_of

    return register


def on(event: str, priority: int = 500) -> Callable:
    """Make a function hear an event of Sphinx's."""

    def register(handler: Callable) -> Callable:
        REGISTERED.append(("connect", event, handler, priority))
        return handler

    return register


def on_page(handler: Callable[[Page], None], priority: int = 500) -> Callable:
    """Make a function see every page before it is written; below 500, before the theme does."""
    hear = lambda app, name, template, context, doctree: handler(Page(app, name, context, doctree))  # noqa: E731
    return on("html-page-context", priority)(hear)


# Words of prose are nodes: Sphinx sets them with the quotation marks of print.
TEMPLATES.globals.update(typeset=typeset, raw=raw, prose=nodes.Text, literal=lambda text: nodes.literal("", text))
