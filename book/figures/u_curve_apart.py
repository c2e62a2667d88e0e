"""The U-curve taken apart: truncation, rounded arguments, rounded evaluation, each below its proved bound."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import bound_style, decades, label_curve, label_line_end, palette, plot
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
    found, limits = parts(case), bounds(case)
    out = {part: count for part, count in escapes(found, limits).items() if count}
    if out:
        raise ValueError(f"{case.name}: above the proved bound: {out} of {len(STEPS)} points")
    return found, limits


def _dots(ax, values, colour, marker="o", size=1.8):
    steps, values = STEPS[::2], np.abs(values[::2])  # half of those that are tested
    ax.plot(steps[values > 0], values[values > 0], color=colour, linewidth=0, marker=marker, markersize=size)


@figure("u_curve_parts")
def u_curve_parts() -> Drawing:
    """The three parts of the error of h_u of sine at a steep point, against the step, and their proved bounds."""
    found, limits = below(STEEP)
    fig, ax = plot(height=4.6)
    data = {"step": STEPS}
    colours = dict(zip(PARTS, ("reference", "difference", "symbolic", "numeric"), strict=True))
    markers = dict(zip(PARTS, (".", "x", "+", "o"), strict=True))
    for part in PARTS[:-1]:
        data |= {part: np.abs(found[part]), f"{part}_bound": limits[part]}
        _dots(ax, found[part], palette()[colours[part]], markers[part], 2.4)
        ax.plot(STEPS, limits[part], **bound_style() | {"linewidth": 0.9})
    decades(ax, 2, 2, xlim=REACH, ylim=(1e-20, 1e3), xlabel="step ε", ylabel="error of $h_u$")
    best = predicted(STEEP.k_u)
    ax.plot(best.step, best.floor, color=palette()["ink"], marker="v", markersize=6)
    label_line_end(ax, best.step, 20 * best.floor, "floor, proved", palette()["ink"], side="above")
    labels = ((1e-10, 1, "truncation", "right"), (1e-12, 30, "rounded $u ± ε$", "right"),
              (1e-13, 1e-5, "rounded evaluation", "below"))  # fmt: skip
    for part, (at, times, text, side) in zip(PARTS[:-1], labels, strict=True):
        label_curve(ax, STEPS, limits[part], at, text, palette()[colours[part]], side, times)
    branch, total = (STEPS < 1e-3) & (STEPS > 1e-7), np.abs(found["total"])
    numbers = {
        "slope": fitted_slope(STEPS[branch], np.abs(found["truncation"][branch])),
        "least": float(total.min()),
        "least_at": float(STEPS[total.argmin()]),
        "floor": best.floor,
        "best_eps": best.step,
        "u": STEEP.u,
        "v": STEEP.v,
    }
    return Drawing(fig, numbers=numbers, data=data)


@figure("u_curve_places")
def u_curve_places() -> Drawing:
    """The error of the difference at six places, smooth and not, below its proved bound."""
    fig, axes = plot("page", 5.4, nrows=2, ncols=3, sharex=True, sharey=True)
    data = {}
    for ax, (name, title) in zip(axes.ravel(), SMALL.items(), strict=True):
        found, limits = below(next(case for case in CASES if case.name == name))
        error, bound = np.abs(found["total"]), limits["total"]
        data |= {f"step, {name}": STEPS, f"error, {name}": error, f"bound, {name}": bound}
        _dots(ax, error, palette()["numeric"], size=1.4)
        ax.plot(STEPS, bound, **bound_style())
        decades(ax, 4, 4, title=title, xlim=REACH, ylim=(1e-13, 1e4))
    for ax in axes[1]:
        ax.set_xlabel("step ε")
    for ax in axes[:, 0]:
        ax.set_ylabel("error")
    return Drawing(fig, data=data)


@figure("u_curve_margins")
def u_curve_margins() -> Drawing:
    """The measured error over its proved bound, at every step: the largest and the median of all places."""
    shares = np.array([np.abs(found["total"]) / limits["total"] for found, limits in map(below, CASES)])
    fig, ax = plot(height=3.2)
    colour = palette()["difference"]
    largest, median = shares.max(axis=0), np.median(shares, axis=0)
    ax.plot(STEPS, largest, color=colour, linewidth=1.2)
    ax.plot(STEPS, median, color=colour, linewidth=1.2, linestyle=(0, (2, 1.5)))
    ax.axhline(1, **bound_style())
    decades(ax, 2, 1, xlim=REACH, ylim=(1e-2, 3), xlabel="step ε", ylabel="error / bound")
    label_line_end(ax, STEPS[0], 0.8 * largest[0], "largest", colour)
    label_line_end(ax, STEPS[0], median[0], "median", colour)
    rounding = shares[:, STEPS < ROUNDOFF]
    numbers = {
        "points": shares.size,
        "places": len(CASES),
        "escaped": int((shares > 1).sum()),
        "largest": float(shares.max()),
        "median_ratio": float(np.median(1 / rounding[rounding > 0])),
        "per_decade": PER_DECADE,
    }
    return Drawing(fig, numbers=numbers, data={"step": STEPS, "largest": largest, "median": median})
