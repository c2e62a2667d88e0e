"""Ridges' central difference over the whole chart: its RMS error by quadrature, against the theorem's constant.

Theorem crease_error_area: π k_u √(k_u ε/3) in h_u and π k_v √((k_v − 1) ε/3) in h_v, up to ⅔πk (πkε)². The error is
smooth between the creases and the points ε away from one, so Gauss–Legendre nodes go there: random points would miss
the bands below ε ≈ 6e-5. The differences are the kernels' own.
"""

import math

import numpy as np
from numpy.typing import ArrayLike

from renderer import Scene, central, exact, gradient_at
from renderer.picture.frame import Frame

NODES = 20
SCENE = Scene()  # ridges, k_u = 8, k_v = 4


def predicted(component: str, steps: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    """Return (the theorem's RMS, how far it may be off) for each step."""
    k = SCENE.ku if component == "h_u" else SCENE.kv
    creases = k if component == "h_u" else k - 1
    rate, steps = math.pi * k, np.asarray(steps)
    return rate * np.sqrt(creases * steps / 3), 2 / 3 * rate * (rate * steps) ** 2


def _panels(k, step):
    """Return Gauss–Legendre (nodes, weights) on [0, 1), cut at the creases m/k and at ε to either side of them."""
    creases = np.arange(k + 1) / k
    ends = np.unique(np.clip(np.concatenate([creases, creases - step, creases + step]), 0, 1))
    ends = ends[np.concatenate([[True], np.diff(ends) > 1e-14])]
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    half = np.diff(ends)[:, None] / 2
    return (ends[:-1, None] + half * (1 + nodes)).ravel(), (half * weights).ravel()


def quadrature(component: str, step: float) -> float:
    """Return the RMS over the chart of (central difference − exact) of ridges, whole k_u and k_v."""
    index, k = (0, SCENE.ku) if component == "h_u" else (1, SCENE.kv)
    along, weights = _panels(int(k), step)
    across, across_weights = _panels(int(SCENE.kv if index == 0 else SCENE.ku), 0.0)
    grid = np.meshgrid(along, across, indexing="ij")
    u, v = grid if index == 0 else grid[::-1]
    error = (gradient_at(SCENE, u, v, central(step))[index] - gradient_at(SCENE, u, v, exact())[index]) ** 2
    return float(math.sqrt(weights @ error @ across_weights))


def on_the_raster(component: str, step: float, frame: Frame) -> float:
    """Return the same RMS over the pixels of sphere A in a frame: its centres alone, and as the image crowds them."""
    index, on_a = (0, 1)[component == "h_v"], frame.stage.on_a
    u, v = (frame.surface_data[name][on_a] for name in ("u", "v"))
    error = gradient_at(frame.scene, u, v, central(step))[index] - gradient_at(frame.scene, u, v, exact())[index]
    return float(np.sqrt((error**2).mean()))
