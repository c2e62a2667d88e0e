"""The chamber of every pixel, row by row, and the rows cut into runs: of one chamber, but for the floor's squares.

A chamber is a set of pixels with the same surface, cast shadows and checker square. Sphere A is an interval of every
row: the test is monotone in |x|, rounding included, so the interval's ends are found by bisection and no guard is
needed. B and the shadows are tested pixel by pixel, inside boxes (`renderer.bounds`).
"""

import numpy as np

from renderer.kernels import (
    checker_row,
    compiled,
    discriminant_of_a,
    shadow_on_a_row,
    shadow_on_b_row,
    shadow_on_floor_row,
    visible_surface_row,
)

NOTHING, SPHERE_A, SPHERE_B, FLOOR = 0, 1, 2, 3
SURFACE_BITS = 3
FIRST_LIGHT_BIT = 2
DARK_BIT = 128
ALL_BITS, ALL_BUT_DARK = np.uint8(255), np.uint8(255 - DARK_BIT)
LONGEST_RUN = 1024  # a run's working rows stay in the second-level cache; shorter ones cost more to begin
BLOCK = 32
LANES = 16
"""Rows are worked on in whole groups of so many pixels, the last of which may lie outside the run: a vector loop does
these at once, and what is left over one by one, at several times the cost. Rows have room for them."""


@compiled
def interval_of_a(x, y, eye, radius, middle, columns):
    """Return [left, right): the pixels of a row whose ray meets A. x ascends, and is negative before `middle`."""
    low, left = np.int64(0), middle
    while low < left:
        tried = (low + left) // 2
        if discriminant_of_a(x[tried], y, eye, radius) >= 0.0:
            left = tried
        else:
            low = tried + 1
    right, high = middle, columns
    while right < high:
        tried = (right + high) // 2
        if discriminant_of_a(x[tried], y, eye, radius) >= 0.0:
            right = tried + 1
        else:
            high = tried
    return left, right


@compiled
def whole_groups(count):
    """Return `count` rounded up to whole groups of LANES."""
    return (count + (LANES - 1)) // LANES * LANES


@compiled
def _within(box, row, start, stop):
    """Return the part of [start, stop) that a box (left, right, top, bottom) leaves of a row; perhaps empty."""
    if row < box[2] or row >= box[3]:
        return start, start
    left, right = max(start, box[0]), min(stop, box[1])
    return left, max(left, right)


@compiled
def run_end(code_row, start, stop, bits):
    """Return where the run that begins at `start`, of one code in these bits, ends: a block of pixels at a time."""
    code, end = code_row[start], start + 1
    while end + BLOCK <= stop:
        differences = code ^ code
        for i in range(np.uint64(end), np.uint64(end + BLOCK)):
            differences |= code_row[i] ^ code
        if differences & bits:
            break
        end += BLOCK
    while end < stop and not (code_row[end] ^ code) & bits:
        end += 1
    return end


@compiled
def _fill(code_row, code, start, stop):
    for i in range(np.uint64(start), np.uint64(stop)):
        code_row[i] = code


@compiled
def _mark(code_row, flag_row, bit, start, stop):
    for i in range(np.uint64(start), np.uint64(stop)):
        code_row[i] = code_row[i] | (bit if flag_row[i] > 0.0 else 0)


@compiled
def _mark_surfaces(x, y, g, middle, box, row, code_row, flag_row):
    """Write the surface of every pixel of a row; B is looked for inside its box alone."""
    eye, radius, bx, by, bz, ball_radius, ball_on, floor_on = g
    columns = code_row.shape[0]
    left, right = interval_of_a(x, y, eye, radius, middle, columns)
    _fill(code_row, np.uint8(FLOOR if floor_on > 0.0 else NOTHING), np.int64(0), columns)
    _fill(code_row, np.uint8(SPHERE_A), left, right)
    left, right = _within(box, row, np.int64(0), columns)
    visible_surface_row(
        x, y, eye, radius, bx, by, bz, ball_radius, ball_on, floor_on, flag_row, left, left + whole_groups(right - left)
    )
    for i in range(np.uint64(left), np.uint64(right)):
        code_row[i] = np.uint8(flag_row[i])


