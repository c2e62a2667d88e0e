"""The second stage, first half: the angles of sphere A's pixels and the gradient of the height field there."""

from typing import NamedTuple

import numpy as np

from renderer.chambers import SPHERE_A
from renderer.kernels import (
    FIELDS,
    MAX_ALGEBRAIC,
    angles_on_a_row,
    chart_row,
    compiled,
    complex_product_row,
    complex_square_row,
)
from renderer.threads import scratch


class Planes(NamedTuple):
    """What is known of each pixel of a band, (rows, columns) float64 each; undefined off sphere A."""

    cos_theta: np.ndarray
    sin_theta: np.ndarray
    cos_phi: np.ndarray
    sin_phi: np.ndarray
    h_u: np.ndarray
    h_v: np.ndarray


def empty_planes(rows, columns):
    """Return Planes of a band, with the gradient set to zero."""
    return Planes(*np.empty((4, rows, columns)), *np.zeros((2, rows, columns)))


def scratch_planes(rows, columns):
    """Return Planes of a band that are this thread's own and will be used again; the gradient is whatever it was."""
    return Planes(*scratch("planes", (len(Planes._fields), rows, columns)))


@compiled
def _angles_runs(runs, x, y_of_row, eye, radius, p):
    for index in range(runs.shape[0]):
        row, start, stop = runs[index, 0], runs[index, 1], runs[index, 2]
        angles_on_a_row(
            x,
            y_of_row[row],
            eye,
            radius,
            p.cos_theta[row],
            p.sin_theta[row],
            p.cos_phi[row],
            p.sin_phi[row],
            start,
            stop,
        )


@compiled
def _chart_runs(runs, p, u, v):
    for index in range(runs.shape[0]):
        row, start, stop = runs[index, 0], runs[index, 1], runs[index, 2]
        chart_row(p.cos_theta[row], p.sin_theta[row], p.cos_phi[row], p.sin_phi[row], u[row], v[row], start, stop)


@compiled
def _power_row(base_real, base_imaginary, orientation, exponent, real, imaginary, start, stop):
    """Write (orientation · base)^exponent by repeated squaring; a negative exponent conjugates (|base| = 1)."""
    squares = np.empty((2, stop - start))
    reflection = orientation if exponent >= 0 else -orientation
    for i in range(np.uint64(start), np.uint64(stop)):
        squares[0, i - np.uint64(start)] = orientation * base_real[i]
        squares[1, i - np.uint64(start)] = reflection * base_imaginary[i]
    result_real, result_imaginary = real[start:stop], imaginary[start:stop]
    remaining, first, count = abs(exponent), True, stop - start
    if remaining == 0:
        result_real[:], result_imaginary[:] = 1.0, 0.0
    while remaining:
        if remaining & 1:
            if first:
                result_real[:], result_imaginary[:], first = squares[0], squares[1], False
            else:
                complex_product_row(result_real, result_imaginary, squares[0], squares[1], 0, count)
        remaining >>= 1
        if remaining:
            complex_square_row(squares[0], squares[1], 0, count)


@compiled
def _factors_runs(runs, p, power_u, power_v, sin_u, cos_u, sin_v, cos_v):
    """Write the trigonometric factors of the algebraic form (theorem algebraic_gradient)."""
    for index in range(runs.shape[0]):
        row, start, stop = runs[index, 0], runs[index, 1], runs[index, 2]
        _power_row(p.cos_theta[row], p.sin_theta[row], -1.0, power_u, cos_u[row], sin_u[row], start, stop)
        _power_row(p.cos_phi[row], p.sin_phi[row], 1.0, power_v, cos_v[row], sin_v[row], start, stop)


def algebraic_powers(scene):
    """Return the whole powers (for u, for v) of the algebraic form of the scene's field, or None without one."""
    wave_numbers = FIELDS[scene.field]["wave_numbers"]
    if wave_numbers is None:
        return None
    a, b = wave_numbers(scene.ku, scene.kv)
    if a % 2 or b % 1 or max(abs(a), abs(b)) > MAX_ALGEBRAIC:
        return None
    return int(a) // 2, int(b)


