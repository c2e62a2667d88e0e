"""Means of the two pipelines' difference over an area lamp's points, or a pixel's: both keep the bound of one sample.

A lobe of reflected directions does not: its rays are made from N', and meet other bodies with another bump.

A bump moves no boundary, so each sample's chambers are the same for both pipelines, and |ΔI| ≤ L|β||Δg| in each
(theorem difference_bound). A mean keeps the bound (theorem mean_keeps_the_bound).
"""

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from proofs.formulas.colour_bounds import light_bound
from renderer import Light, Scene, central, exact, kernels, render
from renderer.generate.kernels import function_of
from renderer.intervals import Interval
from renderer.operations import UNIT
from renderer.picture.differences import enclosed_distance

SIDE, EPS = 256, 1e-2
HALF = 1.5  # of the lamp's side, in radii of A
FAR = 1e3  # along a ray, beyond everything
_bound = function_of(light_bound(0))


class Stacked(NamedTuple):
    """A mean over samples, (height, width, 3) each: numeric − symbolic, its bound, the symbolic picture.

    within: how far the difference can be off. on_a: (height, width), the pixels whose samples all lie on A. open: those
    with a sample that bounds leave open. flips: samples whose chamber is not the same for both.
    """

    difference: np.ndarray
    bound: np.ndarray
    picture: np.ndarray
    within: np.ndarray
    on_a: np.ndarray
    open: np.ndarray
    flips: int

    @property
    def rms(self) -> Interval:
        """The RMS of the difference on A, as it is in exact arithmetic."""
        return enclosed_distance(self.difference, self.within, self.on_a, self.open)[1]

    @property
    def of_the_bound(self) -> float:
        """The largest share of its bound that a difference takes up, infinite where one exceeds a bound of 0."""
        off, most = np.abs(self.difference[self.on_a]), self.bound[self.on_a]
        return float(np.max(np.where(off > 0, off, 0) / np.where((most > 0) | (off > 0), most, 1), initial=0))


def steepest(scene: Scene) -> np.ndarray:
    """Return L of each channel, (3,): Σ over the lights of i (a k_d + k_s p), for Blinn's highlight of a whole p."""
    albedo, of_highlight = np.array(scene.albedo_a), scene.shininess
    return sum(_bound(np.array(light.color), albedo, scene.kd, scene.ks, of_highlight) for light in scene.lights)


def lamp_points(light: Light, count: int) -> list[Light]:
    """Return count² lights on a level square lamp about a light, at the middles of equal squares."""
    steps = HALF * ((2 * np.arange(count) + 1) / count - 1)
    x, y, z = light.position
    return [replace(light, position=(x + across, y + along, z)) for across in steps for along in steps]


def _boxes(samples, count):
    """Return the mean of count² samples a pixel: (…, side, side, 3)."""
    side = samples.shape[-2] // count
    return samples.reshape(*samples.shape[:-3], side, count, side, count, 3).mean(axis=(-4, -2))


def stacked(scene: Scene, lamp: int = 1, pixel: int = 1, side: int = SIDE) -> Stacked:
    """Return the mean over lamp² points of a lamp in place of the first light, and over pixel² points of each pixel."""
    mean, flips, open_ = np.zeros((4, side, side, 3)), 0, np.zeros((side, side), bool)
    for number, light in enumerate(lamp_points(scene.lights[0], lamp), start=1):
        lit = replace(scene, lights=(light, *scene.lights[1:]))
        numeric, symbolic = (
            render(lit, side * pixel, side * pixel, method, bounds=True) for method in (central(EPS), exact())
        )
        bound, there = np.zeros_like(symbolic.rgb), symbolic.stage.on_a
        apart = np.hypot(*(numeric.planes_on_a[4:] - symbolic.planes_on_a[4:]))  # |Δg|: the frame is orthonormal
        bound[there] = abs(lit.beta) * apart[:, None] * steepest(lit)
        off = numeric.bounds + symbolic.bounds
        sample = _boxes(np.array([numeric.rgb - symbolic.rgb, bound, symbolic.rgb, off]), pixel)
        mean += (sample - mean) / number  # the theorem's line, with the share 1/number
        flips += int(np.count_nonzero(numeric.chambers != symbolic.chambers))
        on_a, undecided = (flags.reshape(side, pixel, side, pixel) for flags in (there, numeric.open | symbolic.open))
        open_ |= undecided.any(axis=(1, 3))
    within = mean[3] + 4 * (lamp**2 + pixel**2) * UNIT  # of numbers up to 1, their mean's own roundings
    return Stacked(mean[0], mean[1], mean[2], within, np.array(on_a.all(axis=(1, 3))), open_, flips)


def mirrored(scene: Scene, planes: np.ndarray) -> np.ndarray:
    """Return what the eye's ray, mirrored at N', meets from each pixel of A: either square, A, B or nothing.

    Each has a number. `planes` are a frame's `planes_on_a`; A is the smooth sphere.
    """
    angles, gradient = planes[:4], planes[4:]
    point = np.array(kernels.point_on_a(*angles, scene.radius))
    bumped = np.array(kernels.bumped_normal(*angles, *gradient, scene.beta))
    to_eye = np.array([[0.0], [0.0], [scene.eye]]) - point
    ray = 2 * (bumped * to_eye).sum(axis=0) * bumped - to_eye
    x, y, _ = point - ray * point[2] / np.where(ray[2] < 0, ray[2], 1)
    on_ball = kernels.shadow(*point, *(point + FAR * ray), *scene.ball_center, scene.ball_radius) > 0
    others = (ray * point).sum(axis=0) < 0, on_ball, ray[2] >= 0
    return np.select(others, (2, 3, 4), kernels.checker(x, y) > 0)


def mirrors_apart(scene: Scene) -> tuple[int, int]:
    """Return of how many pixels of A the mirrored rays of the two pipelines meet something else, and A's pixels."""
    one, other = (mirrored(scene, render(scene, SIDE, SIDE, way).planes_on_a) for way in (central(EPS), exact()))
    return int(np.count_nonzero(one != other)), one.size
