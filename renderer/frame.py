"""A rendered picture, with what is known of its pixels; views are made when they are first asked for."""

from functools import cached_property

import numpy as np

from renderer.kernels import FIELDS, chart_row, slope_row
from renderer.material import material_key, material_of
from renderer.shading import WORK
from renderer.sphere_a import bump_of


class Frame:
    """A picture of a scene.

    rgb: (height, width, 3) float64, linear light in [0, 1], row 0 at the top (a view of three planes).
    planes: the same, (3, height, width). chambers: (height, width) uint8, see `renderer.stage.Stage`.
    scene, raster, method, stage: what made it.
    """

    def __init__(self, scene, raster, method, stage, planes, add_up):
        self.scene, self.raster, self.method, self.stage = scene, raster, method, stage
        self.planes, self._add_up = planes, add_up

    @cached_property
    def work(self):
        """What was computed for this frame, a dict of counts (`renderer.work`), without a given stage's."""
        return self._add_up()

    def shaded_as(self, scene):
        """Return whether a scene's weights, albedos, lights and highlight are this frame's: the same off sphere A."""
        return material_key(material_of(self.scene)) == material_key(material_of(scene))

    def give_away(self):
        """Return the planes for another frame to be drawn into; this one has none any more.

        Raises ValueError if it has given them away.
        """
        if self.planes is None:
            raise ValueError(f"into = {self!r} is not allowed: another frame has been drawn into it")
        planes, self.planes = self.planes, None
        return planes

    @property
    def rgb(self):
        """(height, width, 3) float64 in [0, 1]."""
        return np.moveaxis(self.planes, 0, -1)

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
    def _chart_on_a(self):
        u, v = np.empty((2, self.planes_on_a.shape[1]))
        chart_row(*self.planes_on_a[:4], u, v, 0, u.size)
        return u, v

    def _field_on_a(self, kernel, *arguments):
        """Return what a kernel of the field makes of A's pixels: (pixels of A,)."""
        values = np.empty(self.planes_on_a.shape[1])
        FIELDS[self.scene.field][kernel](*arguments, values, 0, values.size)
        return values

    @cached_property
    def _kink_on_a(self):
        return self._field_on_a("kink", self.planes_on_a[3], *self._chart_on_a, self.scene.ku, self.scene.kv)

    @cached_property
    def _straddling_on_a(self):
        return self._field_on_a("straddling", *self._chart_on_a, self.scene.ku, self.scene.kv, self.method.eps)

    @cached_property
    def _slope_on_a(self):
        slope = np.empty(self.planes_on_a.shape[1])
        slope_row(*self.planes_on_a[4:], slope, 0, slope.size)
        return slope

    def _plane(self, values, off_a, kind=np.float64):
        plane = np.full(self.raster.shape, off_a, kind)
        plane[self.stage.on_a] = values
        return plane

    @cached_property
    def surface_data(self):
        """What is known of sphere A: a dict of (height, width) float64 planes, NaN off A.

        u, v, h, h_u, h_v (by the frame's method), slope, kink (1 or 0), and straddling (1 or 0) for a difference.
        """
        (u, v), (h_u, h_v) = self._chart_on_a, self.planes_on_a[4:]
        h = self._field_on_a("height", u, v, self.scene.ku, self.scene.kv)
        data = {"u": u, "v": v, "h": h, "h_u": h_u, "h_v": h_v, "slope": self._slope_on_a, "kink": self._kink_on_a}
        if self.method.eps:
            data["straddling"] = self._straddling_on_a
        return {name: self._plane(values, np.nan) for name, values in data.items()}

    @property
    def kink(self):
        """(height, width) bool: a crease factor of the field is below 0.03 in magnitude, or the pole; False off A."""
        return self._plane(self._kink_on_a == 1.0, False, bool)

    @property
    def slope(self):
        """(height, width) float64: √(h_u² + h_v²) by the frame's method; 0 off A."""
        return self._plane(self._slope_on_a, 0.0)

    @property
    def straddling(self):
        """(height, width) bool: a crease lies strictly within ε of the pixel in u or in v; False if exact."""
        if not self.method.eps:
            return np.zeros(self.raster.shape, bool)
        return self._plane(self._straddling_on_a == 1.0, False, bool)
