"""Stability under stress: each error against what is stressed, with the bound of every measured point."""

import json
from pathlib import Path

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import bound_style, decades, label_line_end, palette, plot, readable, slope_triangle
from verify.stability import symmetry
from verify.stability.rows import SWEEPS, sweep

LOWEST = 1e-18


def _draw(ax, seen, others=(), end=-1):
    """Draw the bound, our error and the others' (name, dash), and return our colour."""
    blue, orange = palette()["symbolic"], palette()["numeric"]
    for name, dash in others:
        ax.plot(seen.parameter, seen.worst(name), color=orange, linewidth=1.5, linestyle=dash)
    ax.plot(seen.parameter, seen.worst_bound(), **bound_style())
    ax.plot(seen.parameter, np.maximum(seen.worst(), LOWEST), color=blue, linewidth=1.6)
    return readable(blue), readable(orange), readable(palette()["bound"])


def _at(seen, value):
    """Return the index of the parameter nearest to a value, by ratio."""
    return int(np.abs(np.log(seen.parameter / value)).argmin())


def _data(*names):
    """Return the curves of sweeps by name: the parameter, our error, the bound, the others' errors."""
    data = {}
    for name in names:
        seen = sweep(name)
        front = f"{name}_" if len(names) > 1 else ""
        data |= {f"{front}parameter": seen.parameter, f"{front}ours": np.maximum(seen.worst(), LOWEST)}
        data |= {f"{front}bound": seen.worst_bound()} | {f"{front}{other}": seen.worst(other) for other in seen.others}
    return data


def _numbers(*names):
    """Return the numbers of sweeps: points, escapes, undecided, sharpness, the worst of ours and of the others."""
    numbers = {}
    for name in names:
        seen = sweep(name)
        numbers |= {
            f"{name}_points": seen.points,
            f"{name}_escaped": seen.escaped,
            f"{name}_undecided": seen.undecided,
            f"{name}_sharpness": seen.sharpness,
            f"{name}_worst": seen.worst().max(),
        }
        numbers |= {
            f"{name}_{other.split(',')[0].replace(' ', '_')}": np.nanmax(seen.worst(other)) for other in seen.others
        }
    return numbers


@figure("stability_pole")
def stability_pole() -> Drawing:
    """The error of the tangent vector g against sin φ, from 0.84 to 1e-149: the seed's forms, ours, and our bound."""
    seen = sweep("pole")
    fig, ax = plot(height=4.2)
    blue, orange, ink = _draw(ax, seen, (("seed", (0, ())), ("seed with fallback", (0, (5, 2)))))
    decades(ax, "x", every=25)
    decades(ax, "y", every=4)
    ax.set_xlim(1, 1e-150)
    ax.set_ylim(LOWEST, 1e4)
    ax.set_xlabel("sin φ")
    ax.set_ylabel("error of $g$")
    label_line_end(
        ax, 1e-60, seen.worst("seed with fallback")[_at(seen, 1e-60)], "seed, with its fallback", orange, side="above"
    )
    last = np.flatnonzero(np.isfinite(seen.worst("seed")))[-1]
    label_line_end(ax, seen.parameter[last], seen.worst("seed")[last], "seed, without: here it divides by zero", orange)
    label_line_end(ax, 1e-75, seen.worst_bound()[_at(seen, 1e-75)], "bound", ink, side="above")
    label_line_end(ax, 1e-75, seen.worst()[_at(seen, 1e-75)], "ours", blue, side="below")
    return Drawing(fig, numbers=_numbers("pole", "pole_general"), data=_data("pole"))


@figure("stability_silhouette")
def stability_silhouette() -> Drawing:
    """The error of the normal against the distance from the silhouette: ours, the seed's, and our bound."""
    seen = sweep("silhouette")
    fig, ax = plot(height=3.6)
    blue, orange, ink = _draw(ax, seen, (("seed", (0, (5, 2))),))
    decades(ax, "both", every=2)
    ax.set_xlim(1, 1e-14)
    ax.set_ylim(1e-17, 1e-6)
    ax.set_xlabel(r"$s = 1 - (\rho/\rho_s)^2$")
    ax.set_ylabel("error of $N$")
    slope_triangle(ax, 1e-12, 3e-12, -0.5, "½", decades=2)
    curves = (
        ("bound", seen.worst_bound(), ink),
        ("ours", seen.worst(), blue),
        ("seed", seen.worst("seed") / 2, orange),
    )
    for name, curve, colour in curves:
        label_line_end(ax, seen.parameter[-1], curve[-1], name, colour)
    scaled = seen.worst() * np.sqrt(seen.parameter) * 2.0**53
    return Drawing(fig, numbers=_numbers("silhouette") | {"in_roundings": scaled.max()}, data=_data("silhouette"))


