"""A rendered picture, with what is known of its pixels; views are made when they are first asked for."""

from functools import cached_property

import numpy as np

from renderer.kernels import FIELDS, chart_row, slope_row
from renderer.shading import WORK
from renderer.sphere_a import bump_of


class Frame:
    """A picture of a scene.

    rgb: (height, width, 3) float64, linear light in [0, 1], row 0 at the top (a view of three planes).
    chambers: (height, width) uint8, see `renderer.stage.Stage`. scene, raster, method, stage: what it was made from.
    """

    def __init__(self, scene, raster, method, stage, planes, add_up):
        self.scene, self.raster, self.method, self.stage = scene, raster, method, stage
        self._planes, self._add_up = planes, add_up

    @cached_property
    def work(self):
        """What was computed for this frame, a dict of counts: see `renderer.work`. A given stage's work is not in it."""
        return self._add_up()

    @property
    def rgb(self):
        """(height, width, 3) float64 in [0, 1]."""
        return np.moveaxis(self._planes, 0, -1)

    @property
    def chambers(self):
        """(height, width) uint8."""
        return self.stage.chambers

    @cached_property
    def planes_on_a(self):
        """(6, pixels of A) float64: cos θ, sin θ, cos φ, sin φ, h_u, h_v by the frame's method, row by row."""
        planes, bump = np.empty((6, *self.raster.shape)), bump_of(self.scene, self.method)
        for band in self.stage.bands:
            bump.draw(self.stage, band, np.zeros(len(WORK), np.int64), planes=planes)
        return planes[:, self.stage.on_a]

    @cached_property
    def surface_data(self):
        """What is known of sphere A: a dict of (height, width) float64 planes, NaN off A.

        u, v, h, h_u, h_v (by the frame's method), slope, kink (1 or 0), and straddling (1 or 0) for a difference.
        """
        data = {}
        for name, values in self._data_on_a().items():
            data[name] = np.full(self.raster.shape, np.nan)
            data[name][self.stage.on_a] = values
        return data

    def _data_on_a(self):
        kernels, waves = FIELDS[self.scene.field], (self.scene.ku, self.scene.kv)
        *angles, h_u, h_v = self.planes_on_a
        whole = (0, h_u.size)
        u, v, h, slope, kink, straddling = np.empty((6, h_u.size))
        chart_row(*angles, u, v, *whole)
        kernels["height"](u, v, *waves, h, *whole)
        kernels["kink"](angles[3], u, v, *waves, kink, *whole)
        slope_row(h_u, h_v, slope, *whole)
        data = {"u": u, "v": v, "h": h, "h_u": h_u, "h_v": h_v, "slope": slope, "kink": kink}
        if self.method.eps:
            kernels["straddling"](u, v, *waves, self.method.eps, straddling, *whole)
            data["straddling"] = straddling
        return data

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
