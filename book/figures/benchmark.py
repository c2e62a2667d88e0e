"""What was measured and kept: times against pixels and errors by `make bench`, and the counts of long runs."""

import re
from collections.abc import Iterable, Mapping

import numpy as np
from matplotlib.axes import Axes

from book.drawing.registry import Drawing, figure
from book.drawing.style import DASHED, DOTTED, SOLID, curve, decades, label_line_end, plot, slope_triangle

# renderer: (label, role of its colour, dashes, threads of its thick line), the loops last
RENDERERS = {
    "algebraic": ("exact, algebraic", "symbolic", SOLID, 2),
    "general": ("exact, trigonometric", "symbolic", DASHED, 2),
    "central": ("central differences", "numeric", SOLID, 2),
    "numpy": ("NumPy, row by row", "muted", DASHED, 2),
    "seed_exact": ("the seed's loops, mended", "muted", DOTTED, 1),
}
LABELS_APART = 10**0.3  # least ratio of the heights of two labels


def times_of(numbers: Mapping[str, float], renderer: str, threads: int) -> np.ndarray:
    """Return (pixels, milliseconds) of a renderer, in order of size."""
    matches = [(re.fullmatch(rf"{renderer}_(\d+)_{threads}_ms", key), value) for key, value in numbers.items()]
    return np.array(sorted((int(match[1]) ** 2, value) for match, value in matches if match)).T


def label_ends(ax: Axes, ends: Iterable[tuple[float, float, str, str]]) -> None:
    """Name the lines that end at [(pixels, ms, name, role)] in a column right of the longest.

    Thin lines lead there, going on as the lines would.
    """
    column, lowest = max(pixels for pixels, *_ in ends) * 1.6, 0.0
    for pixels, times, name, role in sorted(ends, key=lambda end: end[1] / end[0]):
        height = max(times * column / pixels, lowest * LABELS_APART)
        curve(ax, [pixels, column], [times, height], "rule", linewidth=0.7, zorder=0)
        label_line_end(ax, column, height, name, role)
        lowest = height


@figure(record="frames")
def time_against_pixels(record: dict) -> Drawing:
    """Time of the default frame against its pixels, every renderer, with the fitted slope of the algebraic one."""
    numbers = record["numbers"]
    fig, ax = plot(height=4.6)
    ends, rows = [], []
    for renderer, (name, role, dashes, threads) in RENDERERS.items():
        curves = {count: times_of(numbers, renderer, count) for count in (1, 2)}
        rows += [(renderer, count, *point) for count, times in curves.items() for point in times.T]
        curve(ax, *curves[threads], role, linestyle=dashes, marker="o", markersize=3.6)
        if threads == 2:
            curve(ax, *curves[1], role, linestyle=dashes, linewidth=0.7)
        ends.append((*curves[threads][:, -1], name, role))
    decades(ax, xlabel="pixels, $64^2$ to $8192^2$", ylabel="milliseconds a frame")
    label_ends(ax, ends[:-1])
    label_line_end(ax, *ends[-1], side="above")
    height, slope = 0.2 * np.interp(4e5, *times_of(numbers, "algebraic", 2)), numbers["exponent_2"]
    slope_triangle(ax, 4e5, height, slope, f"{slope:.3f}")
    return Drawing(fig, data=dict(zip(("renderer", "threads", "pixels", "ms"), zip(*rows, strict=True), strict=True)))


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
