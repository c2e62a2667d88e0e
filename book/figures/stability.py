"""Stability under stress: each error against what is stressed, with the bound of every measured point."""

import re

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import DASHED, SOLID, curve, decades, label_curve, plot
from proofs.formulas.certified import GENERAL_GRADIENT
from proofs.formulas.step_bounds import TERMS
from renderer import Scene, render
from renderer.operations import UNIT
from verify.accuracy.step_terms import BOUNDS
from verify.stability.geometry import toward_the_pole
from verify.stability.rows import SWEEPS, sweep

LOWEST = 1e-18


def _draw(ax, swept, others, at):
    """Draw a sweep's bound and our error, named at a place, and the others' errors: [(name, text, side, at, dash)]."""
    for other, text, side, there, dash in others:
        look = {"label": other, "linewidth": 1.5, "linestyle": dash}
        curve(ax, swept.parameter, swept.worst(other), "numeric", text, side, there, **look)
    curve(ax, swept.parameter, swept.bounds.max(axis=1), "bound", "bound", "above", at)
    curve(ax, swept.parameter, np.maximum(swept.worst(), LOWEST), "symbolic", "ours", "below", at, linewidth=1.6)


def _numbers(**swept):
    """Return the numbers of sweeps: points, escapes, the largest error of ours and of others."""
    numbers = {}
    for name, each in swept.items():
        largest = {other: np.nanmax(each.worst(other)) for other in each.others}
        numbers[name] = {"points": each.points, "escaped": each.escaped, "worst": each.worst().max()}
        numbers[name] |= {other.split(",")[0].replace(" ", "_"): error for other, error in largest.items()}
    return numbers


@figure
def pole() -> Drawing:
    """The error of the tangent vector g near the pole: the seed's frame, with and without its fallback, and ours."""
    fig, ax = plot(height=3.8)
    near, far = toward_the_pole(sines=np.logspace(-0.08, -9, 48)), sweep("pole")
    others = (
        ("seed", "seed's frame", "left", 1e-3, SOLID),
        ("seed with fallback", "seed, with its fallback", "above", 1e-7, DASHED),
    )
    _draw(ax, near, others, 1e-3)
    decades(ax, 2, 4, xlim=(1, 1e-9), ylim=(LOWEST, 1e4), xlabel="sin φ", ylabel="error of $g$")
    return Drawing(fig, _numbers(near=near, far=far, far_general=sweep("pole_general")))


@figure
def stability_silhouette() -> Drawing:
    """The error of the normal towards the silhouette, and from the nearest eye to the furthest; numbers only."""
    swept = sweep("silhouette")
    scaled = swept.worst() * np.sqrt(swept.parameter) * 2.0**53
    numbers = _numbers(silhouette=swept, near_to_far=sweep("near_to_far"))
    return Drawing(numbers=numbers | {"in_roundings": scaled.max()})


@figure
def stability_wave_numbers() -> Drawing:
    """The error of the gradient over π max(1, |k|) against |k| up to 2^20, with two other ways to take the argument."""
    swept = {name: sweep(name) for name in SWEEPS if name.startswith("wave_numbers")}
    naive, rounded = (sine := swept["wave_numbers_sine"]).others
    fig, ax = plot(height=3.9)
    others = (naive, "libm, argument rounded", "left", 1e3, SOLID), (rounded, "", "", None, DASHED)
    _draw(ax, sine, others, 1e5)
    decades(ax, 1, 2, ylim=(1e-17, 1e-8), xlabel="$|k|$", ylabel=r"error / $\pi\,\max(1, |k|)$")
    below = "reduced, but the\nproduct rounded", "numeric", "below"
    label_curve(ax, sine.parameter, 0.1 * sine.worst(rounded), 3e4, *below)
    return Drawing(fig, _numbers(**swept) | {"allowed": GENERAL_GRADIENT * UNIT})


@figure
def stability_totals() -> Drawing:
    """All sweeps together: points, escapes, the largest error in responses; numbers only."""
    swept = [sweep(name) for name in SWEEPS]
    totals = {count: sum(getattr(each, count) for each in swept) for count in ("points", "escaped")}
    sharpness = np.median([each.sharpness for each in swept])
    values, largest = sum(len(each.parameter) for each in swept), max(each.in_responses() for each in swept)
    numbers = {"all": totals, "sweeps": len(swept), "sharpness": sharpness, "values": values, "in_responses": largest}
    return Drawing(numbers=numbers)


@figure("attribution")
def shares_of_terms() -> Drawing:
    """The shares of sphere A on which each term's proved bound is the largest, at three steps; numbers only."""
    scene, numbers = Scene(), {}
    u, v, *_ = render(scene, 88, 88).data_on_a.values()
    for eps in (3e-2, 1e-6, 1e-8):
        with np.errstate(all="ignore"):  # a selection computes both of its sides
            _, leading, *_ = BOUNDS[scene.field, "central"](u, v, scene.ku, scene.kv, eps)
        shares = {term: np.mean(leading == number) for number, term in enumerate(TERMS, 1)}
        numbers |= {f"{re.sub('[ -]', '_', term)}_{eps:.0e}": share for term, share in shares.items()}
    return Drawing(numbers=numbers | {"pixels": u.size})
