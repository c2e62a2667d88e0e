"""Time against error: of the gradient alone by every method, and of whole frames. Times come from the committed run."""

from collections.abc import Mapping, Sequence
from itertools import groupby

import numpy as np
from matplotlib.axes import Axes

from book.drawing.registry import Drawing, figure
from book.drawing.style import DASHED, DOTTED, SOLID, colour_of, curve, decades, label, label_line_end, plot
from verify.benchmark import work_precision
from verify.benchmark.methods.table import CLEAR
from verify.benchmark.work_precision import Row

SMALLEST = 1e-18  # of the drawing: mpmath's further digits stand as a number in the caption
DIFFERENCES = {"forward": DOTTED, "central": SOLID, "central, 4th order": DASHED,
               "Richardson, 8th order": (0, (5, 2, 1.5, 2))}  # fmt: skip
"""{difference: the dashes of its curve}"""

# {method: its name there, and where: below or above a point; or left or right of its curve, and at which error}
GRADIENT_LABELS = {
    "exact, reduced argument": ("reduced", "below"),
    "exact, algebraic": ("algebraic", "below"),
    "complex step": ("complex\nstep", "above"),
    "mpmath": ("mpmath,\n5 to 15 digits", "above"),
    "central": ("central", "left", 1e-2),
    "central, 4th order": ("central, 4th order", "right", 1e-6),
    "Richardson, 8th order": ("Richardson, 8th order", "right", 1e-8),
}
FRAME_LABELS = {
    "exact, algebraic": ("algebraic", "below"),
    "exact, general": ("general", "above"),
    "forward": ("forward", "left", 1e-3),
    "central": ("central", "left", 1e-6),
    "central, 4th order": ("4th", "right", 1e-9),
}
CLUSTER = {"SymPy, NumPy": "by hand", "dual numbers": "dual numbers", "JAX": "JAX"}
"""{method: its name} of those that share one error, that of the rounded argument."""


def label_method(ax: Axes, points: np.ndarray, role: str, text: str, side: str, at: float | None = None) -> None:
    """Write a method's name below or above one of its points, or upright along its curve where the error is `at`."""
    if at is None:
        best = points[:, 1].argmax() if side == "above" else points[:, 1].argmin()
        label_line_end(ax, *points[best], text, role, side)
    else:
        away, align = (-3, "right") if side == "left" else (3, "left")
        label(ax, (points[0, 0], at), text, role, (away, 0), rotation=90, ha=align, va="center",
              bbox={"pad": 0.5, "color": colour_of("paper")})  # fmt: skip


def draw_methods(
    ax: Axes, rows: Sequence[Row], cost: str, error: str, labels: Mapping[str, tuple], right: float
) -> None:
    """Draw each method's points (cost, error), its name, and below all the front that no point beats, on to `right`."""
    rows = [row for row in rows if row[error] >= SMALLEST]
    for name, own in groupby(rows, lambda row: row["method"]):
        first, *_ = own = list(own)
        points = np.array([(row[cost], row[error]) for row in own])
        role = "symbolic" if first["ours"] else "numeric" if name in DIFFERENCES else "ink"
        marker = "" if name in DIFFERENCES else "o"
        curve(ax, *points.T, role, label=name, linestyle=DIFFERENCES.get(name, "-"), marker=marker)
        if name in labels:
            label_method(ax, points, role, *labels[name])
    times, errors = np.array(sorted((row[cost], row[error]) for row in rows)).T
    corner = errors == np.minimum.accumulate(errors)
    ends = [*times[corner], right], [*errors[corner], errors.min()]
    curve(ax, *ends, "reference", label="front", drawstyle="steps-post", linewidth=5, alpha=0.3, zorder=0)


@figure("work_precision", record="work_precision")
def work_precision_figure(record: dict) -> Drawing:
    """Nanoseconds a gradient against the largest error at 50 digits: every method, a curve over its parameter."""
    rows, measured = record["gradients"], record["label"]
    fig, ax = plot("page", height=5.6)
    draw_methods(ax, rows, "ns", "error", GRADIENT_LABELS, 1e6)
    decades(ax, 1, 2, ylim=(1e-19, 1e4), xlabel="time, ns a gradient", ylabel="largest error of $h_u$, $h_v$")
    own = sorted((r for r in rows if r["method"] in CLUSTER), key=lambda r: r["ns"])
    middle = float(np.exp(np.mean([np.log(r["ns"]) for r in own])))
    text = "from the left:\n" + ", ".join(CLUSTER[r["method"]] for r in own)
    label(ax, (middle, own[0]["error"]), text, "ink", (0, -48), ha="center", va="top",
          arrowprops={"arrowstyle": "-", "color": colour_of("muted")})  # fmt: skip
    numbers = work_precision.gradient_numbers(rows) | dict(zip(("from", "to"), CLEAR, strict=True))
    numbers |= {name: measured[name] for name in ("machine", "processor", "python", "date", "commit")}
    numbers |= {"absent": len(measured["absent"]), "fewest": min(row["points"] for row in rows)}
    return Drawing(fig, numbers)


@figure(record="work_precision")
def work_precision_frames(record: dict) -> Drawing:
    """Milliseconds a frame against the image's error at 50 digits: sine by its largest error, ridges by its RMS."""
    rows = record["frames"]
    fig, axes = plot(height=4.2, ncols=2, sharey=True)
    numbers = {"side": record["label"]["side"], "sampled": work_precision.PIXELS}
    shown = (("sine", "largest", "sine: largest"), ("ridges", "rms", "ridges: RMS, creases and all"))
    for ax, (field, error, title) in zip(axes, shown, strict=True):
        chosen = [r for r in rows if r["field"] == field]
        longest = max(r["ms"] for r in chosen)
        draw_methods(ax, chosen, "ms", error, FRAME_LABELS, 1.15 * longest)
        limits = {"xlim": (0, 1.25 * longest), "ylim": (1e-17, 1e2)}
        decades(ax, None, 2, **limits, title=title, xlabel="time, ms a frame")
        numbers[field] = {
            work_precision.key_of(r["method"]): {"error": r[error]} for r in work_precision.best_rows(chosen, error)
        }
        numbers[field]["beaten_by"] = len(work_precision.peers_that_beat(chosen, "ms", error))
    axes[0].set_ylabel("error of the image on A")
    return Drawing(fig, numbers)
