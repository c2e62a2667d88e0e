"""Attribution of a central difference's error, point by point: which of its terms is the largest.

The terms are those of `proofs.formulas.step_bounds`, each measured by `verify.accuracy.differences`; which of them the
exact difference's error is, truncation, straddling or one-sided, is that of its bound.
"""

import numpy as np

from proofs.formulas.step_bounds import TERMS
from renderer import Scene
from verify.accuracy.differences import PARTS, SLOPES, taken_apart
from verify.accuracy.step_terms import SLOPE_TERMS

ROUNDED = range(1, len(PARTS) - 1)  # the terms of rounding, among PARTS and among TERMS


@np.errstate(all="ignore")
def dominant(scene: Scene, u: np.ndarray, v: np.ndarray, eps: float) -> np.ndarray:
    """Return which term is the largest at each point of the chart: an index into TERMS, −1 where all are zero."""
    measured = taken_apart(str(scene.field), {"u": u, "v": v, "k_u": scene.ku, "k_v": scene.kv}, eps)
    values, kinds = [], []
    for slope, bounds in zip(SLOPES, SLOPE_TERMS[str(scene.field)](u, v, scene.ku, scene.kv, eps), strict=True):
        exact = np.array(np.broadcast_arrays(u, *bounds)[1:])
        exact[ROUNDED] = -1.0
        values += [*measured[slope][:-1]]
        kinds += [exact.argmax(axis=0), *(np.full(len(u), term) for term in ROUNDED)]
    at = (np.abs(values).argmax(axis=0), np.arange(len(u)))
    return np.where(np.array(values)[at] == 0, -1, np.array(kinds)[at])


def shares(kinds: np.ndarray) -> dict[str, float]:
    """Return {term: its share of the points}."""
    return {name: float(np.mean(kinds == index)) for index, name in enumerate(TERMS)}
