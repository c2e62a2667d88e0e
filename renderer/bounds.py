"""Where on the raster a sphere or a shadow can be: boxes that spare the per-pixel tests outside them.

A box is generous, by GUARD pixels and a share of its own coordinates, so that rounding cannot leave a pixel out; where
a bound does not exist the box is the whole raster.
"""

import math

import numpy as np

from renderer.kernels import shadow_clearance, tangent_interval

GUARD = 2
RELATIVE_GUARD = 1e-6
EVERYWHERE = (-math.inf, math.inf)
EMPTY = (0, 0, 0, 0)


def _interval(apex, apex_height, center, center_height, radius, levels, eye=math.inf):
    """Return the hull of what lies between the tangents at the given heights: in the world, or seen from the eye."""
    if apex_height - center_height <= radius * (1 + RELATIVE_GUARD):
        return EVERYWHERE
    ends = [
        coordinate / (1.0 - level / eye)
        for level in levels
        for coordinate in tangent_interval(apex, apex_height, center, center_height, radius, level)
    ]
    if not all(map(math.isfinite, ends)):
        return EVERYWHERE
    room = RELATIVE_GUARD * (max(map(abs, ends)) + abs(center) + abs(apex) + radius)
    return min(ends) - room, max(ends) + room


def _indices(ascending, interval):
    """Return (first, last + 1) of the ascending coordinates that lie in the interval, GUARD more on either side."""
    first, last = ascending.searchsorted(interval)
    return max(0, int(first) - GUARD), min(len(ascending), int(last) + GUARD)


def box(x, y, apex, center, radius, levels, eye):
    """Return (left, right, top, bottom), half-open indices: what a sphere hides from `apex`, between two heights.

    x ascends, y descends: the raster's image points. levels: heights, all below the apex and the eye.
    """
    if min(apex[2], eye) <= max(levels):
        return 0, len(x), 0, len(y)
    spans = [_interval(apex[axis], apex[2], center[axis], center[2], radius, levels, eye) for axis in (0, 1)]
    left, right = _indices(x, spans[0])
    low, high = _indices(y[::-1], spans[1])
    return left, right, len(y) - high, len(y) - low


def _out_of_reach(height, radius, lowest, highest):
    """Return whether a sphere stands wholly above or below every segment between two heights."""
    room = RELATIVE_GUARD * (abs(height) + radius + abs(lowest) + abs(highest))
    return height + radius < lowest - room or height - radius > highest + room


def _casts(light, body, ball):
    """Return whether a body, (center, radius), can stand between the light and some point of a ball."""
    return not shadow_clearance(*light, *body[0], body[1], *ball[0], ball[1]) > RELATIVE_GUARD


def lowest_on_a(g, light):
    """Return a height below which B's shadow on A is not seen: that of A's horizon, or where the shadow's hull ends."""
    lowest = g.radius * (g.radius / g.eye) * (1 - RELATIVE_GUARD)  # theorem kink_loci: cos φ > R/e
    for _ in range(2):
        levels, far = (lowest, g.radius), 0.0
        for axis, center in enumerate((g.ball_x, g.ball_y)):
            ends = _interval(light[axis], light[2], center, g.ball_z, g.ball_radius, levels)
            far += max(abs(end) for end in ends) ** 2
        if far < g.radius**2:
            lowest = max(lowest, math.sqrt(g.radius**2 - far) * (1 - RELATIVE_GUARD))
    return lowest


def shadow_boxes(x, y, g, light):
    """Return (4, 4): where A's shadow on the floor, B's on the floor, B's on A and A's on B can be.

    A box is empty where there is no B, no floor, or where no segment from the light to the surface meets the body.
    """
    a, b = ((0.0, 0.0, 0.0), g.radius), ((g.ball_x, g.ball_y, g.ball_z), g.ball_radius)
    seen = {"floor": (0.0, 0.0), "a": (0.0, g.radius), "b": (b[0][2] - b[1], b[0][2] + b[1])}
    boxes = np.array([EMPTY] * 4, np.int64)
    for index, ((center, radius), surface) in enumerate(((a, "floor"), (b, "floor"), (b, "a"), (a, "b"))):
        low, high = seen[surface]
        needs = (index in (2, 3) or g.floor_on) and (index == 0 or g.ball_on)
        if not needs or _out_of_reach(center[2], radius, min(low, light[2]), max(high, light[2])):
            continue
        if surface != "floor" and not _casts(light, (center, radius), b if surface == "b" else a):
            continue
        above = light[2] > high and high < g.eye and surface != "b"
        if above and surface == "a":
            low = lowest_on_a(g, light)
        boxes[index] = box(x, y, light, center, radius, (low, high), g.eye) if above else (0, len(x), 0, len(y))
    return boxes


def scene_boxes(x, y, g, lights):
    """Return (the box of B, empty without one; the (lights, 4, 4) boxes of the shadows), int64."""
    of_b = EMPTY
    if g.ball_on:
        of_b = box(x, y, (0.0, 0.0, g.eye), (g.ball_x, g.ball_y, g.ball_z), g.ball_radius, (0.0,), g.eye)
    shadows = [shadow_boxes(x, y, g, light) for light in lights.tolist()]
    return np.array(of_b, np.int64), np.array(shadows, np.int64).reshape(-1, 4, 4)
