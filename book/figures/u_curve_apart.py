"""The U-curve taken apart: truncation, rounded arguments, rounded evaluation, each below its proved bound."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import SHORT, bound_style, curve, decades, dots, label_curve, label_line_end, palette, plot
from verify.accuracy.best_step import predicted
from verify.accuracy.differences import CASES, PARTS, PER_DECADE, STEPS, Case, Curves, bounds, escapes, parts
from verify.accuracy.orders import fitted_slope

STEEP = next(case for case in CASES if case.name == "steep")
SMALL = {
    "sine, k = 64": "smooth, $k = 64$",
    "crease, δ = 0.0001": "$10^{-4}$ from a crease",
    "sine, pole, v = 1e-05": "$10^{-5}$ from the pole, $h_v$",
    "seam, k = 8": "$10^{-4}$ from the seam, $k_u = 8$",
    "seam, k = 7": "the same, $k_u = 7$",
    "seam, k = 7.3": "the same, $k_u = 7.3$",
}
REACH = (1e-16, 0.2)  # of the steps' axis
ROUNDOFF = 1e-9  # below it rounding rules in every case


@cache
def below(case: Case) -> tuple[Curves, Curves]:
    """Return (the parts of a case's errors, their bounds); ValueError if any point is above its bound."""
    measured, limits = parts(case), bounds(case)
    out = {part: count for part, count in escapes(measured, limits).items() if count}
    if out:
        raise ValueError(f"{case.name}: above the proved bound: {out} of {len(STEPS)} points")
    return measured, limits


def _every_other(ax, values, role, size, marker="o"):
    """Draw half of the points that are tested, but for zeros."""
    steps, values = STEPS[::2], np.abs(values[::2])
    dots(ax, steps[values > 0], values[values > 0], role, size, marker)


@figure
def u_curve_parts() -> Drawing:
    """The three parts of the error of h_u of sine at a steep point, against the step, and their proved bounds."""
    measured, limits = below(STEEP)
    fig, ax = plot(height=4.6)
    data = {"step": STEPS}
    for part, (role, marker, text, side, at, times) in zip(PARTS[:-1], (
        ("reference", ".", "truncation", "right", 1e-10, 1),
        ("difference", "x", "rounded $u ± ε$", "right", 1e-12, 30),
        ("symbolic", "+", "rounded evaluation", "below", 1e-13, 1e-5),
    ), strict=True):  # fmt: skip
        error, bound = measured[part], limits[part]
        data |= {part: np.abs(error), f"{part}_bound": bound}
        _every_other(ax, error, role, 2.4, marker)
        curve(ax, STEPS, bound, "bound", linewidth=0.9)
        label_curve(ax, STEPS, times * bound, at, text, role, side)
    decades(ax, 2, 2, xlim=REACH, ylim=(1e-20, 1e3), xlabel="step ε", ylabel="error of $h_u$")
    best = predicted(STEEP.k_u)
    ax.plot(best.step, best.floor, color=palette()["ink"], marker="v", markersize=6)
    label_line_end(ax, best.step, 20 * best.floor, "floor, proved", "ink", "above")
    branch, total = (STEPS < 1e-3) & (STEPS > 1e-7), np.abs(measured["total"])
    numbers = {
        "slope": fitted_slope(STEPS[branch], np.abs(measured[PARTS[0]][branch])),
        "least": total.min(),
        "least_at": STEPS[total.argmin()],
        "floor": best.floor,
        "best_eps": best.step,
        "u": STEEP.u,
        "v": STEEP.v,
    }
    return Drawing(fig, numbers, data)


@figure
def u_curve_places() -> Drawing:
    """The error of the difference at six places, smooth and not, below its proved bound."""
    fig, axes = plot("page", 5.4, nrows=2, ncols=3, sharex=True, sharey=True)
    data = {}
    for ax, (name, title) in zip(axes.ravel(), SMALL.items(), strict=True):
        measured, limits = below(next(case for case in CASES if case.name == name))
        error, bound = measured["total"], limits["total"]
        data |= {f"step, {name}": STEPS, f"error, {name}": np.abs(error), f"bound, {name}": bound}
        _every_other(ax, error, "numeric", 1.4)
        curve(ax, STEPS, bound, "bound")
        decades(ax, 4, 4, title=title, xlim=REACH, ylim=(1e-13, 1e4))
    for ax in axes[1]:
        ax.set_xlabel("step ε")
    for ax in axes[:, 0]:
        ax.set_ylabel("error")
    return Drawing(fig, data=data)


@figure
def u_curve_margins() -> Drawing:
    """The measured error over its proved bound, at every step: the largest and the median of all places."""
    shares = np.array([np.abs(measured["total"]) / limits["total"] for measured, limits in map(below, CASES)])
    fig, ax = plot(height=3.2)
    largest, median = shares.max(axis=0), np.median(shares, axis=0)
    curve(ax, STEPS, largest, "difference", linewidth=1.2)
    curve(ax, STEPS, median, "difference", linewidth=1.2, linestyle=SHORT)
    ax.axhline(1, **bound_style())
    decades(ax, 2, 1, xlim=REACH, ylim=(1e-2, 3), xlabel="step ε", ylabel="error / bound")
    label_line_end(ax, STEPS[0], 0.8 * largest[0], "largest", "difference")
    label_line_end(ax, STEPS[0], median[0], "median", "difference")
    rounding = shares[:, STEPS < ROUNDOFF]
    numbers = {
        "points": shares.size,
        "places": len(CASES),
        "escaped": (shares > 1).sum(),
        "largest": shares.max(),
        "median_ratio": np.median(1 / rounding[rounding > 0]),
        "per_decade": PER_DECADE,
    }
    return Drawing(fig, numbers, {"step": STEPS, "largest": largest, "median": median})
