"""The normal under any amplitude, and the light: close, far, at a shadow's edge, opposite to the eye, any shininess."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from proofs.engine.program import chain
from proofs.formulas.bump import bumped_normal, g, perturbed
from proofs.formulas.camera import point_on_a
from proofs.formulas.shading import LIGHT_MODELS, highlight, light_direction
from proofs.formulas.shadow import shadow, shadow_discriminant
from proofs.formulas.symbols import bumped, mu, normal, specular, specular_base
from proofs.formulas.tangent_frame import unit_normal
from renderer.machines.enclosing import Enclosed
from renderer.machines.enclosing_machine import Enclosing
from renderer.machines.numpy_rows import Rows
from renderer.shader.shader import power
from verify.evaluate.arrays import in_float64, with_bounds
from verify.stability.sweep import SHAPE, Sweep, measured

SAMPLES = SHAPE[1]


def angles(random: np.random.Generator, shape: tuple[int, ...]) -> dict[str, np.ndarray]:
    """Return {cos θ, sin θ, cos φ, sin φ} of random points of the upper half of A."""
    theta, phi = random.uniform(-np.pi, np.pi, shape), random.uniform(0.01, 1.3, shape)
    return {"cos_theta": np.cos(theta), "sin_theta": np.sin(theta), "cos_phi": np.cos(phi), "sin_phi": np.sin(phi)}


def coordinates(vectors: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Return {name_x, name_y, name_z: component} of {name: vectors (3, …)}."""
    return {f"{name}_{axis}": c for name, triple in vectors.items() for axis, c in zip("xyz", triple, strict=True)}


def any_amplitude() -> Sweep:
    """N' against |β| from the least denormal to 10¹⁰⁰, for slopes of up to π 2²⁰.

    Reason of the bound: M = N + βg with g ⟂ N, so |M| ≥ 1 and dividing by it amplifies nothing.
    """
    random, sizes = np.random.default_rng(5), np.concatenate([[2.0**-1074, 1e-310], np.logspace(-300, 100, 107)])
    at = angles(random, shape := (len(sizes), SAMPLES))
    slopes = random.uniform(-1, 1, (2, *shape)) * 10.0 ** random.uniform(0, 6.5, shape)
    tangents = at | {"h_u": slopes[0], "h_v": slopes[1]}
    inputs = in_float64(bumped_normal.keep(*normal, *g), tangents)
    return measured(sizes, perturbed, inputs | {"beta": sizes[:, None] * random.choice([-1.0, 1.0], shape)})


def near_and_far_lights() -> Sweep:
    """μ against the light's distance from the surface, from 2·10⁻⁹ to 10⁹ radii.

    Reason of the bound: the point is known to some 2⁻⁵³ R, so that a light at distance d is seen in a direction known
    to 2⁻⁵³ R/d; far away nothing is lost.
    """
    random, distances = np.random.default_rng(6), np.geomspace(2e-9, 0.999e9, 73)
    at = angles(random, shape := (len(distances), SAMPLES))
    n = np.array([*in_float64(unit_normal, at).values()])
    aside = across(n, random.normal(size=n.shape))
    tilt = random.uniform(0, 1.4, shape)
    light = n + distances[:, None] * (np.cos(tilt) * n + np.sin(tilt) * aside)
    inputs = at | {"radius": 1.0} | coordinates({"light": light})
    lit_point = chain("lit_point", unit_normal, point_on_a, {bumped: normal}, light_direction).keep(mu)
    return measured(distances, lit_point, inputs)


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
    inputs, largest = coordinates(vectors) | {"body_radius": radius}, {shadow_discriminant.name: radius**2 * squared}
    return measured(share[:, 0], shadow.keep(shadow_discriminant), inputs, scales=largest)


def opposite_light(model: str) -> Sweep:
    """The highlight's base against |ω + v̂|, from 1 to 10⁻¹⁶: the light behind the point, seen from the eye.

    Reason of the bound: ω and v̂ are each known to 2⁻⁵³, their sum to 2⁻⁵³/|ω + v̂| of its length; the base itself is
    a cosine, so that the bound never has to exceed 2.
    """
    gaps = np.geomspace(1, 1e-16, 65)
    view, aside, up = np.random.default_rng(7).normal(size=(3, 3, len(gaps), SAMPLES))
    view, up = (vector / np.linalg.norm(vector, axis=0) for vector in (view, up))
    towards = -view + gaps[:, None] * across(view, aside)
    vectors = {"light": towards, "view": view, "bumped": up, "point": np.zeros((3, 1, 1))}
    found = measured(gaps, LIGHT_MODELS[model].program.keep(specular_base), coordinates(vectors))
    return replace(found, bounds=np.minimum(found.bounds, 2.0))


def across(axis: np.ndarray, vectors: np.ndarray) -> np.ndarray:
    """Return the part of vectors (3, …) at right angles to unit vectors, normalised."""
    vectors = vectors - (vectors * axis).sum(axis=0) * axis
    return vectors / np.linalg.norm(vectors, axis=0)


def any_shininess(whole: bool = True) -> Sweep:
    """base^p against p from 10⁻³ to 10⁶, for bases within 8/p of 1; whole p, from 1 on, as the shader raises it.

    Reason of the bound: each of p multiplications rounds by at most 2⁻⁵³ of the result, so base^p is off by p 2⁻⁵³
    base^p, and an inherited error δ of the base by p base^(p−1) δ; δ = 2⁻⁵³ here: p is what a highlight costs.
    """
    powers = np.geomspace(1e-3, 1e6, 91)
    powers = np.where((powers >= 1) & whole, np.rint(powers), powers)
    base = 1 - np.random.default_rng(8).uniform(0, 1, (91, SAMPLES)) * np.minimum(1, 8 / powers)[:, None]
    inputs = {"specular_base": base, "shininess": powers[:, None]}
    ours, machine = with_bounds(highlight, inputs), Enclosing(Rows(()))
    for row in np.flatnonzero(powers == np.rint(powers)):
        (raised,) = power(machine, [Enclosed(base[row])], Enclosed(powers[row]))
        ours[specular.name].value[row], ours[specular.name].error[row] = raised.value, raised.error
    return measured(powers, highlight, inputs, ours)
