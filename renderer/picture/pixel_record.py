"""A record of one pixel: the shader once more, on NumPy, with its geometry and each light's share."""

from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np

from renderer import kernels
from renderer.checks import check_whole
from renderer.machines.forms import of_form
from renderer.machines.numpy_rows import Block, Rows
from renderer.picture.drawing import render
from renderer.picture.stage import SURFACE_BITS
from renderer.scene.methods import GradientMethod
from renderer.scene.raster import Raster
from renderer.scene.scene import Scene
from renderer.shader.numbers import FIRST_LIGHT_BIT
from renderer.shader.shader import COLORS, Group

SURFACES = ("none", "A", "B", "floor")


@dataclass(frozen=True)
class LightRecord:
    """The part of one light in a pixel: `occluded` by another body, μ = N'·ω, base^p, and the RGB that it adds."""

    number: int
    occluded: bool
    mu: float
    specular: float
    adds: tuple


@dataclass(frozen=True)
class PixelRecord:
    """The data of one pixel. Lengths in world units, angles in radians; those of sphere A alone are None elsewhere."""

    column: int
    row: int
    surface: str
    chamber: int
    point: tuple | None = None
    normal: tuple | None = None
    theta: float | None = None
    phi: float | None = None
    u: float | None = None
    v: float | None = None
    h: float | None = None
    gradient: tuple | None = None
    kink: bool | None = None
    straddling: bool | None = None
    lights: tuple = ()
    rgb: tuple = (0.0, 0.0, 0.0)
    derivatives: dict = field(default_factory=dict)


def pixel(
    scene: Scene,
    width: int,
    height: int,
    column: int,
    row: int,
    gradient: GradientMethod | None = None,
    derivatives: Iterable[str] = (),
) -> PixelRecord:
    """Return the PixelRecord of (column, row), counted from the top left, on a raster of width × height.

    `normal` is N' on sphere A. derivatives: as for `render`; the record has {name: slopes of rgb}. Its rgb is bit for
    bit that of `render`. Raises ValueError as `render` does.

    >>> from renderer import Scene, pixel
    >>> record = pixel(Scene(), 16, 16, 8, 9)
    >>> record.surface, [light.occluded for light in record.lights], round(record.u, 4)
    ('A', [False, False], 0.2791)
    """
    raster = Raster(width, height)
    column = check_whole("column", column, raster.width - 1, low=0)
    row = check_whole("row", row, raster.height - 1, low=0)
    frame = render(scene, width, height, gradient, crop=(column, row, 1, 1), threads=1, derivatives=derivatives)
    code = int(frame.chambers[0, 0])
    surface = SURFACES[code & SURFACE_BITS]
    data = (_lit(frame) if surface != "none" else {}) | (_on_a(frame) if surface == "A" else {})
    slopes = {name: tuple(slope[0, 0].tolist()) for name, slope in frame.derivatives.items()}
    return PixelRecord(column, row, surface, code, **data, rgb=tuple(frame.rgb[0, 0].tolist()), derivatives=slopes)


class _WrittenDown(Group):
    """A group of one pixel, run for its point, its normal and each light's part: its `record`."""

    def light_up(self, mask, place, albedo, bodies, upright=None):
        """Record each light's part, in place of adding it up."""
        s, lights, point, normal = self.scene, [], place[:3], place[3:]
        for light in self.machine.lights:
            occluded = bool(self.loaded_shadow(light))
            mu, specular = self.model(point, light, normal, self.view(), mask)
            adds = kernels.light_term(0.0, 0.0, 0.0, *light.color, *albedo, s.kd, s.ks, mu, specular)
            number = int(light.bit).bit_length() - 1 - FIRST_LIGHT_BIT
            behind = self.want.horizon and not self.faces(light, point, upright or normal)
            adds = (0.0, 0.0, 0.0) if occluded or behind else _floats(adds)
            lights.append(LightRecord(number, occluded, *_floats((mu, specular)), adds))
        self.record = {"point": _floats(point), "normal": _floats(normal), "lights": tuple(lights)}


def _floats(numbers):
    return tuple(float(np.ravel(number)[0]) for number in numbers)


@np.errstate(all="ignore")
def _lit(frame):
    """Return the point, the normal and the lights of the one pixel of a frame."""
    job = frame.stage.job(frame.shot.numbers, dict(zip(COLORS, np.empty((3, 1, 1)), strict=True)))
    ((model, style),) = frame.shot.want.lights
    want = frame.shot.want._replace(chambers_known=True, lights=((model, style.replace("diffuse", "base")),))
    if frame.scene.beta and not frame.shot.glows:  # the picture needs no slopes, and the normal that is recorded does
        want = want._replace(ways=((frame.scene.field, frame.shot.way),))
    machine, numbers = Rows(want.shader, job["lights"]), of_form(want.shader.scene, job["scene"])
    group = _WrittenDown(machine, numbers, want, Block(job, slice(1)))
    group.draw()
    return group.record


def _on_a(frame):
    data = {name: values.item() for name, values in frame.data_on_a.items()}
    theta, phi = kernels.chart_radians(data["u"], data["v"])
    return {name: data[name] for name in ("u", "v", "h")} | {
        "theta": theta,
        "phi": phi,
        "gradient": (data["h_u"], data["h_v"]),
        "kink": data["kink"] == 1.0,
        "straddling": data.get("straddling") == 1.0,
    }
