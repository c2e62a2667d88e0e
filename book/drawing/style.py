"""How a picture of the book looks: the two widths, the colours of the current mode, labels in place of legends.

    from book.drawing.style import palette, plot, label_line_end, decades, slope_triangle
    fig, ax = plot(width="text", height=3.6)
    colour = palette()["numeric"]
    ax.loglog(steps, errors, color=colour, marker="o")
    label_line_end(ax, steps[-1], errors[-1], "central difference", colour)

A drawing is made once for the light page and once for the dark one, so take colours from `palette()`.
`panels` shows the renderer's own pixels, never resampled, with their titles as type.
"""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.mathtext import MathTextParser
from matplotlib.ticker import LogLocator, NullLocator

from book.drawing.palette import CSS_PIXELS_PER_INCH, PAGE_WIDTH, ROLE, TEXT_WIDTH, drawing_for, palette, readable
from renderer.picture.views import add_colour_bar

__all__ = [
    "bound_style", "decades", "label_curve", "label_line_end", "palette", "panels", "plot", "slope_triangle", "styled",
]  # fmt: skip

# Matplotlib keeps the last 50 formulas that it typeset. A plot's labels are more, and are laid out some ten times.
MathTextParser._parse_cached = lru_cache(maxsize=None)(MathTextParser._parse_cached.__wrapped__)

WIDTHS = {"text": TEXT_WIDTH, "page": PAGE_WIDTH}
GAP = 12  # CSS pixels between two pictures
TITLE = 24  # ... above them, for their titles
BAR = 14  # the colour bar's breadth
BAR_LABELS = 68  # the room for its numbers and its label


@contextmanager
def styled(mode: str = "light") -> Iterator[None]:
    """Matplotlib's settings for a mode, all from the book's own file and palette whatever the reader's own are."""
    with drawing_for(mode), matplotlib.rc_context():
        c = palette()
        matplotlib.rcdefaults()
        matplotlib.rcParams.update(matplotlib.rc_params_from_file(Path(__file__).with_name("matplotlibrc")))
        matplotlib.rcParams.update(
            {
                "text.color": c["ink"],
                "axes.labelcolor": c["ink"],
                "axes.edgecolor": c["rule"],
                "axes.titlecolor": c["ink"],
                "xtick.color": c["rule"],
                "ytick.color": c["rule"],
                "xtick.labelcolor": c["muted"],
                "ytick.labelcolor": c["muted"],
                "grid.color": c["grid"],
                "figure.facecolor": c["paper"],
                "axes.facecolor": "none",
                "axes.prop_cycle": matplotlib.cycler(color=[c[role] for role in ROLE]),
            }
        )
        yield


def plot(width: str = "text", height: float = 3.9, **subplots: Any) -> tuple[Figure, Any]:
    """A figure as wide as the text column ("text") or the page ("page"), and its axes, without a box.

    `height` is in inches; other arguments go to `Figure.subplots` (nrows, ncols, sharey, width_ratios …).
    """
    fig = Figure(figsize=(WIDTHS[width], height), layout="constrained")
    return fig, fig.subplots(**subplots)


def bound_style() -> dict[str, object]:
    """How a bound is drawn: dashed, black (light grey on the dark page)."""
    return {"color": palette()["bound"], "linestyle": (0, (5, 3)), "linewidth": 1.3}


def label_line_end(ax: Axes, x: float, y: float, text: str, color: str, side: str = "right") -> None:
    """Write a line's name beside its end, in its colour: a label in place of a legend.

    `side` is "right", "left", "above" or "below" of the point. Room for it is kept by the layout.
    """
    offset, horizontal, vertical = {
        "right": ((7, 0), "left", "center"),
        "left": ((-7, 0), "right", "center"),
        "above": ((0, 7), "center", "bottom"),
        "below": ((0, -7), "center", "top"),
    }[side]
    # A label may leave the axes, never the figure: the layout makes room for it.
    ax.annotate(text, (x, y), xytext=offset, textcoords="offset points", ha=horizontal, va=vertical,
                color=readable(color), annotation_clip=False)  # fmt: skip


