"""The exact gradient in float64 against balls: what draws, of the chart point; its algebraic form, of the image point.

Errors are counted in units of π max(1, |k|) 2^-53: that is the rounding of one number as large as the gradient can be.
The gradient's program, of the chart point, over many wave numbers: `verify.stability.wave_numbers`.
"""

import math

import numpy as np

from proofs.engine.program import chain
from proofs.formulas.camera import angles_on_a
from proofs.formulas.chart import chart
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from renderer import Scene, exact, gradient_at
from verify.evaluate.arrays import distance, in_balls, in_float64
from verify.evaluate.programs import algebraic_gradient
from verify.stability.wave_numbers import points_of_the_chart

UNIT, SEED, EACH = 2.0**-53, 12, 20
PAIRS = ((8.0, 4.0), (7.3, -3.1), (0.0, 5.0), (3.0, 0.0), (-64.0, 64.0), (2.0**20, -(2.0**20)), (0.25, 1e-5))
WAVE_NUMBERS = ((2.0, 1.0), (8.0, 4.0), (-8.0, 3.0), (64.0, 64.0), (0.0, 5.0))
RATIOS = (1e-6, 1e-3, 0.25, 0.5, 0.9, 1 - 1e-6, 1 - 1e-9)


def worst_of_the_renderer(field: str, seed: int = 11, each: int = 64) -> tuple[float, int]:
    """Return (the largest error of the general gradient that draws, in units, points) where k_u and k_v differ."""
    rng, found = np.random.default_rng(seed), []
    for wave_u, wave_v in PAIRS:
        (u,), _ = points_of_the_chart(np.array([wave_u]), each, rng)
        _, (v,) = points_of_the_chart(np.array([wave_v]), each, rng)
        drawn = gradient_at(Scene(field=field, ku=wave_u, kv=wave_v), u, v, exact("general"))
        true = in_balls(gradient(HEIGHT_FIELDS[field]), {"u": u, "v": v, "k_u": wave_u, "k_v": wave_v})
        for name, slope, k in zip(("h_u", "h_v"), drawn, (wave_u, wave_v), strict=True):
            found.append(distance(slope, true[name]).max() / (math.pi * max(1.0, abs(k)) * UNIT))
    return float(np.max(found)), len(PAIRS) * each


def image_points(rng: np.random.Generator, eye: float, radius: float, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return image points with 1 − (ρ/ρ_s)² ≥ 0.1: spread over the disc, and toward the pole down to sin φ = 1e-150."""
    rim = eye * radius / math.sqrt((eye - radius) * (eye + radius))
    rho = rim * math.sqrt(0.9) * np.sqrt(rng.random(count)) * (1 - 1e-12)
    near = np.arange(count) % 2 == 0
    # Near the pole ρ = e R sin φ/(e − R cos φ), which is e R sin φ/(e − R) to first order.
    sines = 10.0 ** rng.uniform(-149.9, -1, count)
    toward_pole = np.minimum(eye * radius * sines / (eye - radius), rho)
    rho = np.where(near & (toward_pole > 2e-150 * eye), toward_pole, rho)
    angle = rng.uniform(-math.pi, math.pi, count)
    return rho * np.cos(angle), rho * np.sin(angle)


def worst_at_image_points(field: str) -> tuple[float, int]:
    """Return (the largest error of the algebraic gradient, in units of (1 + k) π k 2^-53, points) over R/e and k."""
    rng, found = np.random.default_rng(SEED), []
    whole = chain("from_image", angles_on_a, chart, gradient(HEIGHT_FIELDS[field]))
    for ratio in RATIOS:
        for k_u, k_v in WAVE_NUMBERS:
            k_v = k_v / 2 if field == "rings" else k_v
            k = max(abs(k_u), abs(k_v)) if field != "rings" else 2 * abs(k_v)
            x, y = image_points(rng, 1 / ratio, 1.0, EACH)
            at = {"eye": 1 / ratio, "radius": 1.0, "x": x, "y": y, "k_u": k_u, "k_v": k_v}
            algebraic = chain("image_gradient", angles_on_a, algebraic_gradient(HEIGHT_FIELDS[field], k_u, k_v))
            computed, exact = in_float64(algebraic, at), in_balls(whole, at)
            off = max(distance(computed[name], exact[name]).max() for name in ("h_u", "h_v"))
            found.append(off / (math.pi * max(1.0, k) * UNIT) / (1 + k))
    return float(np.max(found)), len(found) * EACH
