"""Sphere B, however small and far, and the edge of a shadow: the hit, the normal, the discriminant."""

from collections.abc import Iterable

import numpy as np
from sympy import Symbol

from proofs.engine.program import Program
from proofs.formulas.camera import normal_of_b
from proofs.formulas.shadow import shadow, shadow_discriminant
from proofs.formulas.symbols import ball_center
from verify.evaluate.arrays import with_bounds
from verify.stability.shading import across, coordinates
from verify.stability.sweep import Sweep, measured

SHAPE = 61, 24  # values of a sweep's parameter, and samples at each


def smaller_and_smaller_b(outputs: Iterable[Symbol], program: Program = normal_of_b) -> Sweep:
    """B's point or normal against its radius from 0.32 to 10⁻⁸; R/e from 10⁻⁶ to 1/4, within 0.9 of the silhouette.

    Reason of the bound: the vector from B's centre to the point is made of products of its own size, and is not what
    is left of the two points. program: what computes them.
    """
    random, radii = np.random.default_rng(9), np.geomspace(0.32, 1e-8, SHAPE[0])[:, None]
    x, y, away, turn = random.uniform(-1, 1, (4, *SHAPE))
    eye, reach = 10.0 ** random.uniform(0.61, 6, x.shape), 0.9 * radii * np.abs(away)
    along = 1 - 1.6 / eye  # of the ray, at the height 1.6
    center = along * x + reach * np.cos(np.pi * turn), along * y + reach * np.sin(np.pi * turn), 1.6
    inputs = {"x": x, "y": y, "eye": eye, "ball_radius": radii, "ball_on": 1.0}
    inputs |= {s.name: c for s, c in zip(ball_center, center, strict=True)}
    ours = with_bounds(program, inputs)
    return measured(radii[:, 0], ours, normal_of_b, inputs, {s.name: 1.0 for s in outputs})


def beside_a_shadow() -> Sweep:
    """The discriminant of a shadow against s = 1 − (ρ/r)² from 0.99 to 10⁻¹⁴; ρ is how far the ray passes the centre.

    It is taken over r² times the light's squared distance, the largest that it can be. Reason of the bound: it is a
    difference of squares, each of a few roundings of the products in it.
    """
    random, share = np.random.default_rng(10), np.logspace(np.log10(0.99), -14, SHAPE[0])[:, None]
    start, light, aside = random.normal(size=(3, 3, *SHAPE))
    radius, way = 10.0 ** random.uniform(-8, 0, SHAPE), light - start
    squared = (way**2).sum(axis=0)
    passed = radius * np.sqrt(1 - share) * across(way / np.sqrt(squared), aside)
    vectors = {"point": start, "light": light, "center": start + random.uniform(0.1, 0.9, squared.shape) * way + passed}
    inputs, program = coordinates(vectors) | {"body_radius": radius}, shadow.keep(shadow_discriminant)
    largest = {shadow_discriminant.name: radius**2 * squared}
    return measured(share[:, 0], with_bounds(program, inputs), program, inputs, largest)