def label_curve(
    ax: Axes, x: np.ndarray, y: np.ndarray, at: float, text: str, color: str, side: str = "right", times: float = 1
) -> None:
    """Write a curve's name where its x is nearest to `at` by ratio, at `times` its height there."""
    index = int(np.abs(np.log(np.asarray(x) / at)).argmin())
    label_line_end(ax, x[index], y[index] * times, text, color, side)


def slope_triangle(ax: Axes, x0: float, y0: float, slope: float, text: str, decades: float = 0.7) -> None:
    """A small triangle with its right angle below a line of the given slope, on log-log axes.

    (x0, y0) is the triangle's left corner, `decades` its width; `text` (say "2") stands by the rise.
    """
    x1, y1 = x0 * 10.0**decades, y0 * 10.0 ** (slope * decades)
    colour = palette()["muted"]
    ax.plot([x0, x1, x1, x0], [y0, y0, y1, y0], color=colour, linewidth=0.8, solid_joinstyle="miter")
    ax.annotate(text, (x1, (y0 * y1) ** 0.5), xytext=(4, 0), textcoords="offset points", va="center", color=colour)
    ax.annotate("1", ((x0 * x1) ** 0.5, y0), xytext=(0, -3 if slope > 0 else 3), textcoords="offset points",
                ha="center", va="top" if slope > 0 else "bottom", color=colour)  # fmt: skip


def decades(ax: Axes, x: int | None = 1, y: int | None = 1, **axes: Any) -> None:
    """Log axes whose ticks are powers of ten only, with a thin grid to read values off.

    x, y: every how many decades there is a tick, None for a linear axis. Others go to `ax.set` (xlabel, ylim, title …).
    """
    for line, scale, every in ((ax.xaxis, ax.set_xscale, x), (ax.yaxis, ax.set_yscale, y)):
        if every is not None:
            scale("log")
            line.set_major_locator(LogLocator(base=10.0**every, numticks=100))
            line.set_minor_locator(NullLocator())
            line.grid(True, which="major")
    ax.set(**axes)


def panels(
    images: Sequence[np.ndarray], titles: Sequence[str] | None = None, bar: tuple[float, float] | None = None,
    bar_label: str = "", foot: int = 0,
) -> Figure:  # fmt: skip
    """Pictures beside each other with their titles as type, pixel for pixel, and a log colour bar if asked.

    Sizes are CSS pixels, one for each pixel of a picture, so nothing is resampled; `foot` of them stay free below.
    """
    sizes = [(image.shape[1], image.shape[0]) for image in images]
    top = TITLE if titles else 8 if bar else 0
    tallest = max(h for _, h in sizes)
    width = sum(w for w, _ in sizes) + GAP * (len(images) - 1) + (GAP + BAR + BAR_LABELS if bar else 0)
    height = top + tallest + (8 if bar else 0) + foot
    fig = Figure(figsize=(width / CSS_PIXELS_PER_INCH, height / CSS_PIXELS_PER_INCH), layout="none")
    fig.pixel_exact = True  # the page may not scale it
    fig.pictures = tuple(images)  # kept beside the figure, with its data
    left = 0
    for index, (image, (w, h)) in enumerate(zip(images, sizes, strict=True)):
        ax = fig.add_axes([left / width, (height - top - h) / height, w / width, h / height])
        ax.imshow(image, interpolation="none", aspect="auto")
        ax.set_axis_off()
        if titles:
            fig.text(left / width, 1 - 15 / height, titles[index], va="baseline", color=palette()["ink"])
        left += w + GAP
    if bar:
        box = [left / width, (height - top - tallest) / height, BAR / width, tallest / height]
        add_colour_bar(fig, box, bar, bar_label)
    return fig
