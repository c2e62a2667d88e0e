"""A rendered picture, with what is known of its pixels; views are made when they are first asked for."""

from functools import cached_property

import numpy as np

from renderer.gradients import chart_of, empty_planes, fill_angles, fill_gradient
from renderer.kernels import FIELDS, slope_row


class Frame:
    """A picture of a scene.

    rgb: (height, width, 3) float64, linear light in [0, 1], row 0 at the top (a view of three planes).
    chambers: (height, width) uint8, see `renderer.chambers.Stage`. work: what was computed, by kind.
    scene, raster, method, stage: what it was made from.
    """

    def __init__(self, scene, raster, method, stage, planes, work):
        self.scene, self.raster, self.method, self.stage, self.work = scene, raster, method, stage, work
        self._planes = planes

    @property
    def rgb(self):
        """(height, width, 3) float64 in [0, 1]."""
        return np.moveaxis(self._planes, 0, -1)

    @property
    def chambers(self):
        """(height, width) uint8."""
        return self.stage.chambers

    @cached_property
    def surface_data(self):
        """What is known of sphere A: a dict of (height, width) float64 planes, NaN off A.

        u, v, h, h_u, h_v (by the frame's method), slope, kink (1 or 0), and straddling (1 or 0) for a difference.
        """
        names = ["u", "v", "h", "h_u", "h_v", "slope", "kink", *(["straddling"] if self.method.eps else [])]
        data = {name: np.full(self.raster.shape, np.nan) for name in names}
        for band in self.stage.bands:
            rows = slice(band.top, band.top + len(band.y))
            for name, plane in self._band_data(band).items():
                self._copy_runs(band, plane, data[name][rows])
        return data

    def planes(self, band):
        """Return the band's Planes: angles, and the gradient by the frame's method, on sphere A."""
        planes = empty_planes(len(band.y), self.raster.shape[1])
        fill_angles(self.stage, band, planes)
        fill_gradient(self.scene, self.method, band, planes)
        return planes

    def _band_data(self, band):
        scene, kernels, runs = self.scene, FIELDS[self.scene.field], band.runs_on_a
        planes = self.planes(band)
        u, v = chart_of(band, planes)
        data = {"u": u, "v": v, "h_u": planes.h_u, "h_v": planes.h_v}
        for name in ("h", "slope", "kink", "straddling"):
            data[name] = np.empty_like(u)
        kernels["height"](runs, u, v, scene.ku, scene.kv, data["h"])
        kernels["kink"](runs, planes.sin_phi, u, v, scene.ku, scene.kv, data["kink"])
        for row, start, stop, _ in runs:
            slope_row(planes.h_u[row], planes.h_v[row], data["slope"][row], start, stop)
        if self.method.eps:
            kernels["straddling"](runs, u, v, scene.ku, scene.kv, self.method.eps, data["straddling"])
        else:
            del data["straddling"]
        return data

    @staticmethod
    def _copy_runs(band, source, target):
        for row, start, stop, _ in band.runs_on_a:
            target[row, start:stop] = source[row, start:stop]

    @property
    def kink(self):
        """(height, width) bool: a crease factor of the field is below 0.03 in magnitude, or the pole; False off A."""
        return self.surface_data["kink"] == 1.0

    @property
    def slope(self):
        """(height, width) float64: √(h_u² + h_v²) by the frame's method; 0 off A."""
        return np.nan_to_num(self.surface_data["slope"])

    @property
    def straddling(self):
        """(height, width) bool: a crease lies strictly within ε of the pixel in u or in v; False if exact."""
        data = self.surface_data.get("straddling")
        return np.zeros(self.raster.shape, bool) if data is None else data == 1.0