@figure("stability_near_far")
def stability_near_far() -> Drawing:
    """The error of the normal from the nearest eye to the furthest: ours, the seed's, and our bound."""
    seen = sweep("near_to_far")
    fig, ax = plot(height=3.6)
    blue, orange, ink = _draw(ax, seen, (("seed", (0, (5, 2))),))
    decades(ax, "x", every=3)
    decades(ax, "y", every=2)
    ax.set_ylim(1e-17, 1e-8)
    ax.set_xlabel("$e/R - 1$: the eye's height above the sphere, in radii")
    ax.set_ylabel("error of $N$")
    label_line_end(ax, 1e-6, seen.worst("seed")[_at(seen, 1e-6)], "seed", orange, side="above")
    label_line_end(ax, 1e-3, seen.worst_bound()[_at(seen, 1e-3)], "bound", ink, side="above")
    label_line_end(ax, 1e-3, seen.worst()[_at(seen, 1e-3)], "ours", blue, side="below")
    return Drawing(fig, numbers=_numbers("near_to_far"), data=_data("near_to_far"))


@figure("stability_wave_numbers")
def stability_wave_numbers() -> Drawing:
    """The error of the gradient over π max(1, |k|) against |k| up to 2^20, with two other ways to take the argument."""
    seen = sweep("wave_numbers")
    naive, rounded = seen.others
    fig, ax = plot(height=3.9)
    blue, orange, ink = _draw(ax, seen, ((naive, (0, ())), (rounded, (0, (5, 2)))))
    decades(ax, "x", every=1)
    decades(ax, "y", every=2)
    ax.set_ylim(1e-17, 1e-8)
    ax.set_xlabel("$|k|$")
    ax.set_ylabel(r"error / $\pi\,\max(1, |k|)$")
    label_line_end(ax, 1e3, seen.worst(naive)[_at(seen, 1e3)], "libm, argument rounded", orange, side="left")
    label_line_end(
        ax, 3e4, seen.worst(rounded)[_at(seen, 3e4)] / 10, "reduced, but the\nproduct rounded", orange, side="below"
    )
    label_line_end(ax, 10, seen.worst_bound()[_at(seen, 10)], "bound", ink, side="above")
    label_line_end(ax, 10, seen.worst()[_at(seen, 10)], "ours", blue, side="below")
    names = [name for name in SWEEPS if name.startswith("wave_numbers")]
    return Drawing(fig, numbers=_numbers(*names) | {"allowed": 8 * 2.0**-53}, data=_data("wave_numbers"))


_SHADING = {  # sweep: (x label, y label, every how many decades, limits of y)
    "amplitude": (r"amplitude $|\beta|$", "error of $N\u2032$", 100, (1e-18, 1e-13)),
    "light_distance": ("light's distance, in radii", r"error of $\mu$", 6, (1e-18, 1e-5)),
    "opposite_light": (r"$|\omega + \hat v|$", "error of the base", 4, (1e-18, 1e2)),
    "shininess": ("shininess $p$", "error of base$^p$", 3, (1e-18, 1e-8)),
}


@figure("stability_shading")
def stability_shading() -> Drawing:
    """Four errors of the shading with their bounds: against β, the light's distance, |ω + v|, the shininess."""
    fig, axes = plot(height=5.4, nrows=2, ncols=2)
    for ax, (name, (across, up, every, limits)) in zip(axes.flat, _SHADING.items(), strict=True):
        seen = sweep(name)
        blue, _, ink = _draw(ax, seen)
        decades(ax, "x", every=every)
        decades(ax, "y", every=4)
        ax.set_ylim(*limits)
        ax.set_xlabel(across)
        ax.set_title(up)
        middle = len(seen.parameter) // 2
        label_line_end(ax, seen.parameter[middle], seen.worst_bound()[middle], "bound", ink, side="above")
        label_line_end(ax, seen.parameter[middle], seen.worst()[middle], "ours", blue, side="below")
    return Drawing(fig, numbers=_numbers(*_SHADING, "opposite_light_phong"), data=_data(*_SHADING))


@figure("stability_symmetry")
def stability_symmetry() -> Drawing:
    """How far mirrored and turned scenes, and permuted lights, change the picture; numbers only."""
    found = [symmetry.difference(scene, move) for scene in symmetry.SCENES.values() for move in symmetry.MOVES]
    numbers = {"pictures": len(found), "largest": max(f[0] for f in found), "flips": sum(f[2] for f in found)}
    numbers |= {"size": symmetry.SIZE, "creased": max(f[1] for f in found), "bound": 1e-13}
    return Drawing(numbers=numbers | {"permuted": symmetry.permuted_lights(symmetry.FIVE_LIGHTS)})


@figure("stability_totals")
def stability_totals() -> Drawing:
    """All sweeps together: points, escapes, undecided; numbers only."""
    seen = [sweep(name) for name in SWEEPS]
    numbers = {f"all_{what}": sum(getattr(s, what) for s in seen) for what in ("points", "escaped", "undecided")}
    return Drawing(numbers=numbers | {"sweeps": len(seen), "sharpness": float(np.median([s.sharpness for s in seen]))})


RESULT = "verify/results/accepted_scenes.json"


@figure("accepted_scenes", data=[RESULT])
def accepted_scenes() -> Drawing:
    """The committed long run over random accepted scenes: its counts and its label; numbers only."""
    result = json.loads((Path(__file__).resolve().parents[2] / RESULT).read_text(encoding="utf-8"))
    label = {key: result["label"][key] for key in ("processor", "python", "date", "commit")}
    return Drawing(numbers=result["numbers"] | label)
