"""How a plot of the book looks: the two widths, the colours of the current mode, labels in place of legends.

    from book.drawing.style import palette, plot, label_line_end, decades, slope_triangle
    fig, ax = plot(width="text", height=3.6)
    colour = palette()["numeric"]
    ax.loglog(steps, errors, color=colour, marker="o")
    label_line_end(ax, steps[-1], errors[-1], "central difference", colour)

A drawing is made once for the light page and once for the dark one, so take colours from `palette()`.
Pictures made of the renderer's own pixels are in `book/drawing/pictures.py`.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path

import matplotlib
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.mathtext import MathTextParser
from matplotlib.ticker import LogLocator, NullFormatter, NullLocator

from book.drawing.palette import PAGE_WIDTH, ROLE, TEXT_WIDTH, dark, light, mode, palette, readable
from book.drawing.pictures import panels

__all__ = [
    "PAGE_WIDTH", "ROLE", "TEXT_WIDTH", "bound_style", "dark", "decades", "label_line_end",
    "light", "mode", "palette", "panels", "plot", "readable", "slope_triangle", "styled",
]  # fmt: skip

# Matplotlib keeps the last 50 formulas that it typeset. A plot's labels are more, and are laid out some ten times.
MathTextParser._parse_cached = lru_cache(maxsize=None)(MathTextParser._parse_cached.__wrapped__)

WIDTHS = {"text": TEXT_WIDTH, "page": PAGE_WIDTH}


def colour_settings() -> dict[str, object]:
    """The Matplotlib settings that depend on the mode."""
    c = palette()
    return {
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


@contextmanager
def styled() -> Iterator[None]:
    """Matplotlib's settings, all from the book's own file and palette whatever the reader's own are."""
    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        matplotlib.rcParams.update(matplotlib.rc_params_from_file(Path(__file__).with_name("matplotlibrc")))
        matplotlib.rcParams.update(colour_settings())
        yield


def plot(width: str = "text", height: float = 3.9, **subplots) -> tuple[Figure, Axes]:
    """A figure as wide as the text column ("text") or the page ("page"), and its axes, without a box.

    `height` is in inches; other arguments go to `Figure.subplots` (nrows, ncols, sharey, width_ratios …).
    """
    if width not in WIDTHS:
        raise ValueError(f'width={width!r}: a plot is as wide as the "text" or the "page"')
    with matplotlib.rc_context(colour_settings()):
        fig = Figure(figsize=(WIDTHS[width], height), layout="constrained")
        return fig, fig.subplots(**subplots)


def bound_style() -> dict[str, object]:
    """How a bound is drawn: dashed, black (light grey on the dark page)."""
    return {"color": palette()["bound"], "linestyle": (0, (5, 3)), "linewidth": 1.3}


def label_line_end(ax: Axes, x: float, y: float, text: str, color: str, side: str = "right", **more) -> None:
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
                color=readable(color), annotation_clip=False, **more)  # fmt: skip


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


def decades(ax: Axes, axis: str = "both", every: int = 1, grid: bool = True) -> None:
    """Log axes whose ticks are powers of ten only (each `every`-th), with a thin grid to read values off."""
    for name in "xy":
        if axis not in (name, "both"):
            continue
        line = getattr(ax, f"{name}axis")
        getattr(ax, f"set_{name}scale")("log")
        ticks = LogLocator(base=10.0**every, numticks=100)
        line.set_major_locator(ticks)
        line.set_minor_locator(NullLocator())
        line.set_minor_formatter(NullFormatter())
        line.grid(grid, which="major")
