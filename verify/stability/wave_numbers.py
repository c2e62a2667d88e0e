"""Wave numbers: small, large to 2²⁰, negative, zero, not whole; the gradient as a function of float64 (u, v)."""

from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from verify.evaluate.arrays import in_float64
from verify.evaluate.programs import naive, rounded_product_gradient
from verify.stability.sweep import Sweep, measured

SEED, LARGEST = 4, 2.0**20
LEAST = 1e-150  # the chart's smallest v off the pole; far below it the product of two sines underflows
UNEQUAL = (8.0, 4.0), (7.3, -3.1), (0.0, 5.0), (3.0, 0.0), (-64.0, 64.0), (LARGEST, -LARGEST), (0.25, 1e-5)
EDGES = *((k, k) for k in (0.0, 5e-324, 1e-300, LARGEST, -LARGEST)), *UNEQUAL


def wave_numbers(values: int, random: np.random.Generator) -> np.ndarray:
    """Return k between 10⁻³ and 2²⁰ evenly by ratio; from 1 on every third one is whole, and about half negative."""
    k = np.geomspace(1e-3, LARGEST - 0.3, values)
    integers = (np.arange(values) % 3 == 0) & (k >= 1)
    k[integers] = np.rint(k[integers])
    return np.where(random.random(values) < 0.5, -k, k)


def points_of_the_chart(waves: np.ndarray, samples: int, random: np.random.Generator) -> np.ndarray:
    """Return (u, v) for pairs (k_u, k_v), (2, values) each: half at random, half next to a crease m/k, where a rounded
    product is worst.
    """
    at, half = random.uniform(0, 1, (*waves.shape, samples)), samples // 2
    k = waves[..., None]
    nearest = np.rint(at[..., :half] * k) / np.where(k == 0, 1, k)
    at[..., :half] = np.clip(np.nextafter(nearest, at[..., :half]), LEAST, np.nextafter(1, 0))
    return at


def large_wave_numbers(field: str, pairs: ArrayLike | None = None, samples: int = 24) -> Sweep:
    """Sweep the error of (h_u, h_v) over π max(1, |k|) against |k_u|, of pairs; by default equal `wave_numbers`.

    Reason of the bound: the product k·u is exact as a pair, the reduction is exact, so what is left is the error of
    two factors and of two products, each a few roundings of a number below π|k|: independent of k.
    """
    random = np.random.default_rng(SEED)
    waves = np.broadcast_to(wave_numbers(74, random), (2, 74)) if pairs is None else np.array(pairs).T
    inputs = dict(zip(("u", "v"), points_of_the_chart(waves, samples, random), strict=True))
    inputs |= dict(zip(("k_u", "k_v"), waves[..., None], strict=True))
    height_field = HEIGHT_FIELDS[field]
    scales = dict(zip(("h_u", "h_v"), np.pi * np.maximum(1, np.abs(waves))[..., None], strict=True))
    others = {
        "libm, rounded argument": in_float64(naive(gradient(height_field)), inputs),
        "reduced, rounded product": in_float64(rounded_product_gradient(height_field), inputs),
    }
    return measured(np.abs(waves[0]), gradient(height_field), inputs, None, scales, others, partial(np.max, axis=0))
