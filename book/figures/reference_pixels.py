"""Pixels against the 50-digit reference, by what is hard about them."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import bound_style, decades, label_line_end, palette, plot
from verify.accuracy.pixels import SCENES, TOLERANCE, checked_pixels, problems

EACH = 15


@cache
def _pixels():
    pixels = checked_pixels(SCENES, each=EACH)
    if wrong := problems(pixels):
        raise ValueError(f"{len(wrong)} pixels are off by more than their bound: {wrong[0]}")
    return pixels


@figure("reference_pixels")
def reference_pixels() -> Drawing:
    """The largest channel error of pixels of each kind against 256-bit balls, and the radii of 53-bit balls."""
    pixels = _pixels()
    kinds = list(dict.fromkeys(p.kind for p in pixels))[::-1]
    fig, ax = plot(height=3.8)
    error, radius = palette()["difference"], palette()["reference"]
    for row, kind in enumerate(kinds):
        some = [p for p in pixels if p.kind == kind and not p.undecided]
        for values, colour, marker, shift in (([p.error for p in some], error, "o", 0.12),
                                              ([p.radius for p in some], radius, "|", -0.2)):  # fmt: skip
            values = np.array([v for v in values if v > 0])
            ax.plot(values, np.full(len(values), row + shift), color=colour, linewidth=0, marker=marker, markersize=4)
    ax.axvline(TOLERANCE, **bound_style())
    ax.set_yticks(range(len(kinds)), kinds)
    limits = {"xlim": (1e-20, 1e-9), "ylim": (-0.6, len(kinds) - 0.1)}
    decades(ax, 2, None, **limits, xlabel="error of a channel, and radius of its 53-bit ball")
    label_line_end(ax, TOLERANCE, len(kinds) - 0.45, "$5\\cdot10^{-14}$", palette()["bound"])
    label_line_end(ax, 7e-19, len(kinds) - 0.88, "error", error, side="left")
    label_line_end(ax, 4e-12, len(kinds) - 1.2, "radius", radius)
    numbers = {"pixels": len(pixels), "largest": max(p.error for p in pixels if not p.undecided)}
    data = {name: [getattr(p, name) for p in pixels] for name in ("kind", "error", "radius")}
    data["undecided"] = [bool(p.undecided) for p in pixels]
    return Drawing(fig, numbers=numbers, data=data)
