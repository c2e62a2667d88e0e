"""Boxes on the image plane around a sphere or a shadow, which spare the per-pixel tests outside them.

A box is (left, right, low, high) in image points, generous by a share of its own coordinates, so that rounding cannot
leave a pixel out; where a bound does not exist the box is the whole plane.
"""

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from renderer.kernels import shadow_clearance, tangent_interval
from renderer.scene.scene import Geometry

Box = tuple[float, float, float, float]
GUARD = 1e-6
EVERYWHERE = (-math.inf, math.inf)
EMPTY = (math.inf, -math.inf) * 2


def box(apex: Sequence[float], center: Sequence[float], radius: float, levels: Sequence[float], eye: float) -> Box:
    """Return the box of the points that a sphere hides from `apex` between two heights below the apex and the eye.

    Along either axis it is the hull of the intervals between the tangents at these heights, seen from the eye.
    """
    if min(apex[2], eye) <= max(levels) or apex[2] - center[2] <= radius * (1 + GUARD):
        return EVERYWHERE * 2
    sides: Any = ()
    for axis in (0, 1):
        ends = [
            coordinate / (1.0 - level / eye)
            for level in levels
            for coordinate in tangent_interval(apex[axis], apex[2], center[axis], center[2], radius, level)
        ]
        room = GUARD * (max(map(abs, ends)) + abs(center[axis]) + abs(apex[axis]) + radius)
        sides += (min(ends) - room, max(ends) + room) if all(map(math.isfinite, ends)) else EVERYWHERE
    return sides


def _casts(light, body, ball):
    """Return whether a body, (center, radius), can stand between the light and some point of a ball."""
    with np.errstate(all="ignore"):
        return not shadow_clearance(*light, *body[0], body[1], *ball[0], np.float64(ball[1])) > GUARD


@lru_cache(maxsize=64)
def shadow_boxes(g: Geometry) -> tuple[tuple[Box, ...], ...]:
    """Return of each light where A's shadow on the floor, B's on the floor, B's on A and A's on B can be.

    A box is empty where there is no B, no floor, no light, or no segment from it to the surface that meets the body.
    """
    a, b = ((0.0, 0.0, 0.0), g.radius), (g.ball[:3], g.ball[3])
    floor, lowest = (None, 0.0, 0.0), g.radius * (g.radius / g.eye) * (1 - GUARD)  # theorem visible_iff: cos φ > R/e
    on_a, on_b = (a, lowest, g.radius), (b, b[0][2] - b[1], b[0][2] + b[1])
    cases = ((a, floor, g.floor_on), (b, floor, g.floor_on and g.ball_on), (b, on_a, g.ball_on), (a, on_b, g.ball_on))

    def boxes(light):
        return tuple(_shadow_box(g.eye, light, body, *surface) if needed else EMPTY for body, surface, needed in cases)

    return tuple(boxes(light) if light else () for light in g.lights)


def _shadow_box(eye, light, body, ball, low, high):
    """Return the box of a body's shadow between two heights of a surface: of a ball, or, where that is None, the floor.

    Empty where the body stands wholly above or below every segment from there to the light.
    """
    (*_, height), radius = body
    room = GUARD * (abs(height) + radius + abs(low) + abs(high) + abs(light[2]))
    above, below = height - radius > max(high, light[2]) + room, height + radius < min(low, light[2]) - room
    if above or below or (ball and not _casts(light, body, ball)):
        return EMPTY
    return box(light, *body, (low, high), eye)


@lru_cache(maxsize=64)
def ball_box(g: Geometry) -> Box:
    """Return where B can be seen: empty without one."""
    return box((0.0, 0.0, g.eye), g.ball[:3], g.ball[3], (0.0,), g.eye) if g.ball_on else EMPTY
