"""The algebraic form of the exact gradient in float64 against balls, as a function of the image point.

Errors are counted in units of π max(1, |k|) 2^-53: that is the rounding of one number as large as the gradient can be.
The general form, of the chart point, over many wave numbers: `verify.stability.wave_numbers`.
"""

import math
from itertools import product

import numpy as np

from proofs.engine.program import chain
from proofs.formulas.camera import angles_on_a
from proofs.formulas.certified import ALGEBRAIC_GRADIENT
from proofs.formulas.chart import chart
from proofs.formulas.height_fields import HEIGHT_FIELDS, HeightField, factors, gradient, sin_u, sin_v
from proofs.formulas.symbols import h_u, h_v, k_u, k_v
from renderer import kernels
from renderer.operations import UNIT
from verify.accuracy.differences import SLOPES
from verify.evaluate.arrays import Inputs, distance, in_balls, in_float64
from verify.evaluate.programs import algebraic_gradient

SEED = 12
OF_WAVES = {name: field for name, field in HEIGHT_FIELDS.items() if field.wave_numbers}
"""The fields that turn with one product of a wave number and a coordinate: of no other is a bound claimed."""


def image_points(rng: np.random.Generator, eye: float, radius: float, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return image points with 1 − (ρ/ρ_s)² ≥ 0.1: spread over the disc, and toward the pole down to sin φ = 1e-150.

    A third of them has an azimuth that is a multiple of π/64: of the creases of ridges.
    """
    rho = kernels.silhouette_of_a(eye, radius) * math.sqrt(0.9) * np.sqrt(rng.random(count)) * (1 - 1e-12)
    # Near the pole ρ = e R sin φ/(e − R cos φ), which is e R sin φ/(e − R) to first order.
    toward_pole = np.minimum(eye * radius * 10.0 ** rng.uniform(-149.9, -1, count) / (eye - radius), rho)
    rho = np.where((np.arange(count) % 2 == 0) & (toward_pole > 2e-150 * eye), toward_pole, rho)
    angle = rng.uniform(-math.pi, math.pi, count)
    angle = np.where(np.arange(count) % 3 == 0, np.rint(angle * 64 / math.pi) * math.pi / 64, angle)
    return rho * np.cos(angle), rho * np.sin(angle)


def errors_at(field: HeightField, at: Inputs, sides_certain: bool = True) -> np.ndarray:
    """Return the errors of the algebraic gradient at image points in units of (1 + k) π k 2^-53.

    at: eye, radius, x, y, k_u, k_v. sides_certain: 0 where a crease is so near that its side is not.
    """
    true_factors = factors(field)
    whole = chain("from_image", angles_on_a, chart, gradient(field), outputs=(*true_factors.outputs, h_u, h_v))
    waves = [float(w.subs({k_u: at["k_u"], k_v: at["k_v"]})) for w in field.wave_numbers or ()]
    k = max(1.0, *map(abs, waves))
    algebraic = chain("image_gradient", angles_on_a, algebraic_gradient(field, at["k_u"], at["k_v"]))
    computed, true = in_float64(algebraic, at), in_balls(whole, at)
    off = np.maximum(*(distance(computed[name], true[name]) for name in SLOPES)) / (math.pi * k * UNIT) / (1 + k)
    if field.creases and sides_certain:
        sines = np.array([true[s.name] for s in (sin_u, sin_v)])
        off = np.where((abs(sines).astype(float) > ALGEBRAIC_GRADIENT * (1 + k) * UNIT).all(axis=0), off, 0.0)
    return off


def worst_at(ratios: np.ndarray, shares: np.ndarray, *waves: np.ndarray) -> np.ndarray:
    """Return the largest of `errors_at` for each R/e, ρ/ρ_s, k_u and k_v, of every field that has an algebraic form.

    The azimuth is random, and wave numbers are rounded to those that have one. Of each also one of `image_points`. The
    shape is that of the ratios.
    """
    rng, found, eye = np.random.default_rng(SEED), np.zeros(ratios.shape), 1 / ratios
    rho, angle = kernels.silhouette_of_a(eye, 1.0) * shares, rng.uniform(-math.pi, math.pi, ratios.shape)
    given = np.array([rho * np.cos(angle), rho * np.sin(angle)])
    points = np.stack(
        [given, np.reshape([image_points(rng, e, 1.0, 1) for e in eye.flat], (-1, 2)).T.reshape(given.shape)], 1
    )
    k = np.stack([2 * np.rint(waves[0] / 2), np.rint(waves[1])])
    for field, pair in product(OF_WAVES.values(), np.unique(k.reshape(2, -1), axis=1).T):
        here = (k == pair.reshape(2, *(1,) * ratios.ndim)).all(axis=0)
        at = dict(zip(("x", "y"), points[..., here], strict=True)) | {"eye": eye[here], "radius": 1.0}
        multiples = [float(wave.subs({k_u: 1, k_v: 1})) or 1 for wave in field.wave_numbers or ()]
        at |= dict(zip(("k_u", "k_v"), pair / multiples, strict=True))
        found[here] = np.maximum(found[here], errors_at(field, at).max(axis=0))
    return found
