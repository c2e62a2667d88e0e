"""Style of the book's pictures: the two widths, the light page's colours, labels in place of legends.

    from book.drawing.style import curve, decades, plot, slope_triangle
    fig, ax = plot(width="text", height=3.6)
    curve(ax, steps, errors, "numeric", "central difference", marker="o")
    decades(ax, 2, 2, xlabel="step ε", ylabel="error")

A drawing is made for the light page; `for_dark` gives it the other's colours. A `role` is a name of the palette, or a
colour.
`panels` shows the renderer's own pixels, never resampled, with their titles as type; `canvas` is a figure of so many
CSS pixels, on which `pixel_axes`, `pixel_picture` and `pixel_text` place by pixels from its upper left corner.
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

from book.drawing.palette import CSS_PIXELS_PER_INCH, PAGE_WIDTH, PHONE_WIDTH, ROLE, TEXT_WIDTH, colour_of, readable
from renderer.picture.views import add_colour_bar

# Matplotlib keeps the last 50 formulas that it typeset. A plot's labels are more, and are laid out some ten times.
MathTextParser._parse_cached = lru_cache(maxsize=None)(MathTextParser._parse_cached.__wrapped__)

WIDTHS = {"text": TEXT_WIDTH, "page": PAGE_WIDTH}
SOLID, DASHED, SHORT, DOTTED = (0, ()), (0, (5, 2)), (0, (2, 1.5)), (0, (1.5, 1.5))  # Matplotlib's linestyle=
GAP = 12  # CSS pixels between two pictures
TITLE = 24  # ... above them, for their titles
BAR = 14  # the colour bar's breadth
BAR_LABELS = 68  # the room for its numbers and its label
COLOURED = {  # by the colour of the palette: Matplotlib's settings that have it
    "ink": ("text.color", "axes.labelcolor", "axes.titlecolor"),
    "rule": ("axes.edgecolor", "xtick.color", "ytick.color"),
    "muted": ("xtick.labelcolor", "ytick.labelcolor"),
    "grid": ("grid.color",),
    "paper": ("figure.facecolor",),
}
SIDES = {  # where a label stands beside its point: its offset in points, its alignment
    "right": ((7, 0), "left", "center"),
    "left": ((-7, 0), "right", "center"),
    "above": ((0, 7), "center", "bottom"),
    "below": ((0, -7), "center", "top"),
}


@contextmanager
def styled() -> Iterator[None]:
    """Run a block under the book's own settings of Matplotlib, whatever the reader's are."""
    with matplotlib.rc_context(fname=Path(__file__).with_name("matplotlibrc")):
        for role, names in COLOURED.items():
            matplotlib.rcParams.update(dict.fromkeys(names, colour_of(role)))
        matplotlib.rcParams["axes.prop_cycle"] = matplotlib.cycler(color=[*ROLE.values()])
        yield


def plot(width: str = "text", height: float = 3.9, **subplots: Any) -> tuple[Figure, Any]:
    """Return a figure as wide as the text column ("text") or the page ("page"), and its axes, without a box.

    `height` is in inches; other arguments go to `Figure.subplots` (nrows, ncols, sharey, width_ratios …).
    """
    fig = Figure(figsize=(WIDTHS[width], height), layout="constrained")
    return fig, fig.subplots(**subplots)


def narrow(fig: Figure) -> None:
    """Lay a plot out for a phone: its axes one below the other, and fewer powers of ten below them."""
    axes = [ax for ax in fig.axes if ax.get_subplotspec()]
    for place, ax in zip(fig.add_gridspec(len(axes), 1), axes, strict=True):
        ax.set_subplotspec(place)
        ax.tick_params(labelleft=True)
        if ax.get_xscale() == "log":
            ax.locator_params("x", numticks=6)
    fig.set_size_inches(PHONE_WIDTH, len(axes) * fig.get_figheight())


def curve(ax: Axes, x: Any, y: Any, role: str, text: str = "", side: str = "right", at: float | None = None,
          **look: Any) -> None:  # fmt: skip
    """Draw y against x in a role's colour, a "bound" dashed; `look` goes to Line2D, whose label is `text`.

    `text` stands to a side of its last point, or of the one where x is nearest to `at` by ratio.
    """
    line = {"label": "_", "color": colour_of(role)}
    if role == "bound":
        line |= {"label": "bound", "linestyle": (0, (5, 3)), "linewidth": 1.3}
    ax.plot(x, y, **line | ({"label": text} if text else {}) | look)
    if text:
        label_curve(ax, x, y, x[-1] if at is None else at, text, role, side)


def dots(ax: Axes, x: Any, y: Any, role: str, size: float, marker: str = "o", name: str = "points") -> None:
    """Draw points without a line between them; `name` is their label."""
    curve(ax, x, y, role, label=name, linewidth=0, marker=marker, markersize=size, rasterized=True)


def label(ax: Axes, at: tuple[float, float], text: str, role: str, aside: tuple[float, float], **look: Any) -> None:
    """Write text some points aside of a place, in a colour that can be read on the page; it may leave the axes."""
    ax.annotate(text, at, xytext=aside, textcoords="offset points", color=readable(role),
                annotation_clip=False, **look)  # fmt: skip


def label_line_end(ax: Axes, x: float, y: float, text: str, role: str, side: str = "right") -> None:
    """Write a line's name beside its end, in its colour: a label in place of a legend.

    `side` is "right", "left", "above" or "below" of the point. Room for it is kept by the layout.
    """
    aside, horizontal, vertical = SIDES[side]
    label(ax, (x, y), text, role, aside, ha=horizontal, va=vertical)


def label_curve(ax: Axes, x: Any, y: np.ndarray, at: float, text: str, role: str, side: str = "right") -> None:
    """Write a curve's name where its x is nearest to `at` by ratio."""
    index = np.abs(np.log(np.asarray(x) / at)).argmin()
    label_line_end(ax, x[index], y[index], text, role, side)


