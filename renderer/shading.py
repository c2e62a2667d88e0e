"""The second stage, second half: normals, light by light, the colour of every pixel."""

from typing import NamedTuple

import numpy as np

from renderer.chambers import DARK_BIT, FIRST_LIGHT_BIT, FLOOR, NOTHING, SPHERE_A, SPHERE_B, SURFACE_BITS
from renderer.kernels import (
    ambient_term,
    blinn_row,
    blinn_squared_row,
    clip_row,
    compiled,
    floor_albedo,
    highlight_row,
    light_term_row,
    multiply_row,
    normal_of_b_row,
    normal_of_floor_row,
    normal_on_a_row,
    phong_row,
    square_row,
    view_length_row,
)

BLINN, PHONG, BLINN_SQUARED = 0, 1, 2


class Material(NamedTuple):
    """The scene's shading, as the kernels take it.

    model: BLINN, PHONG, or BLINN_SQUARED for an even shininess. power: the whole power that the highlight's base is
    raised to, 0 if the shininess is not whole. base: the ambient colour (3). albedo: (5, 3) for nothing, A, B, light
    and dark floor squares. positions, colors: (n, 3), and bits (n), of the lights that are on.
    """

    beta: float
    kd: float
    ks: float
    shininess: float
    power: int
    model: int
    base: np.ndarray
    albedo: np.ndarray
    positions: np.ndarray
    colors: np.ndarray
    bits: np.ndarray


def material_of(scene):
    """Return the Material of a scene."""
    on = [(number, light) for number, light in enumerate(scene.lights) if light.color is not None]
    floor = [(red, red, blue) for red, blue in (floor_albedo(dark, scene.floor_tint) for dark in (0.0, 1.0))]
    power = int(scene.shininess) if scene.shininess == int(scene.shininess) else 0
    model = BLINN if scene.model == "blinn" else PHONG
    if model == BLINN and power and power % 2 == 0:
        model, power = BLINN_SQUARED, power // 2
    return Material(
        scene.beta,
        scene.kd,
        scene.ks,
        scene.shininess,
        power,
        model,
        np.array([ambient_term(scene.ka, channel) for channel in scene.ambient]),
        np.array([(0.0, 0.0, 0.0), scene.albedo_a, scene.albedo_b, *floor]),
        np.array([light.position for _, light in on], np.float64).reshape(-1, 3),
        np.array([light.color for _, light in on], np.float64).reshape(-1, 3),
        np.array([1 << (FIRST_LIGHT_BIT + number) for number, _ in on], np.uint8),
    )


@compiled
def _albedo_index(code):
    surface = code & SURFACE_BITS
    return surface + 1 if surface == FLOOR and code & DARK_BIT else surface


@compiled
def _place(x, y, g, m, surface, row, p, place, start, stop):
    """Write the points and normals of a run into `place`, six rows; `p` are the band's planes."""
    px, py, pz, nx, ny, nz = place[0], place[1], place[2], place[3], place[4], place[5]
    if surface == SPHERE_A:
        cos_theta, sin_theta, cos_phi, sin_phi = p.cos_theta[row], p.sin_theta[row], p.cos_phi[row], p.sin_phi[row]
        h_u, h_v = p.h_u[row], p.h_v[row]
        normal_on_a_row(
            cos_theta, sin_theta, cos_phi, sin_phi, g.radius, h_u, h_v, m.beta, px, py, pz, nx, ny, nz, start, stop
        )
    elif surface == SPHERE_B:
        bx, by, bz, radius = g.ball_x, g.ball_y, g.ball_z, g.ball_radius
        normal_of_b_row(x, y, g.eye, bx, by, bz, radius, g.ball_on, px, py, pz, nx, ny, nz, start, stop)
    else:
        normal_of_floor_row(x, y, px, py, pz, nx, ny, nz, start, stop)


