"""The wall: a height field that is sampled into texels, interpolated, and differentiated exactly, as interpolation.

The table covers u ∈ [0, 1) and v ∈ [0, 2), one period of the formula in either, so that no end condition enters.
"""

from collections.abc import Callable, Sequence

import numpy as np

from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient, height
from renderer.picture.sweep import rms
from verify.evaluate.arrays import in_float64

KU, KV = 8.0, 4.0
POINTS, SEED = 10_000, 8
TEXELS = (33, 65, 129, 257, 513)  # odd, so that creases lie inside texels, as they do in a picture

Pair = tuple[np.ndarray, np.ndarray]
Weights = tuple[tuple[np.ndarray, ...], tuple[np.ndarray, ...]]


def linear_weights(share: np.ndarray) -> Weights:
    """Return the weights of the two texels around a point, and their derivatives by the share."""
    return (1 - share, share), (-np.ones_like(share), np.ones_like(share))


def cubic_weights(share: np.ndarray) -> Weights:
    """Return the weights of the four nearest coefficients of a cubic B-spline, and their derivatives."""
    s, t = share, 1 - share
    weights = (t**3 / 6, (4 - 6 * s**2 + 3 * s**3) / 6, (4 - 6 * t**2 + 3 * t**3) / 6, s**3 / 6)
    slopes = (-(t**2) / 2, (3 * s**2 - 4 * s) / 2, (4 * t - 3 * t**2) / 2, s**2 / 2)
    return weights, slopes


def spline_coefficients(table: np.ndarray) -> np.ndarray:
    """Return the coefficients of the periodic cubic B-spline through a table: its samples are (c₋ + 4c + c₊)/6."""
    spectrum = np.fft.rfft2(table)
    for axis, frequencies in ((0, np.fft.fftfreq(table.shape[0])), (1, np.fft.rfftfreq(table.shape[1]))):
        response = (4 + 2 * np.cos(2 * np.pi * frequencies)) / 6
        spectrum /= response[:, None] if axis == 0 else response[None, :]
    return np.fft.irfft2(spectrum, table.shape)


def interpolated(
    table: np.ndarray, weights: Callable[[np.ndarray], Weights], first: int, u: np.ndarray, v: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return (value, by u, by v) of a periodic tensor-product interpolation.

    table: (…, texels, columns), `texels` of them to a unit; first: offset of a point's first coefficient.
    """
    texels, columns = table.shape[-2:]
    at = [np.floor(c * texels).astype(int) for c in (u, v)]
    (wu, du), (wv, dv) = (weights(c * texels - n) for c, n in zip((u, v), at, strict=True))
    value, by_u, by_v = np.zeros((3, *table.shape[:-2], *u.shape))
    for i in range(len(wu)):
        for j in range(len(wv)):
            coefficient = table[..., (at[0] + i + first) % texels, (at[1] + j + first) % columns]
            value += coefficient * wu[i] * wv[j]
            by_u += coefficient * du[i] * wv[j]
            by_v += coefficient * wu[i] * dv[j]
    return value, by_u * texels, by_v * texels


def slope(field: str, texels: int, kind: str, u: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Return h_u of the "bilinear" or "cubic" interpolation of a field's table."""
    i, j = np.mgrid[0:texels, 0 : 2 * texels] / texels
    table = in_float64(height(HEIGHT_FIELDS[field]), {"u": i, "v": j, "k_u": KU, "k_v": KV})["h"]
    if kind == "bilinear":
        return interpolated(table, linear_weights, 0, u, v)[1]
    return interpolated(spline_coefficients(table), cubic_weights, -1, u, v)[1]


def sample() -> Pair:
    """Return (u, v): random points of the chart."""
    return tuple(np.random.default_rng(SEED).uniform(0, 1, (2, POINTS)))


def errors(field: str, kind: str, texels: Sequence[int] = TEXELS) -> Pair:
    """Return (largest, RMS) error of h_u for each number of texels across, over the sample."""
    u, v = sample()
    right = in_float64(gradient(HEIGHT_FIELDS[field]), {"u": u, "v": v, "k_u": KU, "k_v": KV})["h_u"]
    off = [np.abs(slope(field, n, kind, u, v) - right) for n in texels]
    return np.array([e.max() for e in off]), np.array([rms(e) for e in off])


def order(values: np.ndarray, texels: Sequence[int] = TEXELS, last: int = 4) -> float:
    """Return the fitted order of convergence over the last few sizes."""
    return float(-np.polyfit(np.log(texels[-last:]), np.log(values[-last:]), 1)[0])
