"""Orders of the difference's error in the step where it is not smooth: over creases, and clamped at the pole.

Over the chart the RMS error of ridges follows theorem crease_error_area. It is smooth between the creases and the
points ε away from one, so Gauss–Legendre nodes go there: random points would miss the bands below ε ≈ 6e-5.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike
from sympy import Abs, diff

from proofs.engine.half_turns import cospi, ordinary
from proofs.formulas import step_bounds
from proofs.formulas.finite_difference import central as central_difference
from proofs.formulas.height_fields import HEIGHT_FIELDS, HeightField, gradient
from proofs.formulas.symbols import k_u, k_v, u, v
from renderer import Scene, central, exact, gradient_at
from renderer.generate.kernels import function_of
from renderer.intervals import Interval
from verify.accuracy.differences import SLOPES
from verify.evaluate.arrays import distance, in_balls

NODES = 20
SCENE = Scene()  # ridges, k_u = 8, k_v = 4
CLAMPED = (*HEIGHT_FIELDS.values(), HeightField("cosine", cospi(k_v * v)))
FIELDS = {field.name: field for field in CLAMPED if field.expression.has(v)}
"""Fields that are clamped at the pole: those that depend on v, and one that is not odd about v = 0."""
STEPS = np.logspace(-6, -3, 13)
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


def clamped_errors(field: str) -> np.ndarray:
    """Return |D − h_v| at v = ε/2 for each of STEPS, in exact arithmetic: k = (8, 4), u = 0.31."""
    at = {"u": 0.31, "v": STEPS / 2, "k_u": 8.0, "k_v": 4.0, "epsilon": STEPS}
    programs = central_difference(FIELDS[field]), gradient(FIELDS[field])
    return distance(*(in_balls(program, at)["h_v"] for program in programs))


def clamped_order(field: str) -> int:
    """Return the order that Taylor's theorem gives: that of the first derivative at v = 0, from the second, not 0, − 1.

    The absolute value of a product is one there, up to its sign: only the product's own derivatives are asked for.
    """
    smooth = ordinary(FIELDS[field].expression.replace(Abs, lambda inside: inside)).xreplace({u: 0.31, k_u: 8, k_v: 4})
    return next(n - 1 for n in range(2, 9) if abs(diff(smooth, v, n).subs(v, 0).evalf()) > 1e-9)
