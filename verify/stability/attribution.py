"""Where the error of a central difference comes from, pixel by pixel: which of its terms is the largest.

The terms are those of `verify.accuracy.differences`: truncation, unless a crease lies within ε (straddling) or v ± ε
leaves the chart (one-sided); what rounding u ± ε costs; the rounding of h.
"""

from collections.abc import Iterable

import numpy as np

from proofs.formulas.creases import straddling
from proofs.formulas.height_fields import HEIGHT_FIELDS
from renderer import Scene
from renderer.picture.frame import Frame
from verify.accuracy.differences import taken_apart
from verify.evaluate.arrays import in_float64

TERMS = ("truncation", "argument rounding", "roundoff", "straddling", "one-sided")


def _first_kinds(field, inputs):
    """Return the kind of the first term, in u and in v."""
    flags = straddling(field)
    in_u = in_float64(flags, inputs | {"k_v": 0.0})[flags.outputs[0].name] > 0
    in_v = in_float64(flags, inputs | {"k_u": 0.0})[flags.outputs[0].name] > 0
    v, eps, k = inputs["v"], inputs["epsilon"], inputs["k_v"]
    outside = (v + eps > 1) | (v - eps < 0)
    at_the_end = outside & np.isin(np.rint(k * v), (0.0, k))  # the crease in reach is the pole: no sample is beyond it
    return np.where(in_u, 3, 0), np.where(in_v & ~at_the_end, 3, np.where(outside, 4, 0))


def dominant(scene: Scene, u: np.ndarray, v: np.ndarray, eps: float) -> np.ndarray:
    """Return which term is the largest at each point of the chart: an index into TERMS, −1 where all are zero."""
    inputs = {"u": u, "v": v, "k_u": scene.ku, "k_v": scene.kv}
    found, values, kinds = taken_apart(scene.field, inputs, eps), [], []
    firsts = _first_kinds(HEIGHT_FIELDS[scene.field], inputs | {"epsilon": eps})
    for name, first in zip(("h_u", "h_v"), firsts, strict=True):
        values += [*found[name][:3]]
        kinds += [first, np.full(len(u), 1), np.full(len(u), 2)]
    at = (np.abs(values).argmax(axis=0), np.arange(len(u)))
    return np.where(np.array(values)[at] == 0, -1, np.array(kinds)[at])


def shares(kinds: np.ndarray) -> dict[str, float]:
    """Return {term: its share of the points}."""
    return {name: float(np.mean(kinds == index)) for index, name in enumerate(TERMS)}


def over_the_image(frame: Frame, eps: float) -> np.ndarray:
    """Return the dominant term at every pixel of a frame, (height, width) int; −2 off A."""
    data, on_a = frame.surface_data, frame.stage.on_a
    result = np.full(on_a.shape, -2)
    result[on_a] = dominant(frame.scene, data["u"][on_a], data["v"][on_a], eps)
    return result


def shares_by_step(frame: Frame, steps: Iterable[float], points: int = 400, seed: int = 10) -> dict[str, np.ndarray]:
    """Return {term: its share for each step}, over random pixels of A in the frame."""
    data, on_a = frame.surface_data, frame.stage.on_a
    chosen = np.random.default_rng(seed).choice(np.flatnonzero(on_a), points, replace=False)
    u, v = data["u"].ravel()[chosen], data["v"].ravel()[chosen]
    table = [shares(dominant(frame.scene, u, v, eps)) for eps in steps]
    return {name: np.array([row[name] for row in table]) for name in TERMS}
