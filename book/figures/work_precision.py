"""Time against error: of the gradient alone by every method, and of whole frames. Times come from the committed run."""

from collections.abc import Iterable, Sequence

import numpy as np
from matplotlib.axes import Axes

from book.drawing.palette import readable
from book.drawing.registry import Drawing, figure
from book.drawing.style import decades, label_line_end, palette, plot
from verify.benchmark import work_precision
from verify.benchmark.methods.table import CLEAR
from verify.benchmark.work_precision import Row
from verify.records import RECORDS, read

RECORD = RECORDS["work_precision"].path
SMALLEST = 1e-18  # of the drawing: mpmath's further digits stand as a number in the caption

# Where a method's name stands: beside its point, (side, what to write); or along its curve, the error at its middle.
GRADIENT_LABELS = {
    "exact, reduced argument": ("below", "reduced"),
    "exact, algebraic": ("below", "algebraic"),
    "exact, algebraic, float32": ("above", "algebraic,\nfloat32"),
    "complex step": ("above", "complex\nstep"),
    "scipy.differentiate": ("above", "SciPy"),
    "numdifftools": ("below", "numdifftools"),
    "mpmath": ("above", "mpmath,\n5 to 15 digits"),
}
ALONG = {"forward": 1e-2, "central": 1e-2, "central, 4th order": 1e-6, "central, 6th order": 1e-1,
         "Richardson, 8th order": 1e-8}  # fmt: skip
SOLID = (0, ())
DASHES = {"forward": (0, (1.5, 1.5)), "central": (0, ()), "central, 4th order": (0, (5, 2)),
          "central, 6th order": (0, (8, 2)), "Richardson, 8th order": (0, (5, 2, 1.5, 2))}  # fmt: skip


def by_method(rows: Sequence[Row]) -> dict[str, list[Row]]:
    """Return {method: its rows, in order}."""
    return {name: [r for r in rows if r["method"] == name] for name in dict.fromkeys(r["method"] for r in rows)}


def columns(rows: Sequence[Row], names: Iterable[str]) -> dict[str, list[float]]:
    """Return the named values of rows as columns; a method without a parameter has the value NaN."""
    return {name: [np.nan if row[name] is None else row[name] for row in rows] for name in names}


def pareto(points: Iterable[tuple[float, float]]) -> np.ndarray:
    """Return the points (time, error) that no other one beats, by time: the corners of the front."""
    best, front = np.inf, []
    for when, error in sorted(points):
        if error < best:
            front.append((when, error))
            best = error
    return np.array(front)


def draw_front(ax: Axes, points: Iterable[tuple[float, float]], right: float) -> None:
    """Draw the Pareto front as steps, down from its first corner and on to `right`."""
    front = pareto(points)
    times, errors = np.append(front[:, 0], right), np.append(front[:, 1], front[-1, 1])
    ax.step(times, errors, where="post", color=palette()["reference"], linewidth=5, alpha=0.3, zorder=0)


def label_along(ax: Axes, x: float, y: float, text: str, colour: str, side: str = "left") -> None:
    """Write a name along an upright line, to its left or right."""
    away, align = (-3, "right") if side == "left" else (3, "left")
    ax.annotate(text, (x, y), xytext=(away, 0), textcoords="offset points", rotation=90, ha=align, va="center",
                color=readable(colour), bbox={"pad": 0.5, "color": palette()["paper"]})  # fmt: skip


def label_numbers() -> dict[str, str | int]:
    """Return where, when and at which commit it was measured, as numbers of a figure."""
    label = read("work_precision")["label"]
    cited = {name: label[name] for name in ("machine", "processor", "python", "date", "commit", "rounds")}
    return cited | {"absent": len(label["absent"])}


