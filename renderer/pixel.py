"""Everything about one pixel, as a record: the same kernels as `render`, on a raster cropped to that pixel."""

import math
from dataclasses import dataclass

import numpy as np

from renderer.chambers import FIRST_LIGHT_BIT, FLOOR, SPHERE_A, SPHERE_B, SURFACE_BITS
from renderer.kernels import light_term_row, normal_of_b_row, normal_on_a_row, view_length_row
from renderer.material import highlight_of, material_of
from renderer.render import render
from renderer.shading import ROWS, albedo_of, light_on_sphere, raise_to_shininess

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
        rows = _placed(frame, code & SURFACE_BITS)
        record |= {"point": _triple(rows[:3]), "normal": _triple(rows[3:6]), "lights": _lights(frame, rows, code)}
    if code & SURFACE_BITS == SPHERE_A:
        record |= _on_a(frame)
    return PixelRecord(**record)


def _triple(rows):
    return tuple(float(row[0]) for row in rows)


def _placed(frame, surface):
    """Return the working rows of one pixel with its point, normal (N' on sphere A) and view scale filled in."""
    rows, stage, scene = np.empty((ROWS, 1)), frame.stage, frame.scene
    g, x, y = stage.geometry, stage.x, stage.bands[0].y[0]
    if surface == SPHERE_A:
        normal_on_a_row(*frame.planes_on_a, scene.beta, g.radius, x, y, g.eye, *rows[:7], 0, 1)
    elif surface == SPHERE_B:
        normal_of_b_row(x, y, g.eye, g.ball_x, g.ball_y, g.ball_z, g.ball_radius, g.ball_on, *rows[:7], 0, 1)
    elif surface == FLOOR:
        rows[:6, 0] = (x[0], y, 0.0, 0.0, 0.0, 1.0)
        view_length_row(x, y, g.eye, rows[6], 0, 1)
    return rows


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


def _lights(frame, rows, code):
    """Return a LightRecord for every light that is on, from a pixel's working rows; an occluded one adds nothing."""
    material, stage, records = material_of(frame.scene), frame.stage, []
    numbers, kd, ks, shininess = material.numbers, *material.numbers[:3]
    power, *style = highlight_of(frame.scene)
    for number, light in enumerate(frame.scene.lights):
        if light.color is None:
            continue
        x, y, eye, source = stage.x, stage.bands[0].y[0], stage.geometry.eye, np.array(light.position)
        light_on_sphere(x, y, eye, source, *rows[:9], None, *style, 1)
        raise_to_shininess(rows[8], rows[12], shininess, power, 1)
        rows[9:12] = 0.0
        light_term_row(*rows[9:12], *light.color, *albedo_of(numbers, code), kd, ks, rows[7], rows[8], 0, 1)
        occluded = bool(code & 1 << (FIRST_LIGHT_BIT + number))
        adds = (0.0, 0.0, 0.0) if occluded else _triple(rows[9:12])
        records.append(LightRecord(number, occluded, float(rows[7, 0]), float(rows[8, 0]), adds))
    return tuple(records)
