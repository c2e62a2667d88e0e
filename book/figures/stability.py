"""Stability under stress: each error against what is stressed, with the bound of every measured point."""

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import bound_style, decades, label_curve, label_line_end, palette, plot, slope_triangle
from verify.stability import symmetry
from verify.stability.rows import SWEEPS, sweep

LOWEST = 1e-18
SOLID, DASHED = (0, ()), (0, (5, 2))


def _draw(ax, seen, others=(), **labels):
    """Draw the bound, our error and the others' (name, dash); labels: where `bound` and `ours` are named."""
    blue, orange = palette()["symbolic"], palette()["numeric"]
    for name, dash in others:
        ax.plot(seen.parameter, seen.worst(name), color=orange, linewidth=1.5, linestyle=dash)
    ax.plot(seen.parameter, seen.worst_bound(), **bound_style())
    ax.plot(seen.parameter, np.maximum(seen.worst(), LOWEST), color=blue, linewidth=1.6)
    if "bound" in labels:
        label_curve(ax, seen.parameter, seen.worst_bound(), labels["bound"], "bound", palette()["bound"], side="above")
        label_curve(ax, seen.parameter, seen.worst(), labels["ours"], "ours", blue, side="below")


def _name(ax, seen, other, at, text, side, times=1):
    """Name the curve of another's error where the parameter is nearest to `at`."""
    label_curve(ax, seen.parameter, seen.worst(other), at, text, palette()["numeric"], side, times)


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
        numbers |= {f"{name}_{what}": getattr(seen, what) for what in ("points", "escaped", "undecided", "sharpness")}
        worst = {"worst": seen.worst().max()} | {other: np.nanmax(seen.worst(other)) for other in seen.others}
        numbers |= {f"{name}_{who.split(',')[0].replace(' ', '_')}": error for who, error in worst.items()}
    return numbers


@figure("stability_pole")
def stability_pole() -> Drawing:
    """The error of the tangent vector g against sin φ, from 0.84 to 1e-149: the seed's forms, ours, and our bound."""
    seen = sweep("pole")
    fig, ax = plot(height=4.2)
    _draw(ax, seen, (("seed", SOLID), ("seed with fallback", DASHED)), bound=1e-75, ours=1e-75)
    decades(ax, 25, 4, xlim=(1, 1e-150), ylim=(LOWEST, 1e4), xlabel="sin φ", ylabel="error of $g$")
    _name(ax, seen, "seed with fallback", 1e-60, "seed, with its fallback", "above")
    last = seen.parameter[np.isfinite(seen.worst("seed"))][-1]
    _name(ax, seen, "seed", last, "seed, without: here it divides by zero", "right")
    return Drawing(fig, numbers=_numbers("pole", "pole_general"), data=_data("pole"))


@figure("stability_silhouette")
def stability_silhouette() -> Drawing:
    """The error of the normal against the distance from the silhouette: ours, the seed's, and our bound."""
    seen = sweep("silhouette")
    fig, ax = plot(height=3.6)
    _draw(ax, seen, (("seed", DASHED),))
    decades(ax, 2, 2, xlim=(1, 1e-14), ylim=(1e-17, 1e-6), ylabel="error of $N$",
            xlabel=r"$s = 1 - (\rho/\rho_s)^2$")  # fmt: skip
    slope_triangle(ax, 1e-12, 3e-12, -0.5, "½", decades=2)
    curves = (("bound", seen.worst_bound(), "bound"), ("ours", seen.worst(), "symbolic"),
              ("seed", seen.worst("seed") / 2, "numeric"))  # fmt: skip
    for name, curve, role in curves:
        label_line_end(ax, seen.parameter[-1], curve[-1], name, palette()[role])
    scaled = seen.worst() * np.sqrt(seen.parameter) * 2.0**53
    return Drawing(fig, numbers=_numbers("silhouette") | {"in_roundings": scaled.max()}, data=_data("silhouette"))


@figure("stability_near_far")
def stability_near_far() -> Drawing:
    """The error of the normal from the nearest eye to the furthest: ours, the seed's, and our bound."""
    seen = sweep("near_to_far")
    fig, ax = plot(height=3.6)
    _draw(ax, seen, (("seed", DASHED),), bound=1e-3, ours=1e-3)
    decades(ax, 3, 2, ylim=(1e-17, 1e-8), ylabel="error of $N$",
            xlabel="$e/R - 1$: the eye's height above the sphere, in radii")  # fmt: skip
    _name(ax, seen, "seed", 1e-6, "seed", "above")
    return Drawing(fig, numbers=_numbers("near_to_far"), data=_data("near_to_far"))


@figure("stability_wave_numbers")
def stability_wave_numbers() -> Drawing:
    """The error of the gradient over π max(1, |k|) against |k| up to 2^20, with two other ways to take the argument."""
    seen = sweep("wave_numbers")
    naive, rounded = seen.others
    fig, ax = plot(height=3.9)
    _draw(ax, seen, ((naive, SOLID), (rounded, DASHED)), bound=1e5, ours=1e5)
    decades(ax, 1, 2, ylim=(1e-17, 1e-8), xlabel="$|k|$", ylabel=r"error / $\pi\,\max(1, |k|)$")
    _name(ax, seen, naive, 1e3, "libm, argument rounded", "left")
    _name(ax, seen, rounded, 3e4, "reduced, but the\nproduct rounded", "below", times=0.1)
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
        middle = seen.parameter[len(seen.parameter) // 2]
        _draw(ax, seen, bound=middle, ours=middle)
        decades(ax, every, 4, ylim=limits, xlabel=across, title=up)
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
