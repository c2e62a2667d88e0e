"""The wall again, one derivative later: a table of normals, stored, interpolated, and normalised again.

A texel holds the bumped normal in the tangent frame, (βh_u, βh_v, 1) over its length; the frame is orthonormal, so that
lengths and angles there are those in space. The gradient that is stored may be exact or a difference's.
"""

from collections.abc import Sequence

import numpy as np
from sympy import S

from proofs.formulas.bump import g, normal_by_beta, perturbed
from proofs.formulas.pixel import instance
from proofs.formulas.symbols import h_u, h_v, normal
from renderer import Scene, central, exact, gradient_at
from renderer.intervals import rms
from renderer.scene.methods import GradientMethod
from verify.accuracy.frontiers.wall import LINEAR, interpolated, sample
from verify.evaluate.arrays import in_float64

in_frame = {normal: (S.Zero, S.Zero, S.One), g: (h_u, h_v, S.Zero)}
bumped_in_frame = instance(perturbed, "in_frame", given=in_frame)
"""(h_u, h_v, β) → N' in the tangent frame: there N = (0, 0, 1) and g = (h_u, h_v, 0)."""

by_beta_in_frame = instance(normal_by_beta, "by_beta_in_frame", given=in_frame)
"""(h_u, h_v, β) → ∂N'/∂β there."""

TEXELS = (33, 65, 129, 257, 513, 1025)
EPS = 1e-3


def tangent_normal(scene: Scene, u: np.ndarray, v: np.ndarray, method: GradientMethod) -> np.ndarray:
    """Return the bumped normal in the tangent frame, (3, …), at points of the chart."""
    return _in_frame(bumped_in_frame, scene, *gradient_at(scene, u, v, method))


def _in_frame(program, scene, h_u, h_v):
    return np.array([*in_float64(program, {"h_u": h_u, "h_v": h_v, "beta": scene.beta}).values()])


def baked(scene: Scene, texels: int, method: GradientMethod) -> np.ndarray:
    """Return the normal map of a scene's bump: unit normals at (u, v) = (i, j)/texels, (3, texels, texels).

    `fetched` repeats the map, so the field must have period 1 in u and v: the chapter's have, for even k_u and k_v.
    """
    u, v = np.mgrid[0:texels, 0:texels] / texels
    return tangent_normal(scene, u, v, method)


def in_bytes(normals: np.ndarray) -> np.ndarray:
    """Return unit normals as a texture keeps them: each component from −1 … 1 to 0 … 255, uint8."""
    return np.rint((normals + 1) * 127.5).astype(np.uint8)


def from_bytes(stored: np.ndarray) -> np.ndarray:
    """Return the normals that a texture's bytes say, not normalised."""
    return stored / 127.5 - 1


def fetched(normals: np.ndarray, u: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Return the normal that a map gives at points, (3, n): bilinear between four texels, and normalised."""
    mean = interpolated(normals, LINEAR, LINEAR, (u, v))
    return mean / np.linalg.norm(mean, axis=0)


def apart(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Return |a − b| of vectors (3, n)."""
    return np.linalg.norm(a - b, axis=0)


def errors(field: str, texels: Sequence[int] = TEXELS) -> dict[str, np.ndarray]:
    """Return {name: array over `texels`} over the chart's sample: how far from the exact N' the fetched one is.

    symbolic, numeric: RMS of the map of exact gradients, and of central differences. between: RMS of one from the
    other. largest: of the first. bytes: RMS of the first kept in 8 bits.
    """
    scene, points, rows = Scene(field=field), sample(), []
    right = tangent_normal(scene, *points, exact())
    for n in texels:
        maps = [baked(scene, n, method) for method in (exact(), central(EPS))]
        one, other, coarse = (fetched(normals, *points) for normals in (*maps, from_bytes(in_bytes(maps[0]))))
        pairs = (one, right), (other, right), (one, other), (coarse, right)
        rows.append([*(rms(apart(*pair)) for pair in pairs), apart(one, right).max()])
    names = "symbolic", "numeric", "between", "bytes", "largest"
    return dict(zip(names, np.transpose(rows), strict=True))


def derivative_errors(field: str, texels: int) -> np.ndarray:
    """Return how far ∂N'/∂β is off, (n,), over the sample, if g is what a fetched normal says: (N'_x, N'_y)/βN'_z."""
    scene, points = Scene(field=field), sample()
    x, y, z = fetched(baked(scene, texels, exact()), *points)
    slopes = (x / (scene.beta * z), y / (scene.beta * z)), gradient_at(scene, *points, exact())
    return apart(*(_in_frame(by_beta_in_frame, scene, *each) for each in slopes))


def without_a_map(field: str) -> float:
    """Return the RMS error of N' over the same sample where both pipelines have the formula: the numeric one's."""
    scene, points = Scene(field=field), sample()
    return rms(apart(*(tangent_normal(scene, *points, method) for method in (central(EPS), exact()))))
