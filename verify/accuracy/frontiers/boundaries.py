"""What displacement moves besides the outline: the edge of A's shadow on the floor, and which surface is in front.

The surface is r(direction) = 1 + βh over the unit sphere, at the origin; the floor is z = 0. Where a ray grazes it, the
least of |X| − r(X/|X|) along the ray is 0. No approximation in β is made.
"""

from collections.abc import Callable
from functools import cache

import numpy as np
from sympy import lambdify

from proofs.engine.program import chain
from proofs.formulas.camera import hit_of_b
from proofs.formulas.chart import chart
from proofs.formulas.half_turns import ordinary
from proofs.formulas.height_fields import HEIGHT_FIELDS, height
from proofs.formulas.symbols import cos_phi, cos_theta, h, k_u, k_v, sin_phi, sin_theta
from renderer import Scene
from renderer.generate.creases import radius_of_parallel
from renderer.kernels import silhouette_of_a
from renderer.scene.raster import Raster
from verify.evaluate.arrays import in_float64
from verify.reference import scene_values

SCENE = Scene(field="sine")
ALONG, FINER, AZIMUTHS, HALVINGS = 161, 8, 61, 46
SPREAD = np.radians(75)  # to either side of straight away from the light


@cache
def _heights(field):
    """Return the function (x, y, z, √(x² + y²), k_u, k_v) → h: the chart's angles do not depend on the length."""
    whole = chain("height_towards", chart, height(HEIGHT_FIELDS[field]))
    return lambdify((cos_theta, sin_theta, cos_phi, sin_phi, k_u, k_v), ordinary(whole.expand(h)), "numpy")


def height_towards(scene: Scene, x: np.ndarray, y: np.ndarray, z: np.ndarray) -> np.ndarray:
    """Return h in the direction (x, y, z) from A's centre; of directions below the floor, too."""
    return _heights(scene.field)(x, y, z, np.hypot(x, y), scene.ku, scene.kv)


def above(scene: Scene, beta: float, points: np.ndarray) -> np.ndarray:
    """Return |X| − r(X/|X|) at points (3, …): how far they are outside the displaced surface, along the radius."""
    return np.linalg.norm(points, axis=0) - 1 - beta * height_towards(scene, *points)


def least_along(function: Callable[[np.ndarray], np.ndarray], low: float, high: float) -> np.ndarray:
    """Return the least value of a function of shares in [low, high]: of a grid, then of finer ones about its best.

    function: arrays (…, n) → the same; one result for each of its leading indices.
    """
    shares, reach = np.linspace(low, high, ALONG), (high - low) / (ALONG - 1)
    for _ in range(FINER):
        best = function(shares).argmin(axis=-1)[..., None]
        middle = np.take_along_axis(np.broadcast_to(shares, (*best.shape[:-1], shares.shape[-1])), best, -1)
        shares, reach = middle + reach * np.linspace(-1, 1, 9), reach / 4
    return function(shares).min(axis=-1)


def smooth_edge(light: np.ndarray, azimuths: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return (s, ds/dβ for h = 1) of the edge of the smooth sphere's shadow, at floor points s (cos α, sin α).

    The line from L to s q passes the centre at s |q × L| / |sq − L|; at the edge that is 1.
    """
    ahead = np.cos(azimuths) * light[0] + np.sin(azimuths) * light[1]
    far = np.dot(light, light)
    sine = far - ahead**2  # |q × L|²
    distance = (-ahead + np.sqrt(ahead**2 + far * (sine - 1))) / (sine - 1)
    gap = np.sqrt(distance**2 - 2 * distance * ahead + far)
    return distance, gap**3 / (np.sqrt(sine) * (far - distance * ahead))


def grazed_height(scene: Scene, light: np.ndarray, azimuths: np.ndarray) -> np.ndarray:
    """Return h at the points where the light's rays touch the smooth sphere on their way to its shadow's edge."""
    floor = _floor(smooth_edge(light, azimuths)[0], azimuths)
    ray = np.array(light)[:, None] - floor
    share = -(floor * ray).sum(axis=0) / (ray**2).sum(axis=0)
    return height_towards(scene, *(floor + share * ray))


def _floor(distance, azimuths):
    return np.array([distance * np.cos(azimuths), distance * np.sin(azimuths), np.zeros(np.shape(distance))])


def away_from(light: np.ndarray, count: int = AZIMUTHS) -> np.ndarray:
    """Return azimuths on the floor about the direction away from a light."""
    return np.arctan2(-light[1], -light[0]) + np.linspace(-SPREAD, SPREAD, count)


def edge(scene: Scene, light: np.ndarray, azimuths: np.ndarray, beta: float) -> np.ndarray:
    """Return s of the outermost edge of the displaced surface's shadow on the floor, for each azimuth, by halving."""
    start, rate = smooth_edge(light, azimuths)
    reach = 1.5 * abs(beta) * rate + 1e-9
    low, high = start - reach, start + reach

    def clear(distance):
        floor = _floor(distance, azimuths)[..., None]
        ray = np.array(light)[:, None, None] - floor
        return least_along(lambda share: above(scene, beta, floor + share * ray), 0.0, 0.5) > 0

    for _ in range(HALVINGS):
        middle = (low + high) / 2
        outside = clear(middle)
        low, high = np.where(outside, low, middle), np.where(outside, middle, high)
    return (low + high) / 2


def shadow_remainders(betas: np.ndarray, light: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return (moved, left): the largest, over the azimuths, of how far the shadow's edge moves on the floor, and of
    what is left of it after the term of first order, h ds/dβ; each an array over `betas`.
    """
    azimuths = away_from(light)
    start, rate = smooth_edge(light, azimuths)
    linear = rate * grazed_height(SCENE, light, azimuths)
    moved = np.array([edge(SCENE, light, azimuths, beta) - start for beta in betas])
    left = moved - np.asarray(betas)[:, None] * linear
    return np.abs(moved).max(axis=1), np.abs(left).max(axis=1)


def outline(scene: Scene, azimuths: np.ndarray, beta: float) -> np.ndarray:
    """Return the image radius of the displaced surface's outline at each azimuth, the largest of a grid in φ."""
    polar = np.linspace(0, np.pi / 2, 2001)[:, None]
    direction = np.sin(polar) * np.cos(azimuths), np.sin(polar) * np.sin(azimuths), np.cos(polar) + 0 * azimuths
    far = 1 + beta * height_towards(scene, *direction)
    return radius_of_parallel(np.sin(polar), np.cos(polar), scene.eye, far).max(axis=0)


def first_surface(scene: Scene, beta: float, side: int) -> np.ndarray:
    """Return which surface a pixel's ray meets first, (side, side): 1 the displaced A, 2 B, 3 the floor.

    The ray is looked at in 400 points; a bulge that it crosses between two of them is missed.
    """
    x, y = np.meshgrid(*Raster(side, side).image_points(scene))
    to_b = in_float64(hit_of_b, scene_values(scene, x=x, y=y))["t_b"]
    found, most = np.where(to_b < 1, 2, 3), 1 + abs(beta)
    near = np.hypot(x, y) < silhouette_of_a(scene.eye, most)
    x, y, last = (plane[near] for plane in (x, y, np.minimum(to_b, 1.0)))
    first = 1 - most / scene.eye  # above that height there is nothing of A
    met = np.zeros(x.shape, bool)
    for share in np.linspace(0, 1, 400):
        t = first + share * np.maximum(0, last - first)
        met |= above(scene, beta, np.array([t * x, t * y, scene.eye * (1 - t)])) < 0
    found[near] = np.where(met, 1, found[near])
    return found
