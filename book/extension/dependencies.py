"""The graph of what rests on what: a drawing whose nodes are links, and the same as text.

:::{dependency-graph}
:::

One row a theorem, each below everything that it rests on; an arc joins two that rest on each other directly. The
drawing is text, laid out here; its colours are the style sheet's, and so is the highlight of `#node-ID`.
"""

import html
import textwrap
from collections.abc import Iterable, Mapping

from docutils import nodes

from book.extension.cards import ProofsDirective, link, links
from book.extension.elements import Html, raw
from book.extension.evidence import badge
from book.extension.theorems import kind

WIDTH, MARKS, ROW, LINE, TOP, ARC = 450, 112, 30, 17, 20, 100
TEXT_COLUMNS = 38


def components(uses: Mapping[str, Iterable[str]]) -> list[list[str]]:
    """Groups that are joined by uses, the largest first, each in the given order."""
    order, group = list(uses), {id: {id} for id in uses}
    for id, used in uses.items():
        for other in used:
            if group[other] is not group[id]:
                joined = group[other] | group[id]
                for member in joined:
                    group[member] = joined
    seen, found = set(), []
    for id in order:
        if id not in seen:
            seen |= group[id]
            found.append([other for other in order if other in group[id]])
    return sorted(found, key=lambda members: -len(members))


def rows(uses: Mapping[str, Iterable[str]]) -> list[str]:
    """The order of the rows: everything below what it rests on, and as near to it as may be.

    uses: in an order in which each comes after those that it uses.
    """
    ordered = []
    for members in components(uses):
        waiting = list(members)
        while waiting:
            ready = [id for id in waiting if not set(uses[id]) & set(waiting)]
            # The one whose latest support was placed last: chains stay together.
            best = max(ready, key=lambda id: max((ordered.index(u) for u in uses[id]), default=-1))
            ordered.append(best)
            waiting.remove(best)
    return ordered


def wrapped(text: str) -> list[str]:
    """The lines of a node's text."""
    return textwrap.wrap(text, TEXT_COLUMNS, break_on_hyphens=False)


def mark(grade: str, y: float) -> str:
    """The grade's shape at the height y."""
    x = MARKS
    return {
        "proved": f'<circle class="mark" cx="{x}" cy="{y}" r="5.5"/>',
        "certified": f'<path class="mark" d="M{x} {y - 7}l7 7l-7 7l-7 -7z"/>',
        "measured": f'<path class="mark" d="M{x} {y - 7}l7 12h-14z"/>',
        "refuted": f'<path class="mark cross" d="M{x - 5} {y - 5}l10 10m0 -10l-10 10"/>',
        "cited": f'<circle class="mark open" cx="{x}" cy="{y}" r="5.5"/>',
    }.get(grade, f'<path class="mark" d="M{x - 5} {y - 5}h10v10h-10z"/>')


def drawing(proofs, address) -> str:
    """The graph as SVG; address(id) is that of a theorem's card."""
    uses = {id: theorem.uses for id, theorem in proofs.theorems.items()}
    order, at, y = rows(uses), {}, TOP
    lines = {id: wrapped(f"{proofs.label(id)} {proofs.theorems[id].title}") for id in order}
    for id in order:
        at[id], y = y, y + ROW + LINE * (len(lines[id]) - 1)
    near = {id: {id, *uses[id], *proofs.users(id)} for id in order}
    parts = [_arc(id, other, at, order) for id in order for other in uses[id]]
    for id in order:
        grade = kind(proofs.entries[id]["grade"])
        classes = " ".join(["node", grade, *(f"near-{other}" for other in sorted(near[id]))])
        title = html.escape(f"{proofs.label(id)} ({proofs.theorems[id].title}), {proofs.entries[id]['grade']}")
        text = "".join(
            f'<tspan x="{MARKS + 18}" y="{at[id] + 5 + LINE * n}">{html.escape(part)}</tspan>'
            for n, part in enumerate(lines[id])
        ).replace(proofs.label(id), f'<tspan class="label">{proofs.label(id)}</tspan>', 1)
        parts.append(
            f'<g id="node-{id}" class="{classes}"><a href="#node-{id}" aria-label="Neighbours of {title}">'
            f'<circle class="reach" cx="{MARKS}" cy="{at[id]}" r="13"/>{mark(grade, at[id])}</a>'
            f'<a href="{html.escape(address(id))}"><title>{title}</title><text>{text}</text></a></g>'
        )
    shown = ",".join(f".graph:has(#node-{id}:target) .near-{id}" for id in order)
    size = f'viewBox="0 0 {WIDTH} {y}" width="{WIDTH}" height="{y}"'
    label = f"{len(order)} theorems, one a row; arcs join those that rest on each other. The list below says the same."
    svg = f'<svg {size} role="group" aria-label="{label}">{"".join(parts)}</svg>'
    return f'<div class="graph"><style>{shown}{{opacity:1}}</style>{svg}</div>'


def _arc(id, other, at, order) -> str:
    """The arc from a theorem up to one that it uses: the further apart, the wider."""
    wide = min(ARC, 16 + 5 * (order.index(id) - order.index(other)))
    x, low, high = MARKS - 9, at[id], at[other]
    return f'<path class="edge near-{id} near-{other}" d="M{x} {low}C{x - wide} {low} {x - wide} {high} {x} {high}"/>'


class DependencyGraph(ProofsDirective):
    """Draw the graph, and write it out."""

    def content_nodes(self, proofs):
        items = []
        for id in proofs.in_page_order():
            used, users = proofs.theorems[id].uses, proofs.users(id)
            parts = [badge(proofs.entries[id]["grade"])]
            parts.append(link(f"{proofs.label(id)} ({proofs.theorems[id].title})", self.address(id, proofs)))
            if not used and not users:
                parts.append(nodes.Text(" stands alone"))
            if used:
                parts += [nodes.Text(" rests on "), *links(self.env, proofs, used)]
            if users:
                parts += [
                    nodes.Text(", and" if used else ""),
                    nodes.Text(" is used by "),
                    *links(self.env, proofs, users),
                ]
            items.append(Html("li", *parts, nodes.Text(". "), link("Show", f"#node-{id}"), id=f"list-{id}"))
        place = nodes.section("", nodes.title("", "The same in words"), ids=["in-words"], names=[])
        place += Html("ul", *items, classes=["claim-list", "neighbours"])
        return [raw(drawing(proofs, lambda id: self.address(id, proofs))), place]


def setup(app) -> None:
    """Register the directive."""
    app.add_directive("dependency-graph", DependencyGraph)
