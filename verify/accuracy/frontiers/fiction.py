"""The fiction: the chapter's N' against the normal of the surface that is really displaced, P + βhN on the unit sphere.

Their differences are turned on one at a time: the sign, the chart's scale, the metric. And effects that a bump lacks:
it cannot move the silhouette, nor keep light from where the surface faces away.
"""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import lru_cache

import numpy as np
from sympy import cos, diff, lambdify, sin

from proofs.engine.half_turns import ordinary
from proofs.formulas.bump import bumped_normal
from proofs.formulas.camera import parallel_radius
from proofs.formulas.chart import chart_inverse
from proofs.formulas.displacement import blinn_normal, displaced_normal
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.symbols import beta, cos_phi, eye, k_u, k_v, phi, radius, rho, sin_phi, u, v
from renderer import Scene, render
from renderer.picture.frame import Frame
from verify.evaluate.arrays import in_float64

STEPS = ("the chapter's", "sign turned", "and the chart's scale", "and the metric: Blinn's")


def normals(scene: Scene, data: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Return {name: unit normals (3, n)} at points of A: the four of STEPS, and "displaced".

    data: a frame's surface data at those points, each (n,).
    """
    inputs = {**data, **in_float64(chart_inverse, data), "beta": scene.beta}
    turned = inputs | {"beta": -scene.beta}
    scaled = turned | {"h_u": data["h_u"] / (2 * np.pi), "h_v": data["h_v"] / np.pi}
    programs = bumped_normal, bumped_normal, bumped_normal, blinn_normal, displaced_normal
    arguments = inputs, turned, scaled, inputs, inputs
    vectors = [np.array([*in_float64(*pair).values()]) for pair in zip(programs, arguments, strict=True)]
    return dict(zip((*STEPS, "displaced"), (n / np.linalg.norm(n, axis=0) for n in vectors), strict=True))


def degrees(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Return the angle between unit vectors (3, n), in degrees."""
    return np.degrees(2 * np.arcsin(np.clip(np.linalg.norm(a - b, axis=0) / 2, 0, 1)))


def angle_maps(frame: Frame) -> dict[str, np.ndarray]:
    """Return {step: (height, width) map of the angle to the displaced normal in degrees, NaN off A}."""
    on_a = frame.stage.on_a
    vectors, maps = normals(frame.scene, frame.data_on_a), np.full((len(STEPS), *on_a.shape), np.nan)
    maps[:, on_a] = [degrees(vectors[name], vectors["displaced"]) for name in STEPS]
    return dict(zip(STEPS, maps, strict=True))


@lru_cache
def _outline():
    """Return functions of (φ, β, u, k_u, k_v, e): the image radius of a displaced point, and its derivatives."""
    displaced = 1 + beta * ordinary(HEIGHT_FIELDS["sine"].expression).xreplace({v: phi / np.pi})
    edge = parallel_radius[rho].xreplace({radius: displaced, sin_phi: sin(phi), cos_phi: cos(phi)})
    orders = {"f": edge, "p": diff(edge, phi), "pp": diff(edge, phi, 2), "b": diff(edge, beta),
              "bb": diff(edge, beta, 2), "pb": diff(edge, phi, beta)}  # fmt: skip
    return {name: lambdify((phi, beta, u, k_u, k_v, eye), e, "numpy") for name, e in orders.items()}


def silhouette_remainders(betas: Iterable[float]) -> np.ndarray:
    """Return (moved, first, second): the largest, over the azimuths, of how far displacement moves the silhouette,
    and of what is left after the terms of first and second order in β; each an array over `betas`.

    A displaced point keeps its azimuth, so that the outline at u is the largest image radius along its meridian:
    ρ_s + β ρ_β + β² (ρ_ββ − ρ_φβ²/ρ_φφ)/2 + …, the derivatives taken at cos φ = R/e. Sine, R = 1.
    """
    scene, azimuths = Scene(field="sine"), np.arange(96) / 96
    of, rest = _outline(), (azimuths, scene.ku, scene.kv, scene.eye)
    start = np.full(len(azimuths), np.arccos(1 / scene.eye))
    at_rest = {name: derivative(start, 0.0, *rest) for name, derivative in of.items()}
    square = (at_rest["bb"] - at_rest["pb"] ** 2 / at_rest["pp"]) / 2
    rows = []
    for amplitude in betas:
        polar = start
        for _ in range(20):
            polar = polar - of["p"](polar, amplitude, *rest) / of["pp"](polar, amplitude, *rest)
        moved = of["f"](polar, amplitude, *rest) - at_rest["f"]
        first = moved - amplitude * at_rest["b"]
        rows.append([moved, first, first - amplitude**2 * square])
    return np.abs(np.array(rows)).max(axis=2).T


def leaks(scene: Scene, size: int) -> list[tuple[np.ndarray, np.ndarray]]:
    """Return, for each light, (lit although the surface faces away, dark although it faces the light), maps of bool.

    The first: N'·ω > 0 ≥ N·ω. The second: N'·ω ≤ 0 < N·ω. Shadows that B casts are not looked at.
    """
    bumped = render(scene, size, size)
    plain = render(replace(scene, beta=0.0), size, size, stage=bumped.stage)
    cosines = [(bumped.light_cosines(number), plain.light_cosines(number)) for number in range(len(scene.lights))]
    return [((bump > 0) & (flat <= 0), (bump <= 0) & (flat > 0)) for bump, flat in cosines]
