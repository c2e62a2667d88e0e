"""The directive that places a figure.

:::{chapter-figure} eps_sweep
:alt: RMS of the difference against the step, falling by half an order a decade     (required)
:width: text                   "text" (default) or "page"; where it stands, never a scaling of pixels
:zoom: 1                       a whole number: CSS pixels for each pixel of a render

The caption, in MyST: first what to see, then how it was made. Roles work: {number}`eps_sweep.rms_1e-3`.
:::

Refer to it with {numref}`fig-eps_sweep`. Without a caption it has no number and no label.
`:panels: 312 312 300` are the widths of a picture's parts, which then stand one below the other on a phone.
`:wiper: other_id, what that one shows` lays another figure of the same size over it, under a wiper (static/wiper.js).
`:class:` adds CSS classes; `:plain:` leaves out the provenance line.
"""

import html
from pathlib import Path
from urllib.parse import quote

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx import addnodes
from sphinx.util.docutils import SphinxDirective
from sphinx.writers.html5 import HTML5Translator

from book.assembly.results import load_result, remark
from book.extension.elements import TEMPLATES, Nodes, directive, filled


class PixelImage(nodes.image):
    """An image that states its size in CSS pixels, so that nothing moves when it arrives."""


def visit_pixel_image(translator: HTML5Translator, node: PixelImage) -> None:
    """Write the `<img>`: Sphinx's own would lose the proportions on a narrow screen and link to itself."""
    builder = translator.builder
    source = f"{builder.imgpath}/{quote(builder.images[node['uri']])}"
    alt, classes = html.escape(node["alt"], quote=True), " ".join(node["classes"])
    size = f'width="{node["css_width"]}" height="{node["css_height"]}"'
    parts = f' data-panels="{" ".join(map(str, node["panels"]))}"' if node["panels"] else ""
    translator.body.append(f'<img src="{source}" alt="{alt}" class="{classes}" {size}{parts} loading="lazy" />\n')
    raise nodes.SkipNode


OPTIONS = {
    "alt": directives.unchanged,
    "width": lambda argument: directives.choice(argument, ("text", "page")),
    "zoom": directives.positive_int,
    "panels": directives.positive_int_list,
    "class": directives.class_option,
    "plain": directives.flag,
    "wiper": directives.unchanged,
}


@directive("chapter-figure", arguments=1, content=True, **OPTIONS)
def chapter_figure(here: SphinxDirective) -> Nodes:
    """A drawn figure with its caption, its label and where it comes from."""
    id = here.arguments[0]
    if not here.options.get("alt", "").strip():
        raise ValueError(f"{id!r}: the option alt is required: say what the picture shows")
    book = Path(here.env.srcdir)
    description = load_result(book, id)
    width = here.options.get("width", "text")
    figure = nodes.figure("", classes=[f"{width}-width", f"kind-{description['kind']}", *here.options.get("class", [])])
    here.set_source_info(figure)
    images = _images(here.options, id, description)
    if "wiper" in here.options:
        other, _, alt = here.options["wiper"].partition(", ")
        images += _images({**here.options, "alt": alt}, other, load_result(book, other))
        figure += filled("wiper", images=images)
    else:
        figure += nodes.container("", *images, classes=["pixels"])
    if here.content:
        _add_caption(here, figure, id)
    if "plain" not in here.options:
        figure += nodes.legend("", filled("provenance", **{"certified": None, "id": id} | description))
    if said := remark(book, id):
        figure += nodes.legend("", nodes.paragraph("", f"{said[0].upper()}{said[1:]}.", classes=["stale"]))
    return [figure]


def _images(options: dict, id: str, description: dict) -> list[nodes.image]:
    width, height = (size * options.get("zoom", 1) for size in description["size"])
    panels = options.get("panels", [])
    if panels and sum(panels) != width:
        raise ValueError(f"{id!r}: the panels are {sum(panels)} pixels wide, the picture {width}")
    common = {"alt": " ".join(options["alt"].split()), "css_width": width, "css_height": height, "panels": panels}
    if description["kind"] == "png":  # a render is the same on the dark page, and no filter may touch it
        return [PixelImage("", uri=f"/_generated/{id}.png", classes=["render", "dark-light"], **common)]
    kind = ["plot", "exact"] if description.get("exact") else ["plot"]
    return [
        PixelImage("", uri=f"/_generated/{id}.svg", classes=[*kind, "only-light"], **common),
        PixelImage("", uri=f"/_generated/{id}.dark.svg", classes=[*kind, "only-dark"], **common),
    ]


def _add_caption(here: SphinxDirective, figure: nodes.figure, id: str) -> None:
    parsed = nodes.Element()
    here.state.nested_parse(here.content, here.content_offset, parsed)
    first, *rest = parsed.children
    if not isinstance(first, nodes.paragraph):
        raise ValueError(f"{id!r}: a caption begins with a paragraph")
    figure += nodes.caption(first.rawsource, "", *first.children)
    if rest:
        figure += nodes.legend("", *rest)
    label = f"fig-{id}"
    figure["names"], figure["ids"] = [label], [label]
    here.state.document.note_explicit_target(figure, figure)


def file_link(text: str, target: str, title: str) -> addnodes.download_reference:
    """A link to a file of the book, which the site then has."""
    link = addnodes.download_reference("", "", reftarget=target, refdoc="", refwarn=True, reftitle=title)
    link += nodes.inline("", text)
    return link


TEMPLATES.globals.update(file_link=file_link)