@figure("work_precision", data=[RECORD])
def work_precision_figure() -> Drawing:
    """Nanoseconds a gradient against the largest error at 50 digits: every method, a curve over its parameter."""
    rows = read("work_precision")["gradients"]
    fig, ax = plot("page", height=5.6)
    blue, orange, ink = palette()["symbolic"], palette()["numeric"], palette()["ink"]
    for name, own in by_method(rows).items():
        points = np.array([(r["ns"], max(r["error"], SMALLEST / 10)) for r in own])
        shown = points[points[:, 1] >= SMALLEST]
        colour = blue if own[0]["ours"] else orange if name in DASHES else ink
        marker = "o" if len(own) == 1 or name not in DASHES else ""
        ax.plot(*shown.T, color=colour, linestyle=DASHES.get(name, SOLID), linewidth=1.4, marker=marker, markersize=5)
        if name in GRADIENT_LABELS:
            side, text = GRADIENT_LABELS[name]
            corner = shown[shown[:, 1].argmax() if side == "above" else shown[:, 1].argmin()]
            label_line_end(ax, *corner, text, colour, side=side)
        if name in ALONG:
            side = "right" if name in ("central, 6th order", "Richardson, 8th order") else "left"
            label_along(ax, own[0]["ns"], ALONG[name], name, colour, side)
    draw_front(ax, [(r["ns"], r["error"]) for r in rows if r["error"] >= SMALLEST], 1e6)
    _label_cluster(ax, rows)
    decades(ax, 1, 2, ylim=(1e-19, 1e4), xlabel="time, ns a gradient", ylabel="largest error of $h_u$, $h_v$")
    data = columns(rows, ("method", "value", "ns", "error"))
    numbers = work_precision.gradient_numbers(rows) | label_numbers() | dict(zip(("from", "to"), CLEAR, strict=True))
    return Drawing(fig, numbers=numbers, data=data)


NAMES = {
    "exact, naive argument": "naive argument",
    "SymPy, NumPy": "SymPy",
    "dual numbers": "dual numbers",
    "JAX": "JAX",
}


def _label_cluster(ax, rows):
    """Name the methods that share one error, that of the rounded argument, in order of their times."""
    own = sorted((r for r in rows if r["method"] in NAMES), key=lambda r: r["ns"])
    middle = float(np.exp(np.mean([np.log(r["ns"]) for r in own])))
    text = "from the left:\n" + ", ".join(NAMES[r["method"]] for r in own)
    ax.annotate(text, (middle, own[0]["error"]), xytext=(0, -48), textcoords="offset points", ha="center", va="top",
                color=palette()["ink"], arrowprops={"arrowstyle": "-", "color": palette()["muted"]})  # fmt: skip


FRAME_ALONG = {"forward": 1e-3, "central": 1e-6, "4th": 1e-9}


@figure("work_precision_frames", data=[RECORD])
def work_precision_frames() -> Drawing:
    """Milliseconds a frame against the image's error at 50 digits: sine by its largest error, ridges by its RMS."""
    rows = read("work_precision")["frames"]
    fig, axes = plot(height=4.2, ncols=2, sharey=True)
    blue, orange, numbers = palette()["symbolic"], palette()["numeric"], {}
    shown = (("sine", "largest", "sine: largest"), ("ridges", "rms", "ridges: RMS, creases and all"))
    for ax, (field, error, title) in zip(axes, shown, strict=True):
        chosen = [r for r in rows if r["field"] == field]
        for name, own in by_method(chosen).items():
            points = np.array([(r["ms"], r[error]) for r in own])
            colour = blue if own[0]["ours"] else orange
            marker = "o" if own[0]["ours"] else ""
            ax.plot(*points.T, color=colour, linestyle=DASHES.get(name, SOLID), marker=marker)
            short = name.removeprefix("exact, ").removeprefix("central, ").removesuffix(" order")
            if own[0]["ours"]:
                side = "below" if short == "algebraic" else "above"
                label_line_end(ax, *points[0], short, colour, side=side)
            else:
                side = "right" if short == "4th" else "left"
                label_along(ax, points[0, 0], FRAME_ALONG[short], short, colour, side)
            key = f"{field}_" + "".join(c if c.isalnum() else "_" for c in name.lower())
            numbers |= {f"{key}_ms": own[0]["ms"], f"{key}_error": points[:, 1].min()}
        numbers[f"{field}_beaten_by"] = len(work_precision.peers_that_beat(chosen, "ms", error))
        draw_front(ax, [(r["ms"], r[error]) for r in chosen], 1.15 * max(r["ms"] for r in chosen))
        limits = {"xlim": (0, 1.25 * max(r["ms"] for r in chosen)), "ylim": (1e-17, 1e2)}
        decades(ax, None, 2, **limits, title=title, xlabel="time, ms a frame")
    axes[0].set_ylabel("error of the image on A")
    numbers |= label_numbers() | {"side": read("work_precision")["label"]["side"]}
    return Drawing(fig, numbers=numbers, data=columns(rows, ("field", "method", "value", "ms", "largest", "rms")))
