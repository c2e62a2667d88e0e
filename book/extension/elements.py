"""HTML elements as nodes, and the text of theorems as nodes: mathematics between dollars, the rest as it stands."""

import html
import re

from docutils import nodes

SUBSCRIPT = re.compile(r"(?<![\w])([A-Za-zα-ωΑ-Ω])_([A-Za-z0-9α-ω])(?![\w])")
BLOCKS = {"section", "details", "p", "ul", "ol", "li"}


class Html(nodes.General, nodes.TextElement):
    """One HTML element around its children: Html("details", open=None) is `<details open>`."""

    def __init__(self, tag="div", *children, classes=(), **attributes):
        names = {name: name.rstrip("_").replace("_", "-") for name in attributes}
        super().__init__("", "", *children, tag=tag, html={names[name]: value for name, value in attributes.items()})
        self["classes"] = list(classes)


def visit_html(translator, node: Html) -> None:
    """Write the start tag."""
    attributes = dict(node["html"])
    if node["classes"]:
        attributes["class"] = " ".join(node["classes"])
    written = "".join(
        f" {name}" if value is None else f' {name}="{html.escape(str(value), quote=True)}"'
        for name, value in attributes.items()
    )
    translator.body.append(f"<{node['tag']}{written}>")


def depart_html(translator, node: Html) -> None:
    """Write the end tag."""
    if node["tag"] != "input":
        translator.body.append(f"</{node['tag']}>" + "\n" * (node["tag"] in BLOCKS))


def raw(text: str) -> nodes.raw:
    """HTML as it stands."""
    return nodes.raw("", text, format="html")


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


def setup(app) -> None:
    """Register the element."""
    app.add_node(Html, html=(visit_html, depart_html))
