"""The algebraic form of the exact gradient in float64 against balls, as a function of the image point.

Errors are counted in units of π max(1, |k|) 2^-53: that is the rounding of one number as large as the gradient can be.
The general form, of the chart point, over many wave numbers: `verify.stability.wave_numbers`.
"""

import math
from itertools import product

import numpy as np

from proofs.engine.program import chain
from proofs.formulas.camera import angles_on_a
from proofs.formulas.chart import chart
from proofs.formulas.height_fields import HeightField, gradient
from proofs.formulas.symbols import k_u, k_v
from verify.accuracy.differences import SLOPES
from verify.evaluate.arrays import distance, in_balls, in_float64
from verify.evaluate.programs import algebraic_gradient

UNIT, SEED, EACH = 2.0**-53, 12, 20
WAVE_NUMBERS = ((2.0, 1.0), (8.0, 4.0), (-8.0, 3.0), (64.0, 64.0), (0.0, 5.0))
RATIOS = (1e-6, 1e-3, 0.25, 0.5, 0.9, 1 - 1e-6, 1 - 1e-9)


def image_points(rng: np.random.Generator, eye: float, radius: float, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return image points with 1 − (ρ/ρ_s)² ≥ 0.1: spread over the disc, and toward the pole down to sin φ = 1e-150."""
    rim = eye * radius / math.sqrt((eye - radius) * (eye + radius))
    rho = rim * math.sqrt(0.9) * np.sqrt(rng.random(count)) * (1 - 1e-12)
    # Near the pole ρ = e R sin φ/(e − R cos φ), which is e R sin φ/(e − R) to first order.
    toward_pole = np.minimum(eye * radius * 10.0 ** rng.uniform(-149.9, -1, count) / (eye - radius), rho)
    rho = np.where((np.arange(count) % 2 == 0) & (toward_pole > 2e-150 * eye), toward_pole, rho)
    angle = rng.uniform(-math.pi, math.pi, count)
    return rho * np.cos(angle), rho * np.sin(angle)


def worst_at_image_points(field: HeightField) -> tuple[float, int]:
    """Return (the largest error of the algebraic gradient, in units of (1 + k) π k 2^-53, points) over R/e and k."""
    rng, found = np.random.default_rng(SEED), []
    whole = chain("from_image", angles_on_a, chart, gradient(field))
    multiples = [float(wave.subs({k_u: 1, k_v: 1})) for wave in field.wave_numbers or ()]  # 0: it does not depend on it
    for ratio, waves in product(RATIOS, WAVE_NUMBERS):
        at_u, at_v = (wave / (multiple or 1) for wave, multiple in zip(waves, multiples, strict=True))
        k = max(abs(wave) for wave, multiple in zip(waves, multiples, strict=True) if multiple)
        x, y = image_points(rng, 1 / ratio, 1.0, EACH)
        at = {"eye": 1 / ratio, "radius": 1.0, "x": x, "y": y, "k_u": at_u, "k_v": at_v}
        algebraic = chain("image_gradient", angles_on_a, algebraic_gradient(field, at_u, at_v))
        computed, true = in_float64(algebraic, at), in_balls(whole, at)
        off = max(distance(computed[name], true[name]).max() for name in SLOPES)
        found.append(off / (math.pi * max(1.0, k) * UNIT) / (1 + k))
    return float(np.max(found)), len(found) * EACH