def slope_triangle(ax: Axes, x0: float, y0: float, slope: float, decades: float = 0.7) -> None:
    """Draw a small triangle with its right angle below a line of the given slope, on log-log axes.

    (x0, y0) is the triangle's left corner, `decades` its width; |slope| stands by the rise.
    """
    x1, y1 = x0 * 10.0**decades, y0 * 10.0 ** (slope * decades)
    curve(ax, [x0, x1, x1, x0], [y0, y0, y1, y0], "muted", linewidth=0.8, solid_joinstyle="miter")
    text = f"{abs(slope):g}".replace("0.5", "½")
    label(ax, (x1, (y0 * y1) ** 0.5), text, "muted", (4, 0), va="center")
    down, va = (-3, "top") if slope > 0 else (3, "bottom")
    label(ax, ((x0 * x1) ** 0.5, y0), "1", "muted", (0, down), ha="center", va=va)


def decades(ax: Axes, x: int | None = 1, y: int | None = 1, **axes: Any) -> None:
    """Make axes logarithmic, with powers of ten as the only ticks and a thin grid to read values off.

    x, y: every how many decades there is a tick, None for a linear axis. Others go to `ax.set` (xlabel, ylim, title …).
    """
    for line, scale, every in ((ax.xaxis, ax.set_xscale, x), (ax.yaxis, ax.set_yscale, y)):
        if every is not None:
            scale("log")
            line.set_major_locator(LogLocator(base=10.0**every, numticks=100))
            line.set_minor_locator(NullLocator())
            line.grid(True, which="major")
    ax.set(**axes)


def canvas(wide: float, high: float) -> Figure:
    """Return a figure of so many CSS pixels, which the page shows at that size."""
    fig = Figure(figsize=(wide / CSS_PIXELS_PER_INCH, high / CSS_PIXELS_PER_INCH), layout="none")
    fig.pixel_exact = True
    return fig


def _box(fig, left, top, wide, high):
    """Return a box, in CSS pixels from the figure's upper left corner, as Matplotlib's: from below, as shares."""
    width, height = fig.get_size_inches() * CSS_PIXELS_PER_INCH
    return left / width, (height - top - high) / height, wide / width, high / height


def pixel_axes(fig: Figure, left: float, top: float, wide: float, high: float, **limits: Any) -> Axes:
    """Return axes that fill a box given in CSS pixels from the figure's upper left corner, without a frame."""
    ax = fig.add_axes(_box(fig, left, top, wide, high))
    ax.set_axis_off()
    ax.set(**limits)
    return ax


def pixel_picture(fig: Figure, left: float, top: float, picture: np.ndarray) -> Axes:
    """Show a picture, one of its pixels a CSS pixel, so many of them from the figure's upper left corner."""
    ax = pixel_axes(fig, left, top, *picture.shape[1::-1])
    ax.imshow(picture, interpolation="none", aspect="auto")
    return ax


def pixel_text(fig: Figure, left: float, top: float, text: str, role: str = "ink") -> None:
    """Write text whose baseline begins so many CSS pixels from the figure's upper left corner."""
    x, y, *_ = _box(fig, left, top, 0, 0)
    fig.text(x, y, text, color=colour_of(role))


def panels(
    images: Sequence[np.ndarray], titles: Sequence[str] | None = None, bar: tuple[float, float] | None = None,
    bar_label: str = "largest |ΔI| of a channel", foot: int = 0,
) -> Figure:  # fmt: skip
    """Draw pictures beside each other, pixel for pixel, with titles as type and, if asked, a log colour bar.

    Sizes are CSS pixels, one for each pixel of a picture, so nothing is resampled; `foot` of them stay free below.
    """
    top = TITLE if titles else 8 if bar else 0
    tallest = max(len(image) for image in images)
    width = sum(image.shape[1] + GAP for image in images) + (BAR + BAR_LABELS if bar else -GAP)
    fig = canvas(width, top + tallest + (8 if bar else 0) + foot)
    fig.pictures = tuple(images)  # kept beside the figure, with its data
    left = 0
    for index, image in enumerate(images):
        pixel_picture(fig, left, top, image)
        if titles:
            pixel_text(fig, left, 15, titles[index])
        left += image.shape[1] + GAP
    if bar:
        add_colour_bar(fig, _box(fig, left, top, BAR, tallest), bar, bar_label)
    return fig
