"""Toward the pole: the seed's tangent frame against ours, and the clamped difference."""

import numpy as np
from sympy import cos, sin, sqrt

from book.drawing.registry import Drawing, figure
from book.drawing.style import DASHED, curve, decades, plot
from proofs.engine.program import Program, chain
from proofs.formulas.bump import bumped_normal, g
from proofs.formulas.chart import chart
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from proofs.formulas.symbols import cos_phi, cos_theta, h_u, h_v, real, sin_phi, sin_theta
from proofs.formulas.tangent_frame import e_phi, e_theta, seed_frame, tangent_frame, unit_normal
from renderer import Scene, central, exact, gradient_at
from verify.accuracy.orders import fitted_slope
from verify.evaluate.arrays import distance, in_balls, in_float64
from verify.stability.geometry import SEED_FALLBACK

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
    index = np.abs(np.log(sines / SEED_FALLBACK)).argmin()
    numbers = {
        "seed_at_1e-4": plain[index],
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