def uses_algebraic_form(scene, method):
    """Return whether the exact gradient of the scene is taken without a transcendental function.

    Raises ValueError if the form "algebraic" is asked for where there is none.
    """
    powers = algebraic_powers(scene)
    if method.form == "algebraic" and powers is None:
        raise ValueError(
            f"form = 'algebraic' is not allowed for field {scene.field!r} with ku = {scene.ku:g}, kv = {scene.kv:g}: "
            f"it needs an even ku and a whole kv, at most {MAX_ALGEBRAIC} in magnitude (rings: a whole 2 kv)"
        )
    return powers is not None and method.form != "general"


def fill_angles(stage, band, planes):
    """Write the angles of the band's pixels of A into `planes`."""
    g = stage.geometry
    _angles_runs(band.runs_on_a, stage.x, band.y, g.eye, g.radius, planes)


def chart_of(band, planes, own=True):
    """Return (u, v), each (rows, columns), of the band's pixels of A; the angles must be there.

    Without `own` the arrays are this thread's scratch.
    """
    u, v = np.empty((2, *planes.h_u.shape)) if own else scratch("chart", (2, *planes.h_u.shape))
    _chart_runs(band.runs_on_a, planes, u, v)
    return u, v


def fill_gradient(scene, method, band, planes):
    """Write h_u and h_v of the band's pixels of A into `planes`; the angles must be there."""
    kernels, runs = FIELDS[scene.field], band.runs_on_a
    if method.name == "exact" and uses_algebraic_form(scene, method):
        factors = scratch("factors", (4, *planes.h_u.shape))
        _factors_runs(runs, planes, *algebraic_powers(scene), *factors)
        kernels["gradient_from_factors"](runs, *factors, scene.ku, scene.kv, planes.h_u, planes.h_v)
        return
    u, v = chart_of(band, planes, own=False)
    if method.name == "exact":
        kernels["gradient"](runs, u, v, scene.ku, scene.kv, planes.h_u, planes.h_v)
    else:
        kernels[method.name](runs, u, v, scene.ku, scene.kv, method.eps, planes.h_u, planes.h_v)


def _single_run(u, v):
    u, v = np.broadcast_arrays(np.asarray(u, np.float64), np.asarray(v, np.float64))
    inside = (u >= 0) & (u < 1) & (v >= 0) & (v <= 1)
    if not inside.all():
        raise ValueError(f"(u, v) = ({u[~inside][0]}, {v[~inside][0]}) is not allowed: u in [0, 1), v in [0, 1]")
    runs = np.array([[0, 0, u.size, SPHERE_A]], np.int64)
    return runs, np.ascontiguousarray(u).reshape(1, -1), np.ascontiguousarray(v).reshape(1, -1), u.shape


def height_at(scene, u, v):
    """Return h(u, v) of the scene's field, an array of the broadcast shape. Raises ValueError off the chart."""
    runs, u_plane, v_plane, shape = _single_run(u, v)
    h = np.empty_like(u_plane)
    FIELDS[scene.field]["height"](runs, u_plane, v_plane, scene.ku, scene.kv, h)
    return h.reshape(shape)


def gradient_at(scene, u, v, method):
    """Return (h_u, h_v) at chart points by `method` (exact: the general form), arrays of the broadcast shape.

    u ∈ [0, 1), v ∈ [0, 1], else ValueError.
    """
    runs, u_plane, v_plane, shape = _single_run(u, v)
    h_u, h_v = np.empty((2, *u_plane.shape))
    kernels = FIELDS[scene.field]
    if method.name == "exact":
        kernels["gradient"](runs, u_plane, v_plane, scene.ku, scene.kv, h_u, h_v)
    else:
        kernels[method.name](runs, u_plane, v_plane, scene.ku, scene.kv, method.eps, h_u, h_v)
    return h_u.reshape(shape), h_v.reshape(shape)
