"""Without Numba: the renderer's loops over pixels as NumPy's, and its own shading on whole chambers at once.

A compiled shader draws a run of pixels in
a row; interpreted, beginning on one costs more than a thousand pixels. So the pixels of a chamber in a band, wherever
they stand, are put into long rows of their own, and the same shader draws these. Bit for bit the same pictures.
"""

import functools
import sys

import numpy as np

import renderer.render  # noqa: F401  (`take_over` needs it)
from renderer import shaders, shading, sphere_a, stage
from renderer.chambers import DARK_BIT, FLOOR, LANES, LONGEST_RUN, SPHERE_A, SPHERE_B, SURFACE_BITS
from renderer.kernels import checker_row, shadow_on_a_row, shadow_on_b_row, shadow_on_floor_row, visible_surface_row


def cut_runs(codes, runs):
    """Write the runs of a band as (row, start, stop, code), A's from the front, the others from the back.

    As `renderer.chambers.cut_runs`, but runs may be as long as a row, and end at every square of the floor. Return how
    many there are of A and of the others.
    """
    begins = np.ones(codes.shape, bool)
    begins[:, 1:] = codes[:, 1:] != codes[:, :-1]
    first = np.flatnonzero(begins)
    row, start = np.divmod(first, codes.shape[1])
    cut = np.stack([row, start, start + np.diff(first, append=codes.size), codes.ravel()[first]], axis=1)
    on_a = (cut[:, 3] & SURFACE_BITS) == SPHERE_A
    count = int(on_a.sum())
    runs[:count], runs[len(runs) - len(cut) + count :] = cut[on_a], cut[~on_a]
    return count, len(cut) - count


def _pixels(runs):
    """Return (row, column) of every pixel of some runs."""
    lengths = runs[:, 2] - runs[:, 1]
    before = np.cumsum(lengths) - lengths
    return np.repeat(runs[:, 0], lengths), np.arange(lengths.sum()) + np.repeat(runs[:, 1] - before, lengths)


def copy_runs(runs, top, source, rgb):
    """Copy the colours of a band's runs from one picture to another, both (3, height, width)."""
    row, column = _pixels(runs)
    rgb[:, top + row, column] = source[:, top + row, column]


def long_rows(runs):
    """Yield (chamber code, rows, columns) of at most LONGEST_RUN pixels of one chamber each, wherever they stand."""
    for code in np.unique(runs[:, 3]):
        row, column = _pixels(runs[runs[:, 3] == code])
        for first in range(0, len(row), LONGEST_RUN):
            part = slice(first, first + LONGEST_RUN)
            yield code, row[part], column[part]


def by_chamber(shader, targets, codes=None):
    """Return a shader that draws a band's pixels chamber by chamber: `shader` is given each as one row of a picture.

    targets: where among its arguments its pictures are, (channels, height, width) or None. codes: where the chambers
    are, if it takes them.
    """

    @functools.wraps(shader)
    def draw(runs, x, y_of_row, top, *arguments):
        for code, row, column in long_rows(runs):
            whole = np.arange(-(-len(row) // LANES) * LANES).clip(max=len(row) - 1)  # to whole groups: the last again
            given = list(arguments)
            for n in targets:
                given[n] = None if arguments[n] is None else np.empty((len(arguments[n]), 1, len(row)))
            if codes is not None:
                given[codes] = np.full((1, len(row)), code, np.uint8)
            one = np.array([[0, 0, len(row), code]])
            shader(one, x[column[whole]], [y_of_row[row[whole]]], 0, *given)
            for n in targets:
                if arguments[n] is not None:
                    arguments[n][:, top + row, column] = given[n][:, 0]

    return draw


def _inside(boxes, row, column):
    """Return which pixels are in a box (left, right, top, bottom)."""
    left, right, top, bottom = boxes
    return (column >= left) & (column < right) & (row >= top) & (row < bottom)


def mark_chambers(x, y_of_row, geometry, middle, box_of_b, lights, bits, boxes, codes, top):
    """Write the chamber codes of a band of rows, the first of which is row `top`; return how many shadow tests.

    As `renderer.chambers.mark_chambers`, without looking for A's interval in each row.
    """
    row, column = (place.ravel() for place in np.indices(codes.shape))
    x, y, flag = x[column], y_of_row[row], np.empty(codes.size)
    visible_surface_row(x, y, *geometry, flag, 0, codes.size)
    surface, code = flag.astype(np.uint8), flag.astype(np.uint8)
    checker_row(x, y, flag, 0, codes.size)
    code[(surface == FLOOR) & (flag > 0.0)] |= DARK_BIT
    eye, radius, bx, by, bz, ball_radius, ball_on, _ = geometry
    a, b, tests = (0.0, 0.0, 0.0, radius), (bx, by, bz, ball_radius), 0
    cases = (
        (FLOOR, shadow_on_floor_row, (), a),
        (FLOOR, shadow_on_floor_row, (), b),
        (SPHERE_A, shadow_on_a_row, (eye, radius), b),
        (SPHERE_B, shadow_on_b_row, (eye, *b, ball_on), a),
    )
    for light, bit, box_of in zip(lights, bits, boxes, strict=True):
        for (number, kernel, before, body), box in zip(cases, box_of, strict=True):
            here = np.flatnonzero((surface == number) & _inside(box, top + row, column))
            kernel(x[here], y[here], *before, *light, *body, flag, 0, len(here))
            code[here[flag[: len(here)] > 0.0]] |= bit
            tests += len(here)
    codes[:] = code.reshape(codes.shape)
    return tests


def take_over():
    """Put these functions in the place of the renderer's own."""
    render = sys.modules["renderer.render"]  # the package gives its function that name
    stage.mark_chambers, stage.cut_runs = mark_chambers, cut_runs
    render.copy_runs = copy_runs
    stage.shade_elsewhere = render.shade_elsewhere = by_chamber(shading.shade_elsewhere, (-3,), codes=-1)
    sphere_a.draw_flat = by_chamber(shaders.draw_flat, (-3, -2))
    sphere_a.SHADERS = {
        field: {way: by_chamber(shader, (-3, -2)) for way, shader in ways.items()}
        for field, ways in shaders.SHADERS.items()
    }
