"""The central difference's error against its step, whole and taken apart below proved bounds; the best step."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import (
    SHORT,
    bound_style,
    curve,
    decades,
    dots,
    label_curve,
    label_line_end,
    plot,
    slope_triangle,
)
from proofs.formulas.certified import GENERAL_GRADIENT
from renderer import Scene
from renderer.operations import UNIT
from renderer.picture.facts import SMOOTH_POINT
from verify.accuracy.best_step import WAVE_NUMBERS, best_of, gain, measured, predicted
from verify.accuracy.differences import CASES, STEPS, Case, Curves, bounds, escapes, parts
from verify.accuracy.orders import fitted_slope
from verify.accuracy.step_terms import slope_bound

SCENE = Scene(field="sine")
CASE = Case("the chapter's", SCENE.field, SCENE.ku, SCENE.kv, *SMOOTH_POINT)


@figure
def u_curve() -> Drawing:
    """The error of the central difference of sine at a smooth point, from ε = 0.1 to 1e-12."""
    steps = np.logspace(-1, -12, 221)
    curves = {part: np.abs(values) for part, values in parts(CASE, steps).items()}
    total, truncation = curves["total"], curves["truncation"]
    fig, ax = plot(height=3.9)
    dots(ax, steps, total, "numeric", 2.6)
    curve(ax, steps, truncation, "bound")
    decades(ax, 2, 2, ylim=(1e-13, 1e2), xlabel="step ε", ylabel="error of $h_u$")
    label_line_end(ax, steps[0], total[0], "central\ndifference", "numeric")
    at_middle = np.interp(-1e-7, -steps, truncation)
    label_line_end(ax, 1e-7, at_middle, "truncation, in\nexact arithmetic", "bound", "left")
    slope_triangle(ax, 3e-4, 1e-7, 2)
    branch = (steps < 3e-2) & (steps > 1e-4)
    best, step = total.argmin(), best_of(SCENE.ku, UNIT).step
    near = (steps > step / 3) & (steps < 3 * step)
    cited = (1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12)
    at = {f"error_{eps:.0e}": error for eps, error in zip(cited, np.abs(parts(CASE, cited)["total"]), strict=True)}
    numbers = {
        "u": SMOOTH_POINT[0],
        "v": SMOOTH_POINT[1],
        "least": total[best],
        "near_best": np.median(total[near]),
        "best_eps": steps[best],
        "slope": fitted_slope(steps[branch], total[branch]),
        "third_derivative": slope_bound(SCENE.ku) ** 3,
        "third_derivative_half": slope_bound(SCENE.ku / 2) ** 3,
        "predicted_eps": step,
    }
    data = {"step": steps, "error": total, "truncation": truncation}
    return Drawing(fig, numbers | at, data)


PLACES = {"plain": ((50, 4e-7), (2, 6e-8)), "trick": ((2, 1.2e-7), (60, 5e-10))}
"""{steps: where their labels stand, in both plots}"""


def _best(representable):
    """Return (proved, measured), each the steps and the floors of all wave numbers."""
    proved, seen = (np.array([best(k, representable) for k in WAVE_NUMBERS]).T for best in (predicted, measured))
    if (seen[1] > proved[1]).any():
        raise ValueError("a measured floor is above the proved one")
    return proved, seen


@figure
def best_step() -> Drawing:
    """The best step of the central difference of sine and the floor it leaves, for k from 1 to 512."""
    fig, axes = plot("page", 3.7, ncols=2)
    data = {"wave_number": WAVE_NUMBERS, "plain": {}, "trick": {}}
    for kind, role, marker, text in (
        ("plain", "numeric", "o", "ε as given"),
        ("trick", "symbolic", "s", "(u + ε) − u"),
    ):
        for ax, what, at, proved, seen in zip(
            axes, ("step", "floor"), PLACES[kind], *_best(kind == "trick"), strict=True
        ):
            curve(ax, WAVE_NUMBERS, proved, "bound")
            dots(ax, WAVE_NUMBERS, seen, role, 4.5, marker)
            label_line_end(ax, *at, text, role)
            data[kind] |= {what: seen, f"{what}_proved": proved}
    for ax, title in zip(axes, ("best step", "error it leaves"), strict=True):
        decades(ax, xlabel="wave number $k_u$", ylabel=title)
    numbers = {"exact": {512: GENERAL_GRADIENT * UNIT * np.pi * 512}, "gain": {k: gain(k) for k in (8, 512)}}
    numbers |= {"library_gain": {k: gain(k, library=True) for k in (8, 512)}}
    return Drawing(fig, numbers, data)


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


def _every_other(ax, values, role, size, marker="o"):
    """Draw half of the points that are tested, but for zeros."""
    steps, values = STEPS[::2], np.abs(values[::2])
    dots(ax, steps[values > 0], values[values > 0], role, size, marker)


@figure
def u_curve_parts() -> Drawing:
    """The three parts of the error of h_u of sine at a steep point, against the step, and their proved bounds."""
    found, limits = below(STEEP)
    fig, ax = plot(height=4.6)
    data = {"step": STEPS}
    for part, role, marker, text, side, at, times in (
        ("truncation", "reference", ".", "truncation", "right", 1e-10, 1),
        ("argument rounding", "difference", "x", "rounded $u ± ε$", "right", 1e-12, 30),
        ("roundoff", "symbolic", "+", "rounded evaluation", "below", 1e-13, 1e-5),
    ):
        error, bound = found[part], limits[part]
        data |= {part: np.abs(error), f"{part}_bound": bound}
        _every_other(ax, error, role, 2.4, marker)
        curve(ax, STEPS, bound, "bound", linewidth=0.9)
        label_curve(ax, STEPS, times * bound, at, text, role, side)
    decades(ax, 2, 2, xlim=REACH, ylim=(1e-20, 1e3), xlabel="step ε", ylabel="error of $h_u$")
    best = predicted(STEEP.k_u)
    curve(ax, best.step, best.floor, "ink", marker="v", markersize=6)
    label_line_end(ax, best.step, 20 * best.floor, "floor, proved", "ink", "above")
    branch = (STEPS < 1e-3) & (STEPS > 1e-7)
    slope, least = fitted_slope(STEPS[branch], data["truncation"][branch]), np.abs(found["total"]).min()
    numbers = {"slope": slope, "least": least, "floor": best.floor, "best_eps": best.step, "u": STEEP.u, "v": STEEP.v}
    return Drawing(fig, numbers, data)


@figure
def u_curve_places() -> Drawing:
    """The error of the difference at six places, smooth and not, below its proved bound."""
    fig, axes = plot("page", 5.4, nrows=2, ncols=3, sharex=True, sharey=True)
    data = {}
    for ax, (name, title) in zip(axes.ravel(), SMALL.items(), strict=True):
        found, limits = below(next(case for case in CASES if case.name == name))
        error, bound = found["total"], limits["total"]
        data |= {f"step, {name}": STEPS, f"error, {name}": np.abs(error), f"bound, {name}": bound}
        _every_other(ax, error, "numeric", 1.4)
        curve(ax, STEPS, bound, "bound")
        decades(ax, 4, 4, title=title, xlim=REACH, ylim=(1e-13, 1e4))
        ax.set(xlabel="step ε", ylabel="error")
        ax.label_outer()
    return Drawing(fig, data=data)


@figure
def u_curve_margins() -> Drawing:
    """The measured error over its proved bound, at every step: the largest and the median of all places."""
    shares = np.array([np.abs(found["total"]) / limits["total"] for found, limits in map(below, CASES)])
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
    }
    return Drawing(fig, numbers, {"step": STEPS, "largest": largest, "median": median})
