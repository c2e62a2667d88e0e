"""The exact gradient in float64 against balls: as a function of the chart point, and of the image point.

Errors are counted in units of π max(1, |k|) 2^-53: that is the rounding of one number as large as the gradient can be.
"""

import math
from collections.abc import Callable, Mapping, Sequence

import numpy as np

from proofs.engine.program import chain
from proofs.formulas.camera import angles_on_a
from proofs.formulas.chart import chart
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from renderer import Scene, exact, gradient_at
from verify.benchmark.methods.programs import algebraic_gradient, naive_gradient
from verify.evaluate.arrays import distance, in_balls, in_float64

UNIT, SMALLEST = 2.0**-53, 1e-280
GENERAL, ALGEBRAIC = 8.0, 8.0  # the bounds: 8, and 8 (1 + k)
RATIOS = (1e-6, 1e-3, 0.25, 0.5, 0.9, 1 - 1e-6, 1 - 1e-9)


def _largest(computed, exact, **wave_numbers):
    """Return the largest |computed − exact|/(π max(1, |k|) 2^-53) of h_u and h_v; NaN if a ball decides nothing."""
    units = {name: math.pi * max(1.0, abs(k)) * UNIT for name, k in wave_numbers.items()}
    return max(np.max(distance(computed[name], exact[name])) / unit for name, unit in units.items())


def wave_number_pairs(rng: np.random.Generator, count: int = 24) -> list[tuple[float, ...]]:
    """Return wave numbers of every kind up to 2^20 in magnitude: whole, real, negative, zero, the largest."""
    pairs: list[tuple[float, ...]]
    pairs = [(8.0, 4.0), (7.3, -3.1), (0.0, 5.0), (3.0, 0.0), (-64.0, 64.0), (2.0**20, -(2.0**20)), (0.25, 1e-5)]
    pairs += [tuple(float(s * 2.0**p) for s, p in zip(rng.choice([-1, 1], 2), rng.uniform(-3, 20, 2), strict=True))
              for _ in range(count)]  # fmt: skip
    return pairs + [tuple(float(k) for k in rng.integers(-(2**20), 2**20, 2)) for _ in range(count)]


def chart_points(rng: np.random.Generator, k_u: float, k_v: float, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return u ∈ [0, 1), v ∈ [0, 1]: at random, and floats beside m/k. None is so small that ku underflows."""
    u, v = rng.random(count), rng.random(count)
    half = count // 2
    for values, k in ((u, abs(k_u)), (v, abs(k_v))):
        if k >= 1:
            values[:half] = np.floor(rng.random(half) * k) / k
            values[:half] = np.nextafter(values[:half], rng.choice([0.0, 0.5, 1.0], half))
    u, v = (np.where(c < SMALLEST, 0.0, c) for c in (u, v))
    return np.minimum(u, np.nextafter(1, 0)), v


def by_the_renderer(field: str, at: Mapping) -> dict[str, np.ndarray]:
    """Return the general form of the exact gradient, {h_u, h_v: arrays}."""
    scene = Scene(field=field, ku=at["k_u"], kv=at["k_v"])
    return dict(zip(("h_u", "h_v"), gradient_at(scene, at["u"], at["v"], exact("general")), strict=True))


def by_rounded_products(field: str, at: Mapping) -> dict[str, np.ndarray]:
    """Return the same by libm's sine of a product πku, which is rounded before the sine."""
    return in_float64(naive_gradient(HEIGHT_FIELDS[field]), at)


def worst_at_chart_points(
    field: str, seed: int = 11, each: int = 16, form: Callable[[str, Mapping], dict] = by_the_renderer
) -> tuple[float, int]:
    """Return (the largest error of the general exact gradient in units, points) over all wave numbers."""
    rng, found = np.random.default_rng(seed), []
    for k_u, k_v in wave_number_pairs(rng):
        u, v = chart_points(rng, k_u, k_v, each)
        at = {"u": u, "v": v, "k_u": k_u, "k_v": k_v}
        found.append(_largest(form(field, at), in_balls(gradient(HEIGHT_FIELDS[field]), at), h_u=k_u, h_v=k_v))
    return float(np.max(found)), len(found) * each


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


def worst_at_image_points(
    field: str,
    seed: int = 12,
    each: int = 20,
    wave_numbers: Sequence[tuple[float, float]] = ((2, 1), (8, 4), (-8, 3), (64, 64), (0, 5)),
) -> tuple[float, int]:
    """Return (the largest error of the algebraic gradient, in units of (1 + k) π k 2^-53, points) over R/e and k."""
    rng, found = np.random.default_rng(seed), []
    whole = chain("from_image", angles_on_a, chart, gradient(HEIGHT_FIELDS[field]))
    for ratio in RATIOS:
        for k_u, k_v in wave_numbers:
            k_v = k_v / 2 if field == "rings" else k_v
            k = max(abs(k_u), abs(k_v)) if field != "rings" else 2 * abs(k_v)
            x, y = image_points(rng, 1 / ratio, 1.0, each)
            at = {"eye": 1 / ratio, "radius": 1.0, "x": x, "y": y, "k_u": k_u, "k_v": k_v}
            algebraic = chain("image_gradient", angles_on_a, algebraic_gradient(HEIGHT_FIELDS[field], k_u, k_v))
            found.append(_largest(in_float64(algebraic, at), in_balls(whole, at), h_u=k, h_v=k) / (1 + k))
    return float(np.max(found)), len(found) * each
