"""Orders of an error in the step: fitted, enclosed, and that of the difference of ridges over the chart.

The RMS error of ridges follows theorem crease_error_area. It is smooth between the creases and the
points ε away from one, so Gauss–Legendre nodes go there: random points would miss the bands below ε ≈ 6e-5.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from proofs.formulas import step_bounds
from renderer import Scene, central, exact, gradient_at
from renderer.generate.kernels import function_of
from renderer.intervals import Interval
from verify.accuracy.differences import SLOPES

NODES = 20
SCENE = Scene()  # ridges, k_u = 8, k_v = 4
_crease_rms = function_of(step_bounds.crease_rms)


def fitted_slope(steps: ArrayLike, values: ArrayLike) -> float:
    """Return the slope of log values against log steps by least squares."""
    return float(np.polyfit(np.log(steps), np.log(values), 1)[0])


def enclosed_slope(steps: ArrayLike, values: Sequence[Interval]) -> Interval:
    """Return the same of numbers that are enclosed: it rises with those right of the middle, and falls with others.

    The fit's own roundings are far below 1e-9.
    """
    right = np.log(steps) > np.mean(np.log(steps))
    lower = [v.lower if r else v.upper for v, r in zip(values, right, strict=True)]
    upper = [v.upper if r else v.lower for v, r in zip(values, right, strict=True)]
    slope = fitted_slope(steps, [v.value for v in values])
    return Interval(slope, fitted_slope(steps, lower) - 1e-9, fitted_slope(steps, upper) + 1e-9)


def predicted(component: str, steps: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    """Return (the theorem's RMS, how far it may be off) for each step. No crease of k_v lies at the poles."""
    k, creases = {"h_u": (SCENE.ku, SCENE.ku), "h_v": (SCENE.kv, SCENE.kv - 1)}[component]
    return _crease_rms(np.asarray(steps), k, creases)


def _panels(k, step):
    """Return Gauss–Legendre (nodes, weights) on [0, 1), cut at the creases m/k and at ε to either side of them."""
    creases = np.arange(k + 1) / k
    ends = np.unique(np.clip(np.concatenate([creases, creases - step, creases + step]), 0, 1))
    ends = ends[np.concatenate([[True], np.diff(ends) > 1e-14])]
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    half = np.diff(ends)[:, None] / 2
    return (ends[:-1, None] + half * (1 + nodes)).ravel(), (half * weights).ravel()


def _errors(scene, component, step, at):
    """Return central difference − exact at points (u, v)."""
    numeric, symbolic = (gradient_at(scene, *at, method) for method in (central(step), exact()))
    return numeric[SLOPES.index(component)] - symbolic[SLOPES.index(component)]


def quadrature(component: str, step: float) -> float:
    """Return the RMS over the chart of (central difference − exact) of ridges, whole k_u and k_v."""
    in_u = component == "h_u"
    (u_at, u_weights), (v_at, v_weights) = _panels(SCENE.ku, step * in_u), _panels(SCENE.kv, step * (not in_u))
    error = _errors(SCENE, component, step, np.meshgrid(u_at, v_at, indexing="ij"))
    return float(np.sqrt(u_weights @ error**2 @ v_weights))
