"""The directive that places a figure.

:::{chapter-figure} eps_sweep
:alt: RMS of the difference against the step, falling by half an order a decade     (required)
:width: text                   "text" (default) or "page"; where it stands, never a scaling of pixels
:zoom: 1                       a whole number: CSS pixels for each pixel of a render

The caption, in MyST: what to see, in two lines. Roles work: {number}`eps_sweep.rms_1e-3`.

How it was made: what follows the first paragraph is folded, with the provenance.
:::

Refer to it with {numref}`fig-eps_sweep`. Without a caption it has no number and no label.
`:panels: 312 312 300` are the widths of a picture's parts, which then stand one below the other on a phone.
`:wiper: other_id, what that one shows` lays another figure of the same size over it, under a wiper (static/wiper.js).
`:class:` adds CSS classes; `:plain:` leaves out the provenance line.
"""

import shutil
from pathlib import Path
from posixpath import relpath

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx import addnodes
from sphinx.util.docutils import SphinxDirective

from book.assembly.results import load_result, remark
from book.extension.elements import TEMPLATES, Nodes, directive, filled, raw

FOLD = '<details class="made"><summary>details</summary>'  # one sign under each figure
OPTIONS = {
    "alt": directives.unchanged_required,
    "width": lambda argument: directives.choice(argument, ("text", "page")),
    "zoom": directives.positive_int,
    "panels": directives.positive_int_list,
    "class": directives.class_option,
    "plain": directives.flag,
    "wiper": directives.unchanged,
}


@directive("chapter-figure", arguments=1, content=True, **OPTIONS)
def chapter_figure(here: SphinxDirective) -> Nodes:
    """Return a drawn figure with its caption, its label and where it comes from."""
    id, options, book = here.arguments[0], here.options, Path(here.env.srcdir)
    if not options.get("alt"):
        raise ValueError(f"{id!r}: the option alt is required: say what the picture shows")
    description, width = load_result(book, id), options.get("width", "text")
    figure = nodes.figure("", classes=[f"{width}-width", *options.get("class", [])])
    here.set_source_info(figure)
    panels, pictures = options.get("panels", []), _pictures(here, id, options["alt"])
    if panels and sum(panels) != pictures[0]["width"]:
        raise ValueError(f"{id!r}: the panels are {sum(panels)} pixels wide, the picture {pictures[0]['width']}")
    if "wiper" in options:
        other, _, alt = options["wiper"].partition(", ")
        pictures += _pictures(here, other, alt)
    moves = "wiper" in options or here.name != "chapter-figure"
    figure += filled("pictures", pictures=pictures, panels=panels, wiper="wiper" in options, moves=moves)
    rest = _add_caption(here, figure, id) if here.content else []
    if "plain" not in options:
        address = relpath(description["source"], book.name)  # both from the root
        origin = filled("provenance", **{"certified": None, "id": id, "address": address} | description)
        figure += nodes.legend("", raw(FOLD), *rest, origin, raw("</details>"))
    elif rest:
        figure += nodes.legend("", *rest)
    if age := remark(book, id):
        figure += nodes.legend("", nodes.paragraph("", f"{age[0].upper()}{age[1:]}.", classes=["stale"]))
    return [figure]


def _pictures(here: SphinxDirective, id: str, alt: str) -> list[dict]:
    """Return the words about a figure's pictures, for the light page and the dark one, which the site then has."""
    source, description = Path(here.env.srcdir, "_generated"), load_result(Path(here.env.srcdir), id)
    width, height = (size * here.options.get("zoom", 1) for size in description["size"])
    plot = "plot exact" if description.get("exact") else "plot"
    looks = {".svg": f"{plot} only-light", ".dark.svg": f"{plot} only-dark"}
    if description["kind"] == "png":  # a render is the same on the dark page, and no filter may touch it
        looks = {".png": "render dark-light"}
    common, folder = (
        {"alt": " ".join(alt.split()), "width": width, "height": height},
        Path(here.env.app.outdir, "_images"),
    )
    folder.mkdir(parents=True, exist_ok=True)
    for suffix in looks:
        shutil.copy(source / f"{id}{suffix}", folder)
    return [{"name": f"{id}{suffix}", "classes": look} | common for suffix, look in looks.items()]


def _add_caption(here: SphinxDirective, figure: nodes.figure, id: str) -> Nodes:
    """Give the figure its caption, the first paragraph, and its label; return the others."""
    parsed = nodes.Element()
    here.state.nested_parse(here.content, here.content_offset, parsed)
    first, *rest = parsed.children
    if not isinstance(first, nodes.paragraph):
        raise ValueError(f"{id!r}: a caption begins with a paragraph")
    figure += nodes.caption(first.rawsource, "", *first.children)
    label = f"fig-{id}"
    figure["names"], figure["ids"] = [label], [label]
    here.state.document.note_explicit_target(figure, figure)
    return rest


def file_link(text: str, target: str, title: str) -> addnodes.download_reference:
    """Return a link to a file of the book, which the site then has."""
    link = addnodes.download_reference("", "", reftarget=target, refdoc="", refwarn=True, reftitle=title)
    link += nodes.inline("", text)
    return link


TEMPLATES.globals.update(file_link=file_link)
