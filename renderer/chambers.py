"""The first stage: the chamber of every pixel, and the rows cut into runs of one chamber.

A chamber is a set of pixels with the same surface, cast shadows and checker square. Chambers depend on neither the
height field, β, ε nor the gradient method (theorem bump_moves_no_boundary), so a `Stage` serves every such change.
"""

from functools import cached_property
from typing import NamedTuple

import numpy as np

from renderer.bounds import scene_boxes
from renderer.kernels import (
    checker_row,
    compiled,
    shadow_on_a_row,
    shadow_on_b_row,
    shadow_on_floor_row,
    surface_without_b_row,
    visible_surface_row,
)
from renderer.raster import Raster

NOTHING, SPHERE_A, SPHERE_B, FLOOR = 0, 1, 2, 3
SURFACE_BITS = 3
FIRST_LIGHT_BIT = 2
DARK_BIT = 128
LONGEST_RUN = 512  # a run's working rows stay in the first-level cache


class Geometry(NamedTuple):
    """The scene's lengths, as the kernels take them; `ball_on` and `floor_on` are 1 or 0."""

    eye: float
    radius: float
    ball_x: float
    ball_y: float
    ball_z: float
    ball_radius: float
    ball_on: float
    floor_on: float


def geometry_of(scene):
    """Return the Geometry of a scene. An absent B is a unit ball far behind the floor that no kernel asks about."""
    center, ball_radius = (scene.ball_center, scene.ball_radius) if scene.ball else ((0.0, 0.0, 0.0), 1.0)
    return Geometry(scene.eye, scene.radius, *center, ball_radius, float(scene.ball), float(scene.floor))


def light_positions_of(scene):
    """Return the position of every light, None for one that is off: what the shadows depend on."""
    return tuple(None if light.color is None else light.position for light in scene.lights)


@compiled
def _mark(code_row, flag_row, bit, start, stop):
    for i in range(np.uint64(start), np.uint64(stop)):
        code_row[i] = code_row[i] | (bit if flag_row[i] > 0.0 else 0)


@compiled
def _within(box, row, start, stop):
    """Return the part of [start, stop) that a box (left, right, top, bottom) leaves of a row; perhaps empty."""
    if row < box[2] or row >= box[3]:
        return start, start
    left, right = max(start, box[0]), min(stop, box[1])
    return left, max(left, right)


@compiled
def _mark_shadows(x, y, g, surface, position, boxes, row, bit, code_row, flag_row, start, stop):
    """Set a light's bit where another body stands between the surface and the light.

    boxes: where A's shadow on the floor, B's on the floor and B's on A can be.
    """
    lx, ly, lz = position[0], position[1], position[2]
    bx, by, bz = g.ball_x, g.ball_y, g.ball_z
    if surface == SPHERE_B:
        shadow_on_b_row(
            x,
            y,
            g.eye,
            bx,
            by,
            bz,
            g.ball_radius,
            g.ball_on,
            lx,
            ly,
            lz,
            0.0,
            0.0,
            0.0,
            g.radius,
            flag_row,
            start,
            stop,
        )
        _mark(code_row, flag_row, bit, start, stop)
    elif surface == SPHERE_A and g.ball_on > 0.0:
        left, right = _within(boxes[2], row, start, stop)
        shadow_on_a_row(x, y, g.eye, g.radius, lx, ly, lz, bx, by, bz, g.ball_radius, flag_row, left, right)
        _mark(code_row, flag_row, bit, left, right)
    elif surface == FLOOR:
        left, right = _within(boxes[0], row, start, stop)
        shadow_on_floor_row(x, y, lx, ly, lz, 0.0, 0.0, 0.0, g.radius, flag_row, left, right)
        _mark(code_row, flag_row, bit, left, right)
        if g.ball_on > 0.0:
            left, right = _within(boxes[1], row, start, stop)
            shadow_on_floor_row(x, y, lx, ly, lz, bx, by, bz, g.ball_radius, flag_row, left, right)
            _mark(code_row, flag_row, bit, left, right)


@compiled
def _mark_surfaces(x, y, g, box, row, surface_row):
    """Write the surface of every pixel of a row; B is looked for inside its box alone."""
    columns = x.shape[0]
    left, right = _within(box, row, 0, columns)
    if g.ball_on == 0.0:
        left, right = 0, 0
    surface_without_b_row(x, y, g.eye, g.radius, g.floor_on, surface_row, 0, left)
    visible_surface_row(
        x,
        y,
        g.eye,
        g.radius,
        g.ball_x,
        g.ball_y,
        g.ball_z,
        g.ball_radius,
        g.ball_on,
        g.floor_on,
        surface_row,
        left,
        right,
    )
    surface_without_b_row(x, y, g.eye, g.radius, g.floor_on, surface_row, right, columns)