@compiled
def _raise_to_shininess(m, base_row, power_row, start, stop):
    """Write base^shininess: by repeated squaring if it is whole (the base row is used up), else by pow."""
    if m.power == 0:
        highlight_row(base_row, m.shininess, power_row, start, stop)
        return
    power_row[start:stop] = 1.0
    remaining = m.power
    while remaining:
        if remaining & 1:
            multiply_row(power_row, base_row, start, stop)
        remaining >>= 1
        if remaining:
            square_row(base_row, start, stop)


@compiled
def _add_light(x, y, eye, m, light, albedo, place, work, rgb, row, start, stop):
    """Add one light to a run's colours; `work` is four rows: view scale (filled), μ, highlight's base, highlight."""
    position, color = m.positions[light], m.colors[light]
    lx, ly, lz = position[0], position[1], position[2]
    px, py, pz, nx, ny, nz = place[0], place[1], place[2], place[3], place[4], place[5]
    if m.model == BLINN_SQUARED:
        blinn_squared_row(x, y, eye, work[0], px, py, pz, lx, ly, lz, nx, ny, nz, work[1], work[2], start, stop)
    elif m.model == BLINN:
        blinn_row(x, y, eye, work[0], px, py, pz, lx, ly, lz, nx, ny, nz, work[1], work[2], start, stop)
    else:
        phong_row(x, y, eye, work[0], px, py, pz, lx, ly, lz, nx, ny, nz, work[1], work[2], start, stop)
    _raise_to_shininess(m, work[2], work[3], start, stop)
    light_term_row(
        rgb[0, row],
        rgb[1, row],
        rgb[2, row],
        color[0],
        color[1],
        color[2],
        albedo[0],
        albedo[1],
        albedo[2],
        m.kd,
        m.ks,
        work[1],
        work[3],
        start,
        stop,
    )


@compiled
def shade_runs(runs, x, y_of_row, g, m, planes, rgb):
    """Write the colours of a band's runs into `rgb`, (3, rows, columns). One run at a time; A's planes are filled."""
    columns = x.shape[0]
    place, work = np.empty((6, columns)), np.empty((4, columns))
    for index in range(runs.shape[0]):
        row, start, stop, code = runs[index, 0], runs[index, 1], runs[index, 2], runs[index, 3]
        surface = code & SURFACE_BITS
        if surface == NOTHING:
            rgb[:, row, start:stop] = 0.0
            continue
        y, albedo = y_of_row[row], m.albedo[_albedo_index(code)]
        _place(x, y, g, m, surface, row, planes, place, start, stop)
        for channel in range(3):
            rgb[channel, row, start:stop] = m.base[channel]
        view_length_row(x, y, g.eye, work[0], start, stop)
        for light in range(m.bits.shape[0]):
            if not code & m.bits[light]:
                _add_light(x, y, g.eye, m, light, albedo, place, work, rgb, row, start, stop)
        for channel in range(3):
            clip_row(rgb[channel, row], start, stop)


def placed(scene, stage, planes, code):
    """Return the first pixel's point and normal (N' on sphere A), six rows of one, for a stage of one pixel."""
    rows = np.empty((6, 1))
    _place(stage.x, stage.bands[0].y[0], stage.geometry, material_of(scene), code & SURFACE_BITS, 0, planes, rows, 0, 1)
    return rows


def light_rows(stage, material, light, code, place):
    """Return (μ, specular, added colour), rows of one, of one light at a stage of one pixel, occluded or not."""
    work, rgb = np.empty((4, 1)), np.zeros((3, 1, 1))
    albedo = material.albedo[_albedo_index(code)]
    y = stage.bands[0].y[0]
    view_length_row(stage.x, y, stage.geometry.eye, work[0], 0, 1)
    _add_light(stage.x, y, stage.geometry.eye, material, light, albedo, place, work, rgb, 0, 0, 1)
    return work[1], work[3], rgb[:, 0]
