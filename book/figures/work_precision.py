"""Time against error: of the gradient alone by every method, and of whole frames. Times come from the committed run."""

from collections.abc import Sequence
from itertools import groupby

import numpy as np
from matplotlib.axes import Axes

from book.drawing.registry import Drawing, figure
from book.drawing.style import DASHED, DOTTED, SOLID, curve, decades, label, plot
from verify.benchmark import work_precision
from verify.benchmark.methods.table import CLEAR
from verify.benchmark.work_precision import Row

SMALLEST = 1e-18  # of the drawing: mpmath's further digits stand as a number in the caption
DIFFERENCES = {"forward": DOTTED, "central": SOLID, "central, 4th order": DASHED,
               "Richardson, 8th order": (0, (5, 2, 1.5, 2))}  # fmt: skip
"""{difference: the dashes of its curve}"""

NAMES = {"SymPy, NumPy": "by hand", "exact, reduced argument": "exact, reduced"}  # others are called as they are


def draw_methods(ax: Axes, rows: Sequence[Row], cost: str, error: str, right: float) -> None:
    """Draw each method's points (cost, error), its name, and below all the front that no point beats, on to `right`."""
    rows = [row for row in rows if row[error] >= SMALLEST]
    for name, own in groupby(rows, lambda row: row["method"]):
        first, *_ = own = list(own)
        points = np.array([(row[cost], row[error]) for row in own])
        role = "symbolic" if first["ours"] else "numeric" if name in DIFFERENCES else "ink"
        marker = "" if name in DIFFERENCES else "o"
        curve(ax, *points.T, role, label=name, linestyle=DIFFERENCES.get(name, "-"), marker=marker)
        end = points[:, 1].argmax() if name in DIFFERENCES else points[:, 1].argmin()
        label(ax, points[end], NAMES.get(name, name), role, (4, 4), rotation=40, rotation_mode="anchor")
    times, errors = np.array(sorted((row[cost], row[error]) for row in rows)).T
    corner = errors == np.minimum.accumulate(errors)
    ends = [*times[corner], right], [*errors[corner], errors.min()]
    curve(ax, *ends, "reference", label="front", drawstyle="steps-post", linewidth=5, alpha=0.3, zorder=0)


@figure("work_precision", record="work_precision")
def work_precision_figure(record: dict) -> Drawing:
    """Nanoseconds a gradient against the largest error at 50 digits: every method, a curve over its parameter."""
    rows, measured = record["gradients"], record["label"]
    fig, ax = plot("page", height=5.6)
    draw_methods(ax, rows, "ns", "error", 1e6)
    decades(ax, 1, 2, ylim=(1e-19, 1e4), xlabel="time, ns a gradient", ylabel="largest error of $h_u$, $h_v$")
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
        draw_methods(ax, chosen, "ms", error, 1.15 * longest)
        limits = {"xlim": (0, 1.25 * longest), "ylim": (1e-17, 1e2)}
        decades(ax, None, 2, **limits, title=title, xlabel="time, ms a frame")
        numbers[field] = {
            work_precision.key_of(r["method"]): {"error": r[error]} for r in work_precision.best_rows(chosen, error)
        }
        numbers[field]["beaten_by"] = len(work_precision.peers_that_beat(chosen, "ms", error))
    axes[0].set_ylabel("error of the image on A")
    return Drawing(fig, numbers)
