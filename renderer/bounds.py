"""Where on the raster a sphere or a shadow can be: boxes that spare the per-pixel tests outside them.

A box is generous, by GUARD pixels and a share of its own coordinates, so that rounding cannot leave a pixel out; where
a bound does not exist the box is the whole raster.
"""

import math

import numpy as np

from renderer.kernels import tangent_interval

GUARD = 2
RELATIVE_GUARD = 1e-6
EVERYWHERE = (-math.inf, math.inf)


def _image_interval(apex, apex_height, center, center_height, radius, levels, eye):
    """Return the hull, in image coordinates, of what lies between the tangents at the given heights."""
    if apex_height - center_height <= radius * (1 + RELATIVE_GUARD):
        return EVERYWHERE
    ends = [
        coordinate * eye / (eye - level)
        for level in levels
        for coordinate in tangent_interval(apex, apex_height, center, center_height, radius, level)
    ]
    if not all(map(math.isfinite, ends)):
        return EVERYWHERE
    room = RELATIVE_GUARD * (max(map(abs, ends)) + abs(center) + abs(apex) + radius)
    return min(ends) - room, max(ends) + room


def _indices(ascending, interval):
    """Return (first, last + 1) of the ascending coordinates that lie in the interval, GUARD more on either side."""
    first, last = np.searchsorted(ascending, interval)
    return max(0, int(first) - GUARD), min(len(ascending), int(last) + GUARD)


def box(x, y, apex, center, radius, levels, eye):
    """Return (left, right, top, bottom), half-open indices: what a sphere hides from `apex`, between two heights.

    x ascends, y descends: the raster's image points. levels: heights, all below the apex and the eye.
    """
    if min(apex[2], eye) <= max(levels):
        return 0, len(x), 0, len(y)
    spans = [_image_interval(apex[axis], apex[2], center[axis], center[2], radius, levels, eye) for axis in (0, 1)]
    left, right = _indices(x, spans[0])
    low, high = _indices(y[::-1], spans[1])
    return left, right, len(y) - high, len(y) - low


def scene_boxes(x, y, g, positions):
    """Return (box of B, (lights, 3, 4) boxes of the shadows of A on the floor, of B on the floor, of B on A)."""
    eye, a, b = (0.0, 0.0, g.eye), (0.0, 0.0, 0.0), (g.ball_x, g.ball_y, g.ball_z)
    everywhere = (0, len(x), 0, len(y))
    of_b = box(x, y, eye, b, g.ball_radius, (0.0,), g.eye)
    shadows = np.empty((len(positions), 3, 4), np.int64)
    for number, light in enumerate(positions):
        shadows[number, 0] = box(x, y, light, a, g.radius, (0.0,), g.eye)
        shadows[number, 1] = box(x, y, light, b, g.ball_radius, (0.0,), g.eye)
        above = light[2] > g.radius and g.radius < g.eye
        shadows[number, 2] = box(x, y, light, b, g.ball_radius, (0.0, g.radius), g.eye) if above else everywhere
    return np.array(of_b, np.int64), shadows
