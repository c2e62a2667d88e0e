"""The difference where no field is smooth: at a crease, over all of them (the √ε law of ridges), and at the pole."""

import numpy as np
from sympy import cos, sin, sqrt

from book.drawing.registry import Drawing, figure
from book.drawing.style import (
    DASHED,
    SHORT,
    SOLID,
    colour_of,
    curve,
    decades,
    dots,
    label_line_end,
    plot,
    slope_triangle,
)
from book.figures.chapter_scene import SCENE, numeric, symbolic
from proofs.engine.program import Program, chain
from proofs.engine.vectors import real
from proofs.formulas.bump import bumped_normal, g
from proofs.formulas.chart import chart
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from proofs.formulas.symbols import cos_phi, cos_theta, h_u, h_v, sin_phi, sin_theta
from proofs.formulas.tangent_frame import e_phi, e_theta, seed_frame, tangent_frame, unit_normal
from renderer import Scene, central, exact, gradient_at
from renderer.picture.facts import crease_contrast
from verify.accuracy import orders
from verify.accuracy.orders import SLOPES, fitted_slope, on_the_raster, predicted, quadrature
from verify.evaluate.arrays import distance, in_balls, in_float64
from verify.stability.geometry import SEED_FALLBACK

CREASE, ROW = 0.125, 0.47


def _slope(offsets, method):
    """Return h_u of ridges at these distances from the crease u = 1/8."""
    return gradient_at(SCENE, CREASE + offsets, ROW, method)[0]


@figure
def crease() -> Drawing:
    """h_u of ridges across the crease u = 1/8: exact, and by central differences of three steps."""
    offsets = np.linspace(-0.03, 0.03, 601)
    exact_slope = _slope(offsets, exact())
    fig, ax = plot(height=3.6)
    data = {"offset": offsets, "exact": exact_slope}
    for side, text in ((offsets < 0, ""), (offsets > 0, "exact")):
        curve(ax, offsets[side], exact_slope[side], "symbolic", text, linewidth=2.2)
    curve(ax, 0, 0, "symbolic", marker="o", markersize=5)
    for eps, dash, text in ((0.02, SOLID, "ε = 0.02"), (0.01, DASHED, "0.01"), (0.004, SHORT, "0.004")):
        data[f"central_{eps:g}"] = slope = _slope(offsets, central(eps))
        curve(ax, offsets, slope, "numeric", linewidth=1.3, linestyle=dash)
        corner = np.searchsorted(offsets, eps)
        label_line_end(ax, offsets[corner], slope[corner], text, "numeric", "above")
    ax.axhline(0, color=colour_of("grid"), linewidth=0.8, zorder=0)
    ax.set(ylim=(-11, 11), xlabel="distance δ from the crease, in $u$", ylabel="$h_u$")
    on_kink, off_kink = crease_contrast(numeric(eps=1e-3), symbolic())
    numbers = {"jump": exact_slope[offsets > 0][0] - exact_slope[offsets < 0][-1]}
    for name, method in (("exact", exact()), ("central", central(1e-4))):
        at, beside = _slope(np.array([0, 1e-6]), method)
        numbers[name] = {"at": at + 0.0, "beside": beside}  # −0 is 0
    numbers |= {"float_sine": np.sin(np.pi * SCENE.ku * CREASE), "mean_on": on_kink, "mean_off": off_kink}
    return Drawing(fig, numbers | {"orders": np.log10(on_kink / off_kink)}, data)


STEPS = np.logspace(-2, -8, 25)
FITTED = STEPS < 2e-3


@figure
def ridge_law() -> Drawing:
    """RMS error of the central difference of ridges against ε: over the chart, the theorem's law, and on the raster."""
    law = {name: np.array([quadrature(name, float(step)) for step in STEPS]) for name in SLOPES}
    raster = np.array([on_the_raster("h_u", float(step), symbolic()) for step in STEPS])
    fig, ax = plot(height=3.9)
    for name, marker, side, times in (("h_u", "o", "above", 2), ("h_v", "s", "below", 0.5)):
        curve(ax, STEPS, predicted(name, STEPS)[0], "bound")
        dots(ax, STEPS, law[name], "difference", 3.6, marker)
        label_line_end(ax, STEPS[12], law[name][12] * times, f"chart, ${name}$", "difference", side)
    curve(ax, STEPS, raster, "numeric", "raster, $h_u$", "above", linewidth=1.3)
    decades(ax, 2, 2, ylim=(1e-9, 1e2), xlabel="step ε", ylabel="RMS error of the slope")
    slope_triangle(ax, 3e-8, 2e-4, 0.5)
    numbers, data = {}, {"step": STEPS, "raster_h_u": raster}
    for name, values in law.items():
        right, room = predicted(name, STEPS)
        if (np.abs(values - right) > room + 1e-9).any():
            raise ValueError(f"the RMS of {name} is further from the theorem's than the theorem allows")
        data |= {f"chart_{name}": values, f"law_{name}": right, f"law_{name}_room": room}
        numbers[f"{name}_slope"] = fitted_slope(STEPS[FITTED], values[FITTED])
        numbers[f"{name}_constant"] = (values / right)[FITTED].max()
    return Drawing(fig, numbers, data)


