"""The graph of what rests on what is taller than a page: it is cut between its rows."""

import copy
from itertools import pairwise

from bs4 import Tag

ROOM = 150  # CSS pixels to the right, for a line of text in a wider font
TALLEST = 240  # CSS pixels of a piece: what is left of a page is filled to within this much


def row_of(node: Tag) -> float:
    return float(node.find("circle", class_="reach")["cy"])


def cuts(rows: list[float], height: float) -> list[tuple[float, float]]:
    """Pieces (top, bottom) of at most TALLEST, cut half-way between two rows where that is possible."""
    edges, top = [], 0.0
    between = [(a + b) / 2 for a, b in pairwise(rows)]
    while height - top > TALLEST:
        fitting = [y for y in between if top < y <= top + TALLEST]
        bottom = fitting[-1] if fitting else top + TALLEST
        edges.append((top, bottom))
        top = bottom
    return [*edges, (top, height)]


def cut_graph(article: Tag) -> None:
    """Put pieces in the place of each graph of an article; a node stands in one of them, and keeps its id."""
    for svg in article.select(".graph > svg"):
        _, _, width, height = map(float, svg.get("viewBox", svg.get("viewbox")).split())
        rows = sorted(row_of(node) for node in svg.find_all("g", class_="node"))
        for top, bottom in cuts(rows, height):
            piece = copy.copy(svg)
            for node in piece.find_all("g", class_="node"):
                if not top <= row_of(node) < bottom:
                    node.decompose()
            piece.attrs.pop("viewbox", None)
            piece["viewBox"] = f"0 {top:g} {width + ROOM:g} {bottom - top:g}"
            piece["width"], piece["height"] = f"{width + ROOM:g}", f"{bottom - top:g}"
            svg.insert_before(piece)
        svg.decompose()
