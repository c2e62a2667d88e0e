"""The graph of what rests on what: a drawing whose nodes are links. Each card says the same in words.

:::{dependency-graph}
:::

One row a theorem, each below everything that it rests on; an arc joins two that rest on each other directly. The
drawing is text, laid out here; its colours are the style sheet's, and so is the highlight of `#node-ID`.
"""

import textwrap
from collections.abc import Iterable, Mapping

from sphinx.util.docutils import SphinxDirective
from sympy.utilities.iterables import connected_components

from book.extension.elements import Filled, Nodes, directive, filled
from book.extension.theorems import Here

WIDTH, MARKS, ROW, LINE, TOP = 500, 112, 30, 17, 20
TEXT_COLUMNS = 38


def rows(uses: Mapping[str, Iterable[str]]) -> list[str]:
    """The order of the rows: everything below what it rests on, and as near to it as may be.

    uses: in an order in which each comes after those that it uses.
    """
    ordered, order = [], list(uses)
    joined = connected_components((order, [(id, other) for id in uses for other in uses[id]]))
    for members in sorted(joined, key=len, reverse=True):
        waiting = sorted(members, key=order.index)
        while waiting:
            ready = [id for id in waiting if not set(uses[id]) & set(waiting)]
            # The one whose latest support was placed last: chains stay together.
            best = max(ready, key=lambda id: max((ordered.index(u) for u in uses[id]), default=-1))
            ordered.append(best)
            waiting.remove(best)
    return ordered


def drawing(book: Here) -> Filled:
    """The graph as SVG; `book` names the theorems and has the addresses of their cards."""
    proofs = book.proofs
    uses = {id: theorem.uses for id, theorem in proofs.theorems.items()}
    table, y = {}, TOP
    for number, id in enumerate(rows(uses)):
        lines = textwrap.wrap(f"{proofs.label(id)} {proofs.theorems[id].title}", TEXT_COLUMNS, break_on_hyphens=False)
        near = sorted({id, *uses[id], *proofs.users(id)})
        grade = proofs.entries[id]["shown"]
        table[id] = {"number": number, "y": y, "lines": lines, "near": near, "grade": grade, "uses": uses[id]}
        y += ROW + LINE * (len(lines) - 1)
    return filled("graph", book=book, rows=table, width=WIDTH, height=y, x=MARKS, line_height=LINE)


@directive("dependency-graph")
def dependency_graph(here: SphinxDirective) -> Nodes:
    return [drawing(Here(here.env))]