@compiled
def _mark_shadow(x, y, g, surface, light, boxes, row, bit, code_row, flag_row, start, stop):
    """Set a light's bit where another body stands between the surface and the light; return the tests made.

    boxes: where A's shadow on the floor, B's on the floor, B's on A and A's on B can be.
    """
    eye, radius, bx, by, bz, ball_radius, ball_on, _ = g
    lx, ly, lz = light[0], light[1], light[2]
    if surface == SPHERE_B:
        left, right = _within(boxes[3], row, start, stop)
        if left < right:
            reach = left + whole_groups(right - left)
            shadow_on_b_row(
                x, y, eye, bx, by, bz, ball_radius, ball_on, lx, ly, lz, 0.0, 0.0, 0.0, radius, flag_row, left, reach
            )
            _mark(code_row, flag_row, bit, left, right)
        return right - left
    if surface == SPHERE_A:
        left, right = _within(boxes[2], row, start, stop)
        if left < right:
            reach = left + whole_groups(right - left)
            shadow_on_a_row(x, y, eye, radius, lx, ly, lz, bx, by, bz, ball_radius, flag_row, left, reach)
            _mark(code_row, flag_row, bit, left, right)
        return right - left
    left, right = _within(boxes[0], row, start, stop)
    if left < right:
        reach = left + whole_groups(right - left)
        shadow_on_floor_row(x, y, lx, ly, lz, 0.0, 0.0, 0.0, radius, flag_row, left, reach)
        _mark(code_row, flag_row, bit, left, right)
    tests = right - left
    left, right = _within(boxes[1], row, start, stop)
    if left < right:
        reach = left + whole_groups(right - left)
        shadow_on_floor_row(x, y, lx, ly, lz, bx, by, bz, ball_radius, flag_row, left, reach)
        _mark(code_row, flag_row, bit, left, right)
    return tests + right - left


@compiled
def mark_chambers(x, y_of_row, geometry, middle, box_of_b, lights, bits, boxes, codes, top):
    """Write the chamber codes of a band of rows, the first of which is row `top`; return how many shadow tests.

    x: the columns' and LANES more. geometry: (8,), see `renderer.stage.geometry_of`. lights: (n, 3), their bits (n,)
    and boxes (n, 4, 4).
    """
    g = (
        geometry[0], geometry[1], geometry[2], geometry[3], geometry[4], geometry[5], geometry[6], geometry[7]
    )  # fmt: skip
    columns, tests = codes.shape[1], 0
    flag_row, dark_row, dark_at = np.empty(x.shape[0]), np.empty(columns, np.uint8), np.nan
    for row in range(codes.shape[0]):
        y, code_row, here = y_of_row[row], codes[row], top + row
        _mark_surfaces(x, y, g, middle, box_of_b, here, code_row, flag_row)
        if g[7] > 0.0 and (np.floor(y) != dark_at or y == dark_at):  # y matters by its square, and on a grid line
            checker_row(x, y, flag_row, 0, x.shape[0])
            _fill(dark_row, np.uint8(0), np.int64(0), columns)
            _mark(dark_row, flag_row, np.uint8(DARK_BIT), np.int64(0), columns)
            dark_at = np.nan if y == np.floor(y) else np.floor(y)
        start = np.int64(0)  # a literal would compile everything below once more
        while start < columns:
            surface = code_row[start]
            stop = run_end(code_row, start, columns, ALL_BITS)
            if surface == FLOOR:
                for i in range(np.uint64(start), np.uint64(stop)):
                    code_row[i] |= dark_row[i]
            if surface != NOTHING:
                for light in range(lights.shape[0]):
                    tests += _mark_shadow(
                        x,
                        y,
                        g,
                        surface,
                        lights[light],
                        boxes[light],
                        here,
                        bits[light],
                        code_row,
                        flag_row,
                        start,
                        stop,
                    )
            start = stop
    return tests


@compiled
def cut_runs(codes, runs):
    """Write the runs of a band as (row, start, stop, code), A's from the front, the others from the back.

    A run goes on over dark and light squares of the floor; its code is that of its first pixel.

    runs: (rows · columns, 4) int64. Return how many there are of A and of the others.
    """
    on_a, elsewhere, columns = 0, 0, codes.shape[1]
    for row in range(codes.shape[0]):
        code_row, start = codes[row], np.int64(0)
        while start < columns:
            stop = run_end(code_row, start, min(columns, start + LONGEST_RUN), ALL_BUT_DARK)
            if code_row[start] & SURFACE_BITS == SPHERE_A:
                index = on_a
                on_a += 1
            else:
                elsewhere += 1
                index = runs.shape[0] - elsewhere
            runs[index, 0], runs[index, 1], runs[index, 2], runs[index, 3] = row, start, stop, code_row[start]
            start = stop
    return on_a, elsewhere
