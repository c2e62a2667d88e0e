"""From the image point to the tangent vector g: our two forms of the chain, and the seed's."""

from functools import lru_cache

import numpy as np

from proofs.engine.program import Program, chain
from proofs.formulas.bump import bumped_normal, g
from proofs.formulas.camera import angles_on_a
from proofs.formulas.chart import chart, seed_chart
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from proofs.formulas.seed_hit import seed_normal
from proofs.formulas.symbols import h_u, h_v, normal
from proofs.formulas.tangent_frame import e_phi, e_theta, seed_frame, seed_sin_phi, unit_normal
from verify.evaluate.arrays import Inputs, in_float64
from verify.evaluate.programs import algebraic_gradient, naive_gradient

SEED_FALLBACK = 1e-4
our_normal = chain("our_normal", angles_on_a, unit_normal).keep(*normal)
"""Ours: N from the angles."""


@lru_cache
def tangent_vector(field: str, form: str, ku: float = 8.0, kv: float = 4.0) -> Program:
    """Return the program (image point, scene) → g by the "general" or the "algebraic" form of the exact gradient."""
    known = HEIGHT_FIELDS[field]
    middle = [chart, gradient(known)] if form == "general" else [algebraic_gradient(known, ku, kv)]
    return chain(f"g_{form}", angles_on_a, *middle, bumped_normal, outputs=g).keep(*g)


@lru_cache
def _seed_program(field):
    outputs = (h_u, h_v, seed_sin_phi, *e_theta, *e_phi)
    return chain("seed_g", seed_normal, seed_chart, naive_gradient(HEIGHT_FIELDS[field]), seed_frame, outputs=outputs)


def seed_tangent_vector(field: str, inputs: Inputs, fallback: bool = True) -> dict[str, np.ndarray]:
    """Return {component of g: array} as the seed computes it, with or without its fixed frame near the pole."""
    v = in_float64(_seed_program(field), inputs)
    near = ~(v["seed_sin_phi"] > SEED_FALLBACK) & fallback
    fixed = (v["h_u"], v["h_v"], np.zeros_like(v["h_u"]))
    with np.errstate(invalid="ignore"):  # without the fallback it divides by zero below 10⁻⁸
        framed = [v["h_u"] * v[t.name] + v["h_v"] * v[p.name] for t, p in zip(e_theta, e_phi, strict=True)]
    return {n.name: np.where(near, *both) for n, *both in zip(g, fixed, framed, strict=True)}
