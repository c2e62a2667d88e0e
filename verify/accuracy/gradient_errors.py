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


def errors_at(field: HeightField, at: Inputs) -> np.ndarray:
    """Return the errors of the algebraic gradient at image points in units of (1 + k) π k 2^-53.

    at: eye, radius, x, y, k_u, k_v. It is 0 where a crease is so near that its side is not certain.
    """
    true_factors = factors(field)
    reference = chain("from_image", angles_on_a, chart, gradient(field), outputs=(*true_factors.outputs, h_u, h_v))
    waves = [float(w.subs({k_u: at["k_u"], k_v: at["k_v"]})) for w in field.wave_numbers or ()]
    k = max(1.0, *map(abs, waves))
    algebraic = chain("image_gradient", angles_on_a, algebraic_gradient(field, at["k_u"], at["k_v"]))
    computed, true = in_float64(algebraic, at), in_balls(reference, at)
    off = np.maximum(*(distance(computed[name], true[name]) for name in SLOPES)) / (math.pi * k * UNIT) / (1 + k)
    if field.creases:
        sines = np.array([true[s.name] for s in (sin_u, sin_v)])
        off = np.where((abs(sines).astype(float) > ALGEBRAIC_GRADIENT * (1 + k) * UNIT).all(axis=0), off, 0.0)
    return off


def worst_at(ratios: np.ndarray, shares: np.ndarray, *waves: np.ndarray) -> np.ndarray:
    """Return the largest of `errors_at` for each R/e, ρ/ρ_s, k_u and k_v, of every field that has an algebraic form.

    Half of the points are moved toward the pole. The azimuth is random, of a third a multiple of π/64: of the creases
    of ridges. Wave numbers are rounded to those that have an algebraic form. The shape is that of the ratios.
    """
    rng, largest, eye = np.random.default_rng(SEED), np.zeros(ratios.shape), 1 / ratios
    toward_pole = 10.0 ** -np.where(rng.random(ratios.shape) < 0.5, rng.uniform(0, 140, ratios.shape), 0)
    angle = rng.uniform(-math.pi, math.pi, ratios.shape)
    angle = np.where(rng.random(ratios.shape) < 1 / 3, np.rint(angle * 64 / math.pi) * math.pi / 64, angle)
    rho = kernels.silhouette_of_a(eye, 1.0) * shares * toward_pole
    points = rho * np.cos(angle), rho * np.sin(angle)
    k = np.stack([2 * np.rint(waves[0] / 2), np.rint(waves[1])])
    for field, pair in product(OF_WAVES.values(), np.unique(k.reshape(2, -1), axis=1).T):
        here = (k == pair.reshape(2, *(1,) * ratios.ndim)).all(axis=0)
        at = dict(zip(("x", "y"), (axis[here] for axis in points), strict=True)) | {"eye": eye[here], "radius": 1.0}
        multiples = [float(wave.subs({k_u: 1, k_v: 1})) or 1 for wave in field.wave_numbers or ()]
        at |= dict(zip(("k_u", "k_v"), pair / multiples, strict=True))
        largest[here] = np.maximum(largest[here], errors_at(field, at))
    return largest
