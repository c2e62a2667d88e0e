"""Toward the pole, toward the silhouette, from the nearest eye to the furthest: the normal and the tangent vector."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from proofs.formulas.bump import g
from proofs.formulas.camera import parallel_radius, silhouette_of_a
from proofs.formulas.seed_hit import seed_normal
from proofs.formulas.symbols import normal
from verify.evaluate.arrays import in_float64, with_bounds
from verify.stability.pipelines import our_normal, seed_tangent_vector, tangent_vector
from verify.stability.sweep import Sweep, measured

EYE, RADIUS = 4.0, 1.0
SINES = np.logspace(np.log10(0.84), -149, 76)
VECTOR, NORMAL = ({s.name: 1.0 for s in triple} for triple in (g, normal))


def image_points(rho: np.ndarray, samples: int, seed: int, eye: ArrayLike = EYE) -> dict[str, Any]:
    """Return the inputs of a program of the image point at given radii, `samples` random azimuths each."""
    azimuth = np.random.default_rng(seed).uniform(-np.pi, np.pi, (len(rho), samples))
    return {"x": rho[:, None] * np.cos(azimuth), "y": rho[:, None] * np.sin(azimuth), "eye": eye, "radius": RADIUS}


def _of_normal(parameter, inputs):
    seed = {"seed": in_float64(seed_normal, inputs)}
    return measured(parameter, with_bounds(our_normal, inputs), our_normal, inputs, NORMAL, seed)


def toward_the_pole(form: str = "algebraic", sines: np.ndarray = SINES, samples: int = 12, seed: int = 1) -> Sweep:
    """g of ridges against sin φ, by default down to where the pole begins, as a function of the float64 image point.

    Reason of the bound: no line of the chain cancels, so that every one adds a few roundings of its own size.
    """
    cosines = np.sqrt((1 - sines) * (1 + sines))
    (rho,) = in_float64(parallel_radius, {"sin_phi": sines, "cos_phi": cosines, "eye": EYE, "radius": RADIUS}).values()
    inputs = image_points(rho, samples, seed) | {"k_u": 8.0, "k_v": 4.0}
    others = {name: seed_tangent_vector("ridges", inputs, name != "seed") for name in ("seed", "seed with fallback")}
    ours = with_bounds(tangent_vector("ridges", form), inputs)
    return measured(sines, ours, tangent_vector("ridges", "general"), inputs, VECTOR, others)


def toward_the_silhouette() -> Sweep:
    """N against s = 1 − (ρ/ρ_s)² from 0.99 to 10⁻¹⁴.

    Reason of the bound: the root is taken of (ρ_s − ρ)(ρ_s + ρ), whose factors are each right to a few roundings of
    ρ_s; the root turns δ/s into δ/√s, and no form can do better, since ρ_s itself is rounded.
    """
    share = np.logspace(np.log10(0.99), -14, 57)
    (edge,) = in_float64(silhouette_of_a, {"eye": EYE, "radius": RADIUS}).values()
    return _of_normal(share, image_points(edge * np.sqrt(1 - share), samples=40, seed=2))


def from_near_to_far() -> Sweep:
    """N against e/R − 1 from 10⁻⁹ to 10⁶, at image points with 1 − (ρ/ρ_s)² ≥ 0.1.

    Reason of the bound: t is a quotient of positive terms, and e² − R² is a product; nothing cancels at either end.
    """
    samples, seed = 60, 3
    above = np.logspace(-9 + 1e-6, 6 - 1e-6, 61)
    eye = RADIUS + above
    edge = in_float64(silhouette_of_a, {"eye": eye, "radius": RADIUS})["rho_silhouette"]
    inputs = image_points(edge, samples, seed, eye[:, None])
    inside = np.random.default_rng(seed).uniform(0, 0.9, inputs["x"].shape)
    return _of_normal(above, inputs | {axis: inputs[axis] * np.sqrt(inside) for axis in "xy"})