@figure("clamped_order")
def clamped_order_figure() -> Drawing:
    """The error of the difference clamped at the pole, v = ε/2: the chapter's fields, and one that is not odd."""
    fig, ax = plot(height=3.4)
    steps, errors = orders.STEPS, {field: orders.clamped_errors(field) for field in orders.FIELDS}
    for field, text, marker, role in (
        ("sine", "sine, ridges", "o", "symbolic"),
        ("ridges", "", "x", "symbolic"),
        ("rings", "rings", "s", "symbolic"),
        ("cosine", "cos $πk_vv$", "D", "numeric"),
    ):
        curve(ax, steps, errors[field], role, text, marker=marker, markersize=4, linewidth=0.9)
    decades(ax, xlabel="step ε", ylabel="error of $h_v$")
    slope_triangle(ax, 3e-5, 3e-8, 2)
    slope_triangle(ax, 3e-5, 8e-4, 1)
    fitted = {field: fitted_slope(steps, values) for field, values in errors.items()}
    return Drawing(fig, fitted, {"step": steps, **errors})


AZIMUTHS = np.linspace(-3.0, 3.0, 25)
_azimuth, _around = real("azimuth"), (cos_theta, sin_theta, cos_phi)
_angles = Program(
    "angles",
    (_azimuth, sin_phi),
    tuple(zip(_around, (cos(_azimuth), sin(_azimuth), sqrt(1 - sin_phi**2)), strict=True)),
    _around,
)
_known = (*_around, h_u, h_v, *g)
_exact = chain("g", _angles, chart, gradient(HEIGHT_FIELDS["sine"]), bumped_normal, outputs=_known).keep(*_known)
"""From the azimuth and sin φ: the angles, h_u, h_v and g = h_u e_θ + h_v e_φ."""


def _errors(sines):
    """Return the largest errors of g over the azimuths at each sin φ: seed's frame, with its fallback, ours.

    NaN where the frame divides by zero.
    """
    at = {"azimuth": AZIMUTHS, "sin_phi": sines[:, None], "k_u": 8, "k_v": 4}
    right = in_balls(_exact, at)
    given = at | {name: balls.astype(float) for name, balls in right.items()}

    def along(frame):
        return [
            given["h_u"] * frame[t.name] + given["h_v"] * frame[p.name] for t, p in zip(e_theta, e_phi, strict=True)
        ]

    with np.errstate(invalid="ignore"):
        plain = along(in_float64(seed_frame, in_float64(unit_normal, given)))
    fallback = np.broadcast_arrays(given["h_u"], given["h_v"], 0.0)
    guarded = np.where(at["sin_phi"] > SEED_FALLBACK, plain, fallback)
    vectors = plain, guarded, along(in_float64(tangent_frame, given))
    off = [np.max([distance(part, right[s.name]) for s, part in zip(g, v, strict=True)], axis=(0, 2)) for v in vectors]
    return np.where(np.isfinite(off), off, np.nan)


@figure
def pole() -> Drawing:
    """The largest error of g near the pole: the seed's frame, with and without its fallback, and the stable one."""
    sines = np.logspace(0, -8, 49)[1:]
    plain, guarded, stable = _errors(sines)
    fig, ax = plot(height=3.8)
    away, there = sines[30], sines[22]
    curve(ax, sines, guarded, "numeric", "seed, with its fallback", "above", away, linewidth=1.4, linestyle=DASHED)
    curve(ax, sines, plain, "numeric", "seed's frame", "left", there, linewidth=1.6)
    curve(ax, sines, stable, "symbolic", "stable frame", "above", away, linewidth=1.8)
    decades(ax, 2, 4, xlim=(1, 1e-9), ylim=(1e-18, 1e4), xlabel="sin φ", ylabel="error of $g$")
    numbers = {
        "fallback_worst": guarded.max(),
        "seed_worst": np.nanmax(plain),
        "stable_worst": stable.max(),
        "points": len(sines) * len(AZIMUTHS),
    }
    data = {"sin_phi": sines, "seed": plain, "seed_with_fallback": guarded, "stable": stable}
    return Drawing(fig, numbers | _clamped_slopes(), data)


def _clamped_slopes():
    """Return the fitted orders of the clamped difference of h_v at fixed v/ε = 1/2, and in the interior."""
    steps, scene = np.logspace(-2, -4, 9), Scene(field="sine")

    def order(places):
        pairs = zip(steps, places, strict=True)
        slopes = [[gradient_at(scene, 0.31, v, method)[1] for method in (central(eps), exact())] for eps, v in pairs]
        return fitted_slope(steps, np.abs(np.subtract(*np.transpose(slopes))))

    return {"clamped_order": order(steps / 2), "interior_order": order(np.full(9, 0.3))}
