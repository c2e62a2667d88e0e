"""Time against error: of the gradient alone by every method, and of whole frames. Times come from the committed run."""

from itertools import groupby

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import DASHED, DOTTED, SOLID, colour_of, curve, decades, label, plot
from verify.benchmark import work_precision
from verify.benchmark.methods.table import CLEAR

SMALLEST = 1e-18  # of the drawing: mpmath's further digits stand as a number in the caption
DIFFERENCES = {"forward": DOTTED, "central": SOLID, "central, 4th order": DASHED,
               "Richardson, 8th order": (0, (5, 2, 1.5, 2))}  # fmt: skip
"""{difference: the dashes of its curve}"""

UP, DOWN, UNDER = ((4, 4), 40, "left"), ((4, -6), -40, "left"), ((-4, -6), 40, "right")
ABOVE, BELOW = ((4, 6), 90, "left"), ((-3, -7), -90, "left")  # on a phone lines and points stand close together
LABELS = {  # method: its name, and how it leans
    "exact, reduced argument": ("exact, reduced", BELOW),
    "exact, algebraic": ("exact, algebraic", ABOVE),
    "SymPy, NumPy": ("by hand", UNDER),
    "dual numbers": ("dual numbers", DOWN),
    "JAX": ("JAX", ABOVE),
    "complex step": ("complex step", ((9, 2), 40, "left")),
    "mpmath": ("mpmath, 5 to 15 digits", UNDER),
    "central": ("central", ((1, 6), 90, "left")),
    "central, 4th order": ("4th order", ABOVE),
    "Richardson, 8th order": ("8th order", ABOVE),
}


@figure("work_precision", record="work_precision")
def work_precision_figure(record: dict) -> Drawing:
    """Nanoseconds a gradient against the largest error at 50 digits: every method, a curve over its parameter."""
    rows, measured = record["gradients"], record["label"]
    fig, ax = plot("page", height=5.6)
    drawn = [row for row in rows if row["error"] >= SMALLEST]
    for name, of_method in groupby(drawn, lambda row: row["method"]):
        first, *_ = of_method = list(of_method)
        points, differs = np.array([(row["ns"], row["error"]) for row in of_method]), name in DIFFERENCES
        role = "symbolic" if first["ours"] else "numeric" if differs else "ink"
        curve(ax, *points.T, role, label=name, linestyle=DIFFERENCES.get(name, "-"), marker="" if differs else "o")
        if name in LABELS:
            text, (aside, lean, start) = LABELS[name]
            end = points[:, 1].argmax() if differs else points[:, 1].argmin()
            label(ax, points[end], text, role, aside, ha=start, rotation=lean, rotation_mode="anchor")
    times, errors = np.array(sorted((row["ns"], row["error"]) for row in drawn)).T
    corner = errors == np.minimum.accumulate(errors)  # of the front that no point beats, which goes on to the right
    ends = [*times[corner], 1e6], [*errors[corner], errors.min()]
    curve(ax, *ends, "reference", label="front", drawstyle="steps-post", linewidth=5, alpha=0.3, zorder=0)
    decades(ax, 1, 2, ylim=(1e-20, 1e6), xlabel="time, ns a gradient", ylabel="largest error of $h_u$, $h_v$")
    numbers = work_precision.gradient_numbers(rows) | dict(zip(("from", "to"), CLEAR, strict=True))
    numbers |= {name: measured[name] for name in ("machine", "processor", "python", "date", "commit")}
    numbers |= {"absent": len(measured["absent"]), "fewest": min(row["points"] for row in rows)}
    return Drawing(fig, numbers)


@figure(record="work_precision frames")
def gains(gradients: dict, frames: dict) -> Drawing:
    """Time by a central difference over time by the exact gradient, the more is drawn beside it."""
    ratios = frames["numbers"]
    times = {
        "the gradient alone": work_precision.gradient_numbers(gradients["gradients"])["central_to_exact"],
        "sphere A alone": ratios["a_alone_central_to_algebraic"],
        "a picture, 1024²": ratios["central_1024_2_ms"] / ratios["algebraic_1024_2_ms"],
        "a picture, in the seed's loops": ratios["seed_central_to_exact"],
    }
    fig, ax = plot(height=2.2)
    bars = ax.barh([*times], [*times.values()], color=colour_of("symbolic"), height=0.6)
    ax.bar_label(bars, fmt="%.2f", padding=-32, color="white")
    ax.axvline(1, color=colour_of("numeric"))
    ax.set(xlabel="time by a difference / by the exact gradient", xlim=(0, 1.15 * max(times.values())))
    ax.invert_yaxis()
    return Drawing(fig, data={"part": [*times], "ratio": [*times.values()]})


@figure(record="work_precision")
def work_precision_frames(record: dict) -> Drawing:
    """The image's error at 50 digits, of sine the largest, of ridges the RMS, by each method; numbers only."""
    numbers = {"side": record["label"]["side"], "sampled": work_precision.PIXELS}
    for field, error in (("sine", "largest"), ("ridges", "rms")):
        rows = [r for r in record["frames"] if r["field"] == field]
        best = work_precision.best_rows(rows, error)
        numbers[field] = {work_precision.key_of(r["method"]): {"error": r[error]} for r in best}
        numbers[field]["beaten_by"] = len(work_precision.peers_that_beat(rows, "ms", error))
    return Drawing(numbers=numbers)


@figure(record="work_precision")
def derivative_times(record: dict) -> Drawing:
    """Times of a picture and its slopes, and their ratios to a difference of pictures and to JAX; numbers only."""
    return Drawing(numbers=record["slopes"])