@compiled
def _mark_chambers(x, y_of_row, g, positions, bits, boxes, codes, top):
    """Write the chamber codes of a band of rows, the first of which is row `top` of the raster."""
    box_of_b, shadow_boxes = boxes
    columns = x.shape[0]
    surface_row, flag_row = np.empty(columns), np.empty(columns)
    for row in range(codes.shape[0]):
        y, code_row, here = y_of_row[row], codes[row], top + row
        _mark_surfaces(x, y, g, box_of_b, here, surface_row)
        start = 0
        while start < columns:
            surface = int(surface_row[start])
            stop = start + 1
            while stop < columns and surface_row[stop] == surface_row[start]:
                stop += 1
            code_row[start:stop] = surface
            if surface == FLOOR:
                checker_row(x, y, flag_row, start, stop)
                _mark(code_row, flag_row, DARK_BIT, start, stop)
            for light in range(positions.shape[0]):
                _mark_shadows(
                    x,
                    y,
                    g,
                    surface,
                    positions[light],
                    shadow_boxes[light],
                    here,
                    bits[light],
                    code_row,
                    flag_row,
                    start,
                    stop,
                )
            start = stop


@compiled
def _cut_row(code_row, runs, first, row):
    """Append the runs of one row from index `first` on, as (row, start, stop, code); return the next free index."""
    start, columns = 0, code_row.shape[0]
    while start < columns:
        stop, last = start + 1, min(columns, start + LONGEST_RUN)
        while stop < last and code_row[stop] == code_row[start]:
            stop += 1
        runs[first, 0], runs[first, 1], runs[first, 2], runs[first, 3] = row, start, stop, code_row[start]
        first += 1
        start = stop
    return first


@compiled
def _cut_runs(codes):
    """Return the runs of a band of rows, (n, 4) int64."""
    runs = np.empty((codes.shape[0] * codes.shape[1], 4), np.int64)
    count = 0
    for row in range(codes.shape[0]):
        count = _cut_row(codes[row], runs, count, row)
    return runs[:count].copy()


class Band(NamedTuple):
    """Some rows of the raster: the first row, their y, their runs (row counted from the band's first), A's runs."""

    top: int
    y: np.ndarray
    runs: np.ndarray
    runs_on_a: np.ndarray


class Stage:
    """The chambers of a scene on a raster: what every gradient method, field, β and ε shares.

    chambers: (height, width) uint8. Bits 0–1 are the surface (0 none, 1 A, 2 B, 3 floor), bit 2 + i says that light i
    is occluded by another body (0 for a light that is off), bit 7 that the floor square is dark. bands: a list of Band.
    """

    def __init__(self, scene, raster: Raster, run_bands):
        """Compute the chambers; `run_bands(work, count)` calls work(band number) for every band."""
        self.geometry, self.light_positions, self.raster = geometry_of(scene), light_positions_of(scene), raster
        self.x, y = raster.image_points(scene)
        self.chambers = np.zeros(raster.shape, np.uint8)
        on = [number for number, light in enumerate(scene.lights) if light.color is not None]
        positions = np.array([scene.lights[n].position for n in on], np.float64).reshape(-1, 3)
        bits = np.array([1 << (FIRST_LIGHT_BIT + n) for n in on], np.uint8)
        boxes = scene_boxes(self.x, y, self.geometry, positions)
        rows_in_band = band_rows(raster)
        tops = range(0, raster.shape[0], rows_in_band)
        bands = [None] * len(tops)

        def work(number):
            rows = slice(tops[number], tops[number] + rows_in_band)
            codes = self.chambers[rows]
            _mark_chambers(self.x, y[rows], self.geometry, positions, bits, boxes, codes, tops[number])
            runs = _cut_runs(codes)
            runs_on_a = runs[(runs[:, 3] & SURFACE_BITS) == SPHERE_A]
            bands[number] = Band(tops[number], y[rows], runs, runs_on_a)

        run_bands(work, len(tops))
        self.bands = bands

    def serves(self, scene, raster):
        """Return whether these are the chambers of the scene on the raster."""
        made_for = (self.geometry, self.light_positions, self.raster)
        return made_for == (geometry_of(scene), light_positions_of(scene), raster)

    @cached_property
    def pixel_counts(self):
        """(256,) int: how many pixels have each chamber code, added up over the runs."""
        counts = np.zeros(256, np.int64)
        for band in self.bands:
            np.add.at(counts, band.runs[:, 3], band.runs[:, 2] - band.runs[:, 1])
        return counts

    @property
    def on_a(self):
        """(height, width) bool: the pixels of sphere A."""
        return (self.chambers & SURFACE_BITS) == SPHERE_A


def band_rows(raster):
    """Return how many rows a band has: about 2^14 pixels, so that its planes stay in the second-level cache."""
    return max(1, min(raster.shape[0], 2**14 // raster.shape[1]))
