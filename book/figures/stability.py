"""Stability under stress: each error against what is stressed, with the bound of every measured point."""

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import DASHED, SOLID, curve, decades, label_curve, label_line_end, plot, slope_triangle
from proofs.formulas.certified import GENERAL_GRADIENT
from renderer.operations import UNIT
from verify.stability.rows import SWEEPS, sweep

LOWEST = 1e-18


def _draw(ax, name, others=(), at=None, sides=("above", "below")):
    """Draw a sweep's bound and our error, named at a place, and the others' errors: [(name, text, side, at, dash)].

    Return its curves by name: the parameter, our error, the bound, the others' errors.
    """
    swept = sweep(name)
    data = {"parameter": swept.parameter, "ours": np.maximum(swept.worst(), LOWEST), "bound": swept.bounds.max(axis=1)}
    data |= {other: swept.worst(other) for other in swept.others}
    for other, text, side, there, dash in others:
        curve(ax, swept.parameter, data[other], "numeric", text, side, there, linewidth=1.5, linestyle=dash)
    curve(ax, swept.parameter, data["bound"], "bound", "bound", sides[0], at)
    curve(ax, swept.parameter, data["ours"], "symbolic", "ours", sides[1], at, linewidth=1.6)
    return data


def _numbers(*names):
    """Return the numbers of sweeps: points, escapes, sharpness, the largest error of ours and of others."""
    numbers = {}
    for name in names:
        swept = sweep(name)
        numbers[name] = {what: getattr(swept, what) for what in ("points", "escaped", "sharpness")}
        numbers[name] |= {"worst": swept.worst().max(), "in_responses": swept.in_responses()}
        for other in swept.others:
            numbers[name][other.split(",")[0].replace(" ", "_")] = np.nanmax(swept.worst(other))
    return numbers


@figure
def stability_pole() -> Drawing:
    """The error of the tangent vector g against sin φ, from 0.84 to 1e-149: the seed's forms, ours, and our bound."""
    fig, ax = plot(height=4.2)
    swept = sweep("pole")
    last = swept.parameter[np.isfinite(swept.worst("seed"))][-1]
    others = (
        ("seed", "seed, without: here it divides by zero", "right", last, SOLID),
        ("seed with fallback", "seed, with its fallback", "above", 1e-60, DASHED),
    )
    data = _draw(ax, "pole", others, 1e-75)
    decades(ax, 25, 4, xlim=(1, 1e-150), ylim=(LOWEST, 1e4), xlabel="sin φ", ylabel="error of $g$")
    return Drawing(fig, _numbers("pole", "pole_general"), data)


@figure
def stability_silhouette() -> Drawing:
    """The error of the normal against the distance from the silhouette: ours, the seed's, and our bound."""
    fig, ax = plot(height=3.6)
    data = _draw(ax, "silhouette", [("seed", "", "", None, DASHED)], sides=("right", "right"))
    decades(ax, 2, 2, xlim=(1, 1e-14), ylim=(1e-17, 1e-6), ylabel="error of $N$",
            xlabel=r"$s = 1 - (\rho/\rho_s)^2$")  # fmt: skip
    slope_triangle(ax, 1e-12, 3e-12, -0.5, decades=2)
    label_line_end(ax, data["parameter"][-1], data["seed"][-1] / 2, "seed", "numeric")
    scaled = data["ours"] * np.sqrt(data["parameter"]) * 2.0**53
    return Drawing(fig, _numbers("silhouette") | {"in_roundings": scaled.max()}, data)


@figure
def stability_near_far() -> Drawing:
    """The error of the normal from the nearest eye to the furthest: ours, the seed's, and our bound."""
    fig, ax = plot(height=3.6)
    data = _draw(ax, "near_to_far", [("seed", "seed", "above", 1e-6, DASHED)], 1e-3)
    decades(ax, 3, 2, ylim=(1e-17, 1e-8), ylabel="error of $N$",
            xlabel="$e/R - 1$: the eye's height above the sphere, in radii")  # fmt: skip
    return Drawing(fig, _numbers("near_to_far"), data)


@figure
def stability_wave_numbers() -> Drawing:
    """The error of the gradient over π max(1, |k|) against |k| up to 2^20, with two other ways to take the argument."""
    naive, rounded = sweep("wave_numbers_sine").others
    fig, ax = plot(height=3.9)
    others = (naive, "libm, argument rounded", "left", 1e3, SOLID), (rounded, "", "", None, DASHED)
    data = _draw(ax, "wave_numbers_sine", others, 1e5)
    decades(ax, 1, 2, ylim=(1e-17, 1e-8), xlabel="$|k|$", ylabel=r"error / $\pi\,\max(1, |k|)$")
    label_curve(
        ax, data["parameter"], 0.1 * data[rounded], 3e4, "reduced, but the\nproduct rounded", "numeric", "below"
    )
    names = [name for name in SWEEPS if name.startswith("wave_numbers")]
    return Drawing(fig, _numbers(*names) | {"allowed": GENERAL_GRADIENT * UNIT}, data)


@figure
def stability_totals() -> Drawing:
    """All sweeps together: points, escapes, the largest error in responses; numbers only."""
    swept = [sweep(name) for name in SWEEPS]
    totals = {what: sum(getattr(each, what) for each in swept) for what in ("points", "escaped")}
    sharpness = np.median([each.sharpness for each in swept])
    values, largest = sum(len(each.parameter) for each in swept), max(each.in_responses() for each in swept)
    numbers = {"all": totals, "sweeps": len(swept), "sharpness": sharpness, "values": values, "in_responses": largest}
    return Drawing(numbers=numbers)
