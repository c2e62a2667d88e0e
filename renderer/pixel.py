"""Everything about one pixel, as a record: the same kernels as `render`, on a raster cropped to that pixel."""

import math
from dataclasses import dataclass

from renderer.chambers import SPHERE_A, SURFACE_BITS
from renderer.render import render
from renderer.shading import light_rows, material_of, placed

SURFACES = ("none", "A", "B", "floor")


@dataclass(frozen=True)
class LightRecord:
    """What one light does at a pixel: `occluded` by another body, μ = N'·ω, base^p, and the RGB that it adds."""

    number: int
    occluded: bool
    mu: float
    specular: float
    adds: tuple


@dataclass(frozen=True)
class PixelRecord:
    """One pixel. Lengths in world units, angles in radians; what exists on sphere A alone is None elsewhere."""

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


def pixel(scene, width, height, column, row, gradient=None):
    """Return the PixelRecord of (column, row), counted from the top left, on a raster of width × height.

    `normal` is N' on sphere A. Its rgb is bit for bit that of `render`. Raises ValueError as `render` does.
    """
    frame = render(scene, width, height, gradient, crop=(column, row, 1, 1), threads=1)
    code = int(frame.chambers[0, 0])
    record = {
        "column": column,
        "row": row,
        "surface": SURFACES[code & SURFACE_BITS],
        "chamber": code,
        "rgb": tuple(frame.rgb[0, 0].tolist()),
    }
    if code & SURFACE_BITS:
        place = placed(frame.scene, frame.stage, frame.planes(frame.stage.bands[0]), code)
        record |= {"point": _triple(place[:3]), "normal": _triple(place[3:]), "lights": _lights(frame, place, code)}
    if code & SURFACE_BITS == SPHERE_A:
        record |= _on_a(frame)
    return PixelRecord(**record)


def _triple(rows):
    return tuple(float(row[0]) for row in rows)


def _on_a(frame):
    data = {name: plane[0, 0].item() for name, plane in frame.surface_data.items()}
    return {
        "theta": (2.0 * data["u"] - 1.0) * math.pi,
        "phi": data["v"] * math.pi,
        "u": data["u"],
        "v": data["v"],
        "h": data["h"],
        "gradient": (data["h_u"], data["h_v"]),
        "kink": data["kink"] == 1.0,
        "straddling": data.get("straddling") == 1.0,
    }


def _lights(frame, place, code):
    scene, material = frame.scene, material_of(frame.scene)
    numbers = [number for number, light in enumerate(scene.lights) if light.color is not None]
    records = []
    for index, number in enumerate(numbers):
        occluded = bool(code & material.bits[index])
        mu, specular, added = light_rows(frame.stage, material, index, code, place)
        adds = (0.0, 0.0, 0.0) if occluded else _triple(added)
        records.append(LightRecord(number, occluded, float(mu[0]), float(specular[0]), adds))
    return tuple(records)
