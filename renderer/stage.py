"""The stage: the chambers of a scene on a raster, and the colours off sphere A: what a bump does not change.

Chambers depend on neither the height field, β, ε nor the gradient method (theorem bump_moves_no_boundary), so a
`Stage` serves every such change. It takes 1 byte a pixel, 32 bytes a run, and 24 bytes a pixel more once it is drawn
from for the first time.
"""

from functools import cached_property, lru_cache
from typing import NamedTuple

import numpy as np

from renderer.bounds import scene_boxes
from renderer.chambers import FIRST_LIGHT_BIT, LANES, SPHERE_A, SURFACE_BITS, cut_runs, mark_chambers
from renderer.material import material_key, material_of
from renderer.raster import Raster
from renderer.shading import shade_elsewhere
from renderer.threads import run_bands, scratch

MOST_BANDS = 16
SMALLEST_BAND = 2**13  # pixels: below that, starting on a band costs more than drawing it


class Geometry(NamedTuple):
    """The scene's lengths, in the order of the kernels' geometry array; `ball_on` and `floor_on` are 1 or 0."""

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


@lru_cache(maxsize=16)
def prepared(geometry, light_positions, raster):
    """Return (x of the columns and LANES more, y of the rows, lights (n, 3), their bits, boxes): fixed for a scene."""
    wide_x, y = raster.image_points(geometry, beyond=LANES)
    on = [number for number, position in enumerate(light_positions) if position is not None]
    lights = np.array([light_positions[n] for n in on], np.float64).reshape(-1, 3)
    bits = np.array([1 << (FIRST_LIGHT_BIT + n) for n in on], np.uint8)
    return wide_x, y, lights, bits, scene_boxes(wide_x[: raster.shape[1]], y, geometry, lights)


class Band(NamedTuple):
    """Some rows of the raster: the first row, their y, and their runs (row counted from the band's first).

    A run is (row, start, stop, chamber code), at most LONGEST_RUN pixels; those on sphere A, and the others. On the
    floor the code is that of its first pixel: squares may change along it.
    """

    top: int
    y: np.ndarray
    runs_on_a: np.ndarray
    runs_elsewhere: np.ndarray


def band_rows(rows, columns):
    """Return how many rows a band has: MOST_BANDS bands, unless they would be smaller than SMALLEST_BAND."""
    return min(rows, max(-(-rows // MOST_BANDS), -(-SMALLEST_BAND // columns)))


class Stage:
    """The chambers of a scene on a raster: what every gradient method, field, β and ε shares.

    x: (width,) image points of the columns; wide_x: LANES more. bands: a list of Band. chambers: (height, width)
    uint8. Bits 0–1 are the surface (0 none, 1 A, 2 B, 3 floor), bit 2 + i says that light i
    is occluded by another body (0 for a light that is off), bit 7 that the floor square is dark.
    """

    def __init__(self, scene, raster: Raster):
        """Prepare the bands; `fill` computes one."""
        self.geometry, self.light_positions, self.raster = geometry_of(scene), light_positions_of(scene), raster
        fixed = prepared(self.geometry, self.light_positions, raster)
        self.wide_x, self._y, self._lights, self._bits, self._boxes = fixed
        self.x = self.wide_x[: raster.shape[1]]
        self.chambers = np.empty(raster.shape, np.uint8)
        self.numbers = np.array(self.geometry)
        self._middle = int(self.x.searchsorted(0.0))
        self._rows = band_rows(*raster.shape)
        self.bands = [None] * -(-raster.shape[0] // self._rows)
        self._tests = [0] * len(self.bands)
        self._elsewhere = (None, None)

    def fill(self, number):
        """Compute the chambers and the runs of a band, and return it."""
        top = number * self._rows
        rows = slice(top, top + self._rows)
        codes, y, (box_of_b, boxes) = self.chambers[rows], self._y[rows], self._boxes
        self._tests[number] = mark_chambers(
            self.wide_x, y, self.numbers, self._middle, box_of_b, self._lights, self._bits, boxes, codes, top
        )
        runs = scratch("runs", (self._rows * len(self.x), 4), np.int64)
        on_a, elsewhere = cut_runs(codes, runs)
        self.bands[number] = Band(top, y, runs[:on_a].copy(), runs[len(runs) - elsewhere :].copy())
        return self.bands[number]

    def place(self, band):
        """Return where a band lies, as the shaders take it: x of the columns, y of the rows, first row, lengths."""
        return self.wide_x, band.y, band.top, self.numbers

    def elsewhere(self, scene, threads, counts):
        """Return the colours off A, (3, height, width), undefined on A: drawn when a scene's shading first needs them.

        counts: (bands, 3), what is drawn for it is added.
        """
        material = material_of(scene)
        key = material_key(material)
        if self._elsewhere[0] != key:
            rgb = np.empty((3, *self.raster.shape))

            def draw(number):
                band = self.bands[number]
                shade_elsewhere(band.runs_elsewhere, *self.place(band), *material, rgb, counts[number], self.chambers)

            run_bands(draw, len(self.bands), threads)
            self._elsewhere = (key, rgb)
        return self._elsewhere[1]

    def serves(self, scene, raster):
        """Return whether these are the chambers of the scene on the raster."""
        made_for = (self.geometry, self.light_positions, self.raster)
        return made_for == (geometry_of(scene), light_positions_of(scene), raster)

    @property
    def shadow_tests(self):
        """How many segments were tested for a body in their way."""
        return int(sum(self._tests))

    @cached_property
    def pixel_counts(self):
        """(256,) int: how many pixels have each chamber code."""
        return np.bincount(self.chambers.ravel(), minlength=256)

    @property
    def on_a(self):
        """(height, width) bool: the pixels of sphere A."""
        return (self.chambers & SURFACE_BITS) == SPHERE_A
