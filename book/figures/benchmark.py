"""Figures of committed records: times against pixels and errors by `make bench`, and the counts of long runs."""

import re
from collections.abc import Mapping

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import DASHED, DOTTED, SOLID, curve, decades, plot, slope_triangle

# renderer: (label, role of its colour, dashes, threads of its thick line)
RENDERERS = {
    "algebraic": ("exact, algebraic", "symbolic", SOLID, 2),
    "general": ("exact, trigonometric", "symbolic", DASHED, 2),
    "central": ("central differences", "numeric", SOLID, 2),
    "numpy": ("NumPy, row by row", "muted", DASHED, 2),
    "seed_exact": ("the seed's loops, mended", "muted", DOTTED, 1),
}


def times_of(numbers: Mapping[str, float], renderer: str, threads: int) -> np.ndarray:
    """Return (pixels, milliseconds) of a renderer, in order of size."""
    matches = [(re.fullmatch(rf"{renderer}_(\d+)_{threads}_ms", key), value) for key, value in numbers.items()]
    return np.array(sorted((int(match[1]) ** 2, value) for match, value in matches if match)).T


@figure(record="frames")
def time_against_pixels(record: dict) -> Drawing:
    """Time of the default frame against its pixels, every renderer, with the fitted slope of the algebraic one."""
    numbers = record["numbers"]
    fig, ax = plot(height=4.6)
    thick = []
    for renderer, (name, role, dashes, threads) in RENDERERS.items():
        curve(ax, *times_of(numbers, renderer, 1), role, label=f"{renderer}, 1", linestyle=dashes, linewidth=0.7)
        look = {"label": name, "linestyle": dashes, "marker": "o", "markersize": 3.6}
        curve(ax, *times_of(numbers, renderer, threads), role, **look)
        thick.append(ax.lines[-1])
    ax.legend(handles=thick, loc="lower right", frameon=False)
    decades(ax, xlabel="pixels, $64^2$ to $8192^2$", ylabel="milliseconds a frame")
    height, slope = 0.3 * np.interp(1e5, *times_of(numbers, "algebraic", 2)), numbers["exponent_2"]
    slope_triangle(ax, 1e5, height, slope, f"{slope:.3f}")
    return Drawing(fig)


LABEL = ("python", "date", "commit")


def _counts(record) -> Drawing:
    return Drawing(numbers=record["numbers"] | {key: record["label"][key] for key in LABEL})


@figure(record="edited_formulas")
def edited_formulas(record: dict) -> Drawing:
    """The committed run over edits of the formulas: its counts and its label; numbers only."""
    return _counts(record)


@figure(record="enclosed_pixels")
def enclosed_pixels(record: dict) -> Drawing:
    """The committed run over pixels with bounds: its counts and its label; numbers only."""
    return _counts(record)
