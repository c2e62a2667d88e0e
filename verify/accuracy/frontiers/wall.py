"""The wall: a height field that is sampled into texels, interpolated, and differentiated exactly, as interpolation.

The table covers u ∈ [0, 1) and v ∈ [0, 2), one period of the formula in either, so that no end condition enters.
"""

from collections.abc import Sequence

import numpy as np
from numpy.polynomial import Polynomial

from renderer import Scene, exact, gradient_at
from renderer.intervals import rms
from renderer.kernels import FIELDS
from verify.accuracy.orders import fitted_slope

KU, KV = Scene().ku, Scene().kv
POINTS, SEED = 10_000, 8
TEXELS = (33, 65, 129, 257, 513)  # odd, so that creases lie inside texels, as they do in a picture

Pair = tuple[np.ndarray, np.ndarray]
Weights = Sequence[Polynomial]
"""The weights of the texels around a point, of its share of the way to the next one."""

_s = Polynomial([0, 1])
_t = 1 - _s
LINEAR = _t, _s
CUBIC = _t**3 / 6, (4 - 6 * _s**2 + 3 * _s**3) / 6, (4 - 6 * _t**2 + 3 * _t**3) / 6, _s**3 / 6
"""The weights of the two nearest samples, and of the four nearest coefficients of a cubic B-spline."""


def _spline_coefficients(table):
    """Return the coefficients of the periodic cubic B-spline through a table: its samples are (c₋ + 4c + c₊)/6."""
    frequencies = np.fft.fftfreq(table.shape[0])[:, None], np.fft.rfftfreq(table.shape[1])
    down, across = ((4 + 2 * np.cos(2 * np.pi * each)) / 6 for each in frequencies)
    return np.fft.irfft2(np.fft.rfft2(table) / down / across, table.shape)


def interpolated(table: np.ndarray, of_u: Weights, of_v: Weights, points: Pair) -> np.ndarray:
    """Return a periodic tensor-product interpolation at points (u, v); by the derivatives of weights, in texels.

    table: (…, texels, columns), `texels` of them to a unit.
    """
    texels = table.shape[-2]
    weights, places = [], []
    for coordinate, functions, period in zip(points, (of_u, of_v), table.shape[-2:], strict=True):
        first = np.floor(coordinate * texels)
        weights.append(np.array([weight(coordinate * texels - first) for weight in functions]))
        around = np.arange(len(weights[-1]))[:, None] + 1 - len(weights[-1]) // 2
        places.append((first.astype(int) + around) % period)
    coefficients = table[..., places[0][:, None], places[1][None]]
    return np.einsum("...ijn,in,jn->...n", coefficients, *weights)


KINDS = {"bilinear": (lambda table: table, LINEAR), "cubic": (_spline_coefficients, CUBIC)}
"""{kind of interpolation: (a table's coefficients, their weights)}"""


def slope(field: str, texels: int, kind: str, points: Pair) -> np.ndarray:
    """Return h_u of an interpolation of a field's table, of one of the KINDS."""
    at, (coefficients, weights) = np.mgrid[0:texels, 0 : 2 * texels] / texels, KINDS[kind]
    slopes = [weight.deriv() for weight in weights]
    return texels * interpolated(coefficients(FIELDS[field]["height"](*at, KU, KV)), slopes, weights, points)


def sample() -> Pair:
    """Return (u, v): random points of the chart."""
    return tuple(np.random.default_rng(SEED).uniform(0, 1, (2, POINTS)))


def errors(field: str, kind: str, texels: Sequence[int] = TEXELS) -> Pair:
    """Return (largest, RMS) error of h_u for each number of texels across, over the sample."""
    right, _ = gradient_at(Scene(field=field), *sample(), exact())
    off = [np.abs(slope(field, n, kind, sample()) - right) for n in texels]
    return np.array([e.max() for e in off]), np.array([rms(e) for e in off])


def order(values: np.ndarray, texels: Sequence[int] = TEXELS, last: int = 4) -> float:
    """Return the fitted order of convergence over the last few sizes."""
    return -fitted_slope(texels[-last:], values[-last:])
