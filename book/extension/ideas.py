"""The directive that places a small interactive: a figure that a hand can move.

:::{idea} slope_is_texture
:alt: what the still picture shows
:width: page

The caption. Everything is as for {chapter-figure}: the still picture is the figure of that name, and it stays where no
script runs and on paper. `static/ideas/slope_is_texture.js` draws in its place where one does.
:::
"""

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from book.extension.elements import directive, on
from book.extension.figures import OPTIONS, chapter_figure

SHARED = ("simulator/compiled.js", "simulator/module.js", "ideas/compiled.js", "ideas/ideas.js")


@directive("idea", arguments=1, content=True, **OPTIONS)
def idea(here: SphinxDirective) -> list[nodes.Node]:
    """A figure with a script that replaces its picture."""
    (figure,) = chapter_figure(here)
    figure["classes"].append("idea")
    figure["idea"] = here.arguments[0]
    return [figure]


@on("html-page-context")
def load_scripts(app: Sphinx, pagename: str, templatename: str, context: dict, doctree: nodes.document | None) -> None:
    """Let a page with interactives load what they need, each file once."""
    found = [node["idea"] for node in doctree.findall(nodes.figure) if "idea" in node] if doctree else []
    for name in [*SHARED, *(f"ideas/{id}.js" for id in found)] if found else ():
        app.add_js_file(name, loading_method="defer")
    if found:
        app.add_css_file("ideas/ideas.css")
