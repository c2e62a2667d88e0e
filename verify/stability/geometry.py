"""Toward the pole and the silhouette, from the nearest eye to the furthest: the normal, the vector g.

Of the pipeline from the image point to g there are our two forms, and the seed's.
"""

from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from proofs.engine.program import Program, chain
from proofs.formulas.bump import bumped_normal, g
from proofs.formulas.camera import angles_on_a, parallel_radius
from proofs.formulas.chart import chart, seed_chart
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from proofs.formulas.seed_hit import seed_normal
from proofs.formulas.symbols import h_u, h_v, normal
from proofs.formulas.tangent_frame import e_phi, e_theta, seed_frame, seed_sin_phi, unit_normal
from renderer import kernels
from verify.evaluate.arrays import Inputs, in_float64, with_bounds
from verify.evaluate.programs import algebraic_gradient, naive
from verify.stability.sweep import Sweep, measured

EYE, RADIUS, RIDGES = 4.0, 1.0, HEIGHT_FIELDS["ridges"]
SINES = np.logspace(np.log10(0.84), -149, 76)
SEED_FALLBACK = 1e-4
our_normal = chain("our_normal", angles_on_a, unit_normal).keep(*normal)
"""Ours: N from the angles."""


@lru_cache
def tangent_vector(form: str) -> Program:
    """Return the program (image point, scene) → g by the "general" or the "algebraic" form, this of k = (8, 4)."""
    middle = [chart, gradient(RIDGES)] if form == "general" else [algebraic_gradient(RIDGES, 8.0, 4.0)]
    return chain(f"g_{form}", angles_on_a, *middle, bumped_normal, outputs=g).keep(*g)


seed_g = chain(
    "seed_g",
    *(seed_normal, seed_chart, naive(gradient(RIDGES)), seed_frame),
    outputs=(h_u, h_v, seed_sin_phi, *e_theta, *e_phi),
)
"""The seed's: the slopes, and the frame of g."""


def seed_tangent_vector(inputs: Inputs, fallback: bool) -> dict[str, np.ndarray]:
    """Return {component of g: array} as the seed computes it, with or without its fixed frame near the pole."""
    v = in_float64(seed_g, inputs)
    near = ~(v["seed_sin_phi"] > SEED_FALLBACK) & fallback
    fixed = (v["h_u"], v["h_v"], np.zeros_like(v["h_u"]))
    with np.errstate(invalid="ignore"):  # without the fallback it divides by zero below 10⁻⁸
        framed = [v["h_u"] * v[t.name] + v["h_v"] * v[p.name] for t, p in zip(e_theta, e_phi, strict=True)]
    return {n.name: np.where(near, *both) for n, *both in zip(g, fixed, framed, strict=True)}


def image_points(rho: np.ndarray, samples: int, seed: int, eye: ArrayLike = EYE) -> dict[str, Any]:
    """Return the inputs of a program of the image point at given radii, `samples` random azimuths each."""
    azimuth = np.random.default_rng(seed).uniform(-np.pi, np.pi, (len(rho), samples))
    return {"x": rho[:, None] * np.cos(azimuth), "y": rho[:, None] * np.sin(azimuth), "eye": eye, "radius": RADIUS}


def _of_normal(parameter, inputs):
    return measured(parameter, our_normal, inputs, others={"seed": in_float64(seed_normal, inputs)})


def toward_the_pole(form: str = "algebraic", sines: np.ndarray = SINES, samples: int = 12, seed: int = 1) -> Sweep:
    """Sweep g of ridges against sin φ, by default down to the pole's border, as a function of the float64 image point.

    Reason of the bound: no line of the chain cancels, so that every one adds a few roundings of its own size.
    """
    cosines = np.sqrt((1 - sines) * (1 + sines))
    (rho,) = in_float64(parallel_radius, {"sin_phi": sines, "cos_phi": cosines, "eye": EYE, "radius": RADIUS}).values()
    inputs = image_points(rho, samples, seed) | {"k_u": 8.0, "k_v": 4.0}
    others = {name: seed_tangent_vector(inputs, name != "seed") for name in ("seed", "seed with fallback")}
    ours = with_bounds(tangent_vector(form), inputs)
    return measured(sines, tangent_vector("general"), inputs, ours, others=others)


def toward_the_silhouette() -> Sweep:
    """Sweep N against s = 1 − (ρ/ρ_s)² from 0.99 to 10⁻¹⁴.

    Reason of the bound: the root is taken of (ρ_s − ρ)(ρ_s + ρ), whose factors are each right to a few roundings of
    ρ_s; the root turns δ/s into δ/√s, and no form can do better, since ρ_s itself is rounded.
    """
    share = np.logspace(np.log10(0.99), -14, 57)
    rho = kernels.silhouette_of_a(EYE, RADIUS) * np.sqrt(1 - share)
    return _of_normal(share, image_points(rho, samples=40, seed=2))


def from_near_to_far() -> Sweep:
    """Sweep N against e/R − 1 from 10⁻⁹ to 10⁶, at image points with 1 − (ρ/ρ_s)² ≥ 0.1.

    Reason of the bound: t is a quotient of positive terms, and e² − R² is a product; nothing cancels at either end.
    """
    samples, seed = 60, 3
    above = np.logspace(-9 + 1e-6, 6 - 1e-6, 61)
    eye = RADIUS + above
    inputs = image_points(kernels.silhouette_of_a(eye, RADIUS), samples, seed, eye[:, None])
    inside = np.random.default_rng(seed).uniform(0, 0.9, inputs["x"].shape)
    return _of_normal(above, inputs | {axis: inputs[axis] * np.sqrt(inside) for axis in "xy"})
