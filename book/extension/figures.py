"""The directive that places a figure.

:::{chapter-figure} eps_sweep
:alt: RMS of the difference against the step, falling by half an order a decade     (required)
:width: text                   "text" (default) or "page"; where it stands, never a scaling of pixels
:zoom: 1                       a whole number: CSS pixels for each pixel of a render

The caption, in MyST: first what to see, then how it was made. Roles work: {number}`eps_sweep.rms_1e-3`.
:::

Refer to it with {numref}`fig-eps_sweep`. Without a caption it has no number and no label.
`:panels: 312 312 300` are the widths of a picture's parts, which then stand one below the other on a phone.
`:class:` adds CSS classes; `:plain:` leaves out the provenance line.
"""

import html
from pathlib import Path
from typing import ClassVar
from urllib.parse import quote

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.writers.html5 import HTML5Translator

from book.extension.elements import BookDirective
from book.extension.results import load_result, result_file


def _width(argument: str) -> str:
    return directives.choice(argument, ("text", "page"))


class PixelImage(nodes.image):
    """An image that states its size in CSS pixels, so that nothing moves when it arrives."""


def visit_pixel_image(translator: HTML5Translator, node: PixelImage) -> None:
    """Write the `<img>`: Sphinx's own would lose the proportions on a narrow screen and link to itself."""
    builder = translator.builder
    source = f"{builder.imgpath}/{quote(builder.images[node['uri']])}"
    alt, classes = html.escape(node["alt"], quote=True), " ".join(node["classes"])
    size = f'width="{node["css_width"]}" height="{node["css_height"]}"'
    parts = f' data-panels="{" ".join(map(str, node["panels"]))}"' if node["panels"] else ""
    translator.body.append(f'<img src="{source}" alt="{alt}" class="{classes}" {size}{parts} />\n')
    raise nodes.SkipNode


class ChapterFigure(BookDirective):
    """Place a drawn figure with its caption, its label and where it comes from."""

    required_arguments = 1
    has_content = True
    option_spec: ClassVar = {
        "alt": directives.unchanged,
        "width": _width,
        "zoom": directives.positive_int,
        "panels": directives.positive_int_list,
        "class": directives.class_option,
        "plain": directives.flag,
    }

    def content_nodes(self) -> list[nodes.Node]:
        id, book = self.arguments[0], Path(self.env.srcdir)
        if not self.options.get("alt", "").strip():
            raise ValueError(f"{id!r}: the option alt is required: say what the picture shows")
        self.env.note_dependency(str(result_file(book, id)))
        description = load_result(book, id)
        if description["kind"] == "numbers":
            raise ValueError(f"{id!r} has numbers but no picture")
        return [self._figure(id, description)]

    def _figure(self, id: str, description: dict) -> nodes.figure:
        width = self.options.get("width", "text")
        classes = [f"{width}-width", f"kind-{description['kind']}", *self.options.get("class", [])]
        figure = nodes.figure("", classes=classes)
        self.set_source_info(figure)
        figure += nodes.container("", *self._images(id, description), classes=["pixels"])
        if self.content:
            self._add_caption(figure, id)
        if "plain" not in self.options:
            figure += nodes.legend("", provenance(id, description))
        return figure

    def _images(self, id: str, description: dict) -> list[nodes.image]:
        width, height = (size * self.options.get("zoom", 1) for size in description["size"])
        common = {"alt": " ".join(self.options["alt"].split()), "css_width": width, "css_height": height}
        common["panels"] = panels = self.options.get("panels", [])
        if panels and sum(panels) != width:
            raise ValueError(f"{id!r}: the panels are {sum(panels)} pixels wide, the picture {width}")
        if description["kind"] == "png":  # a render is the same on the dark page, and no filter may touch it
            return [PixelImage("", uri=f"/_generated/{id}.png", classes=["render", "dark-light"], **common)]
        kind = ["plot", "exact"] if description.get("exact") else ["plot"]
        return [
            PixelImage("", uri=f"/_generated/{id}.svg", classes=[*kind, "only-light"], **common),
            PixelImage("", uri=f"/_generated/{id}.dark.svg", classes=[*kind, "only-dark"], **common),
        ]

    def _add_caption(self, figure: nodes.figure, id: str) -> None:
        parsed = nodes.Element()
        self.state.nested_parse(self.content, self.content_offset, parsed)
        first, *rest = parsed.children
        if not isinstance(first, nodes.paragraph):
            raise ValueError(f"{id!r}: a caption begins with a paragraph")
        figure += nodes.caption(first.rawsource, "", *first.children)
        if rest:
            figure += nodes.legend("", *rest)
        label = f"fig-{id}"
        figure["names"], figure["ids"] = [label], [label]
        self.state.document.note_explicit_target(figure, figure)


def provenance(id: str, description: dict) -> nodes.paragraph:
    """The small line under a caption: source · data · numbers · its command · the hash it was drawn from."""
    source = "/" + description["source"].removeprefix("book/")
    links = [("source", source, f"{description['source']}, {description['function']}()")]
    links += [("data", f"/_generated/{description['data']}", f"{description['data']}, what the picture shows")]
    links += [("numbers", f"/_generated/{id}.json", f"{id}.json, what the text cites")]
    line = nodes.paragraph("", classes=["provenance"])
    for link in links:
        line += [_download(*link), nodes.Text(" · ")]
    line += [nodes.literal("", f"python -m book figures {id}")]
    line += [nodes.Text(" · drawn from "), nodes.literal("", description["key"])]
    return line


def _download(text: str, target: str, title: str) -> addnodes.download_reference:
    link = addnodes.download_reference("", "", reftarget=target, refdoc="", refwarn=True, reftitle=title)
    link += nodes.inline("", text)
    return link


def setup(app: Sphinx) -> None:
    """Register the directive and its image."""
    app.add_node(PixelImage, html=(visit_pixel_image, None))
    app.add_directive("chapter-figure", ChapterFigure)
