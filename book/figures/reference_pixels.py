"""Pixels against the 50-digit reference, by what is hard about them."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import decades, dots, label_line_end, plot
from verify.accuracy.pixels import SCENES, checked_pixels, problems

EACH = 15


@cache
def _pixels():
    pixels = checked_pixels(SCENES, each=EACH)
    if wrong := problems(pixels):
        raise ValueError(f"{len(wrong)} pixels are off by more than their bound: {wrong[0]}")
    return pixels


@figure
def reference_pixels() -> Drawing:
    """The largest channel error of pixels of each kind against 256-bit balls, and the bounds of their frames."""
    pixels = _pixels()
    kinds = list(dict.fromkeys(p.kind for p in pixels))[::-1]
    fig, ax = plot(height=3.8)
    decided = [p for p in pixels if not p.undecided]
    for row, kind in enumerate(kinds):
        for what, role, marker, shift in (("error", "difference", "o", 0.12), ("bound", "reference", "|", -0.2)):
            values = [getattr(p, what) for p in decided if p.kind == kind and getattr(p, what) > 0]
            dots(ax, values, np.full(len(values), row + shift), role, 4, marker)
    ax.set_yticks(range(len(kinds)), kinds)
    limits = {"xlim": (1e-20, 1e-8), "ylim": (-0.6, len(kinds) - 0.1)}
    decades(ax, 2, None, **limits, xlabel="error of a channel, and its bound")
    label_line_end(ax, 7e-19, len(kinds) - 0.88, "error", "difference", "left")
    label_line_end(ax, 1e-10, len(kinds) - 1.2, "bound", "reference")
    numbers = {"pixels": len(pixels), "decided": len(decided), "largest": max(p.error for p in decided)}
    numbers["largest_share"] = max(p.error / p.bound for p in decided if p.bound > 0)
    data = {name: [getattr(p, name) for p in pixels] for name in ("kind", "error", "bound")}
    data["undecided"] = [bool(p.undecided) for p in pixels]
    return Drawing(fig, numbers, data)
