"""The directive that places a small interactive: a figure that a hand can move.

:::{idea} slope_is_texture
:alt: what the still picture shows
:width: page

The caption. Everything is as for {chapter-figure}: the still picture is the figure of that name, and it stays where no
script runs and on paper. `static/ideas/slope_is_texture.js` draws in its place where one does.
:::
"""

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from book.extension.elements import Page, directive, on_page
from book.extension.figures import OPTIONS, chapter_figure

SHARED = ("simulator/compiled.js", "simulator/module.js", "ideas/compiled.js", "ideas/ideas.js")


@directive("idea", arguments=1, content=True, **OPTIONS)
def idea(here: SphinxDirective) -> list[nodes.Node]:
    """A figure with a script that replaces its picture."""
    (figure,) = chapter_figure(here)
    figure["classes"].append("idea")
    figure["idea"] = here.arguments[0]
    return [figure]


@on_page
def load_scripts(page: Page) -> None:
    """Let a page with interactives load what they need, each file once."""
    figures = page.doctree.findall(nodes.figure) if page.doctree else ()
    if scripts := [f"ideas/{figure['idea']}.js" for figure in figures if "idea" in figure]:
        page.load(*SHARED, *scripts, style="ideas/ideas.css")
