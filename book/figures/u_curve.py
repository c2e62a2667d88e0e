"""The central difference's error against its step, whole and taken apart below proved bounds; the best step."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import curve, decades, dots, label_curve, label_line_end, plot, slope_triangle
from proofs.formulas.certified import GENERAL_GRADIENT
from renderer import Scene
from renderer.operations import UNIT
from renderer.picture.facts import SMOOTH_POINT
from verify.accuracy.best_step import best_of, gain, predicted
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
    dots(ax, steps, total, "numeric", 2.6, name="error")
    curve(ax, steps, truncation, "bound", label="truncation")
    decades(ax, 2, 2, ylim=(1e-13, 1e2), xlabel="step ε", ylabel="error of $h_u$")
    label_line_end(ax, steps[0], total[0], "central\ndifference", "numeric")
    label_curve(ax, steps, truncation / 30, 4e-6, "truncation, in\nexact arithmetic", "bound")
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
    return Drawing(fig, numbers | at)


@figure
def best_step() -> Drawing:
    """How much less error representable steps leave the central difference of sine, at its best; numbers only."""
    numbers = {"exact": {512: GENERAL_GRADIENT * UNIT * np.pi * 512}, "gain": {k: gain(k) for k in (8, 512)}}
    return Drawing(numbers=numbers | {"library_gain": {k: gain(k, library=True) for k in (8, 512)}})


STEEP = next(case for case in CASES if case.name == "steep")
REACH = (1e-16, 0.2)  # of the steps' axis
ROUNDOFF = 1e-9  # below it rounding rules in every case


@cache
def below(case: Case) -> tuple[Curves, Curves]:
    """Return (the parts of a case's errors, their bounds); ValueError if any point is above its bound."""
    errors, limits = parts(case), bounds(case)
    out = {part: count for part, count in escapes(errors, limits).items() if count}
    if out:
        raise ValueError(f"{case.name}: above the proved bound: {out} of {len(STEPS)} points")
    return errors, limits


@figure
def u_curve_parts() -> Drawing:
    """The three parts of the error of h_u of sine at a steep point, against the step, and their proved bounds."""
    errors, limits = below(STEEP)
    fig, ax = plot(height=4.6)
    for part, role, marker, text, side, at, times in (
        ("truncation", "reference", ".", "truncation", "right", 1e-10, 1),
        ("argument rounding", "difference", "x", "rounded $u ± ε$", "right", 1e-12, 30),
        ("roundoff", "symbolic", "+", "rounded evaluation", "below", 1e-13, 1e-5),
    ):
        error, bound = np.abs(errors[part][::2]), limits[part]  # half of the points that are tested, but for zeros
        dots(ax, STEPS[::2][error > 0], error[error > 0], role, 2.4, marker, part)
        curve(ax, STEPS, bound, "bound", label=f"{part}, proved", linewidth=0.9)
        label_curve(ax, STEPS, times * bound, at, text, role, side)
    decades(ax, 2, 2, xlim=REACH, ylim=(1e-20, 1e3), xlabel="step ε", ylabel="error of $h_u$")
    best = predicted(STEEP.k_u)
    curve(ax, best.step, best.floor, "ink", marker="v", markersize=6)
    label_line_end(ax, best.step, 20 * best.floor, "floor, proved", "ink", "above")
    branch = (STEPS < 1e-3) & (STEPS > 1e-7)
    slope, least = fitted_slope(STEPS[branch], np.abs(errors["truncation"])[branch]), np.abs(errors["total"]).min()
    numbers = {"slope": slope, "least": least, "floor": best.floor, "best_eps": best.step, "u": STEEP.u, "v": STEEP.v}
    return Drawing(fig, numbers)


@figure
def u_curve_margins() -> Drawing:
    """The measured error over its proved bound, at every step and in all places; numbers only."""
    shares = np.array([np.abs(errors["total"]) / limits["total"] for errors, limits in map(below, CASES)])
    rounding = shares[:, STEPS < ROUNDOFF]
    numbers = {
        "points": shares.size,
        "places": len(CASES),
        "escaped": (shares > 1).sum(),
        "median_ratio": np.median(1 / rounding[rounding > 0]),
    }
    return Drawing(numbers=numbers)
