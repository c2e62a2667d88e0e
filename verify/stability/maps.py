"""Accuracy plotted over the input space: of h_u over the chart, of g over the image; ours and the seed's form."""

import numpy as np

from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from renderer import Scene, kernels
from renderer.machines.enclosing import UNIT
from verify.evaluate.arrays import distance, in_balls, in_float64, length
from verify.evaluate.programs import naive_gradient
from verify.reference import scene_values
from verify.stability.geometry import seed_tangent_vector, tangent_vector

RIDGES = HEIGHT_FIELDS["ridges"]
MISSED_ZERO = 1 / UNIT  # all bits lost: a number where there is an exact zero


def relative(values: np.ndarray, truth: np.ndarray) -> np.ndarray:
    """Return |value − exact| / (2⁻⁵³ |exact|): 0 for an exact zero that is met, MISSED_ZERO for one that is not."""
    off, size = distance(values, truth), distance(np.zeros(np.shape(truth)), truth)
    with np.errstate(all="ignore"):
        return np.where(off > 0, np.minimum(off / (UNIT * size), MISSED_ZERO), 0.0)


def over_the_chart(side: int = 128) -> dict[str, np.ndarray]:
    """Return {"seed", "ours"}: (side, side) maps of the error of h_u of ridges in units of 2⁻⁵³ of itself, v downwards.

    A point is drawn in each cell of a grid; every so often it is the cell's left edge, so that some lie on a crease.
    """
    random = np.random.default_rng(9)
    rows, columns = np.mgrid[0:side, 0:side]
    inside = random.uniform(0, 1, (2, side, side))
    inside[0][:, :: side // 32] = 0
    inputs = {"u": (columns + inside[0]) / side, "v": (rows + inside[1]) / side, "k_u": 8.0, "k_v": 4.0}
    programs = {"seed": naive_gradient(RIDGES), "ours": gradient(RIDGES)}
    truth = in_balls(programs["ours"], inputs)["h_u"]
    return {name: relative(in_float64(program, inputs)["h_u"], truth) for name, program in programs.items()}


def over_the_image(size: int, reach: float = 1.0) -> dict[str, np.ndarray]:
    """Return {"seed", "ours"}: (size, size) maps of |g − exact| in units of 2⁻⁵³ π k, NaN off A.

    reach: the half-width of the view in silhouette radii, centred on the axis; the pole is the centre.
    """
    scene = Scene()
    edge = kernels.silhouette_of_a(scene.eye, scene.radius)
    offsets = reach * edge * (2 * np.arange(size) + 1 - size) / size
    x, y = np.broadcast_arrays(offsets[None, :], -offsets[:, None])
    on_a = np.hypot(x, y) < edge * (1 - 1e-12)
    inputs = scene_values(scene, x=x[on_a], y=y[on_a])
    truth = in_balls(tangent_vector(scene.field, "general"), inputs)
    ours = in_float64(tangent_vector(scene.field, "algebraic", scene.ku, scene.kv), inputs)
    maps, unit = np.full((2, size, size), np.nan), UNIT * np.pi * max(scene.ku, scene.kv)
    for plane, vector in zip(maps, (seed_tangent_vector(str(scene.field), inputs), ours), strict=True):
        plane[on_a] = length([distance(vector[name], truth[name]) for name in truth]) / unit
    return dict(zip(("seed", "ours"), maps, strict=True))


def summary(units: np.ndarray) -> tuple[float, float]:
    """Return (median, largest) of a map as bits lost: log₂ of the error in units, at least 0."""
    seen = np.maximum(units[~np.isnan(units)], 1.0)
    return float(np.log2(np.median(seen))), float(np.log2(seen.max()))
