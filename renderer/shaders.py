"""Generated from proofs/ by `python -m renderer.generate`. Do not edit: it is printed there.

Each function draws sphere A's runs of a band: angles, gradient, normal, lights; one for each field and way to its
gradient. `bump` is k_u, k_v, β and ε; `powers` those of the algebraic form. It writes the colours into `rgb`, (3,
height, width), and cos θ, sin θ, cos φ, sin φ, h_u, h_v into `planes`, (6, height, width); None for what is not wanted.
The band's first row is row `top` of the picture.
"""

import numpy as np

from renderer.chambers import whole_groups
from renderer.kernels import (
    angles_on_a_row,
    central4_ridges_row,
    central4_rings_row,
    central4_sine_row,
    central_ridges_row,
    central_rings_row,
    central_sine_row,
    chart_row,
    chart_v_row,
    compiled,
    forward_ridges_row,
    forward_rings_row,
    forward_sine_row,
    gradient_from_factors_ridges_row,
    gradient_from_factors_rings_row,
    gradient_from_factors_sine_row,
    gradient_ridges_row,
    gradient_rings_row,
    gradient_sine_row,
    normal_on_a_row,
)
from renderer.lights import lights_on_a
from renderer.powers import powers_of_angles
from renderer.shading import ROW_LENGTH, ROWS, color_run, fill, keep_run, lights_of, shade_sphere_run


@compiled
def draw_flat(
    runs, x, y_of_row, top, g, bump, powers, numbers, lights, bits, power, dull, phong, blinn, squared,
    rgb, planes, work,
):
    eye, radius, k_u, k_v, beta, epsilon = g[0], g[1], bump[0], bump[1], bump[2], bump[3]
    p = np.empty((ROWS, ROW_LENGTH))
    px, py, pz, nx, ny, nz, view = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    mu, base, red, green, blue, spare = p[7], p[8], p[9], p[10], p[11], p[12]
    cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v = p[7], p[8], p[9], p[10], p[11], p[12]  # until the lights come
    for index in range(runs.shape[0]):
        row, start, stop, code = top + runs[index, 0], runs[index, 1], runs[index, 2], runs[index, 3]
        here, y, count = x[start:], y_of_row[runs[index, 0]], whole_groups(stop - start)
        angles_on_a_row(here, y, eye, radius, cos_theta, sin_theta, cos_phi, sin_phi, 0, count)
        fill(h_u, 0.0, count)
        fill(h_v, 0.0, count)
        if planes is not None:
            keep_run(planes, row, start, stop, cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v)
        if rgb is None:
            continue
        lit, first, second = lights_of(code, bits)
        if lit == 1 or lit == 2:
            lights_on_a(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                lights, first, second, lit, px, py, pz, nx, dull, phong, blinn, squared, count,
            )
            color_run(
                code, numbers, lights, first, second, lit, power, dull, rgb, row, start, stop, work,
                px, py, pz, nx, red, green, blue, spare,
            )
        else:
            normal_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                px, py, pz, nx, ny, nz, view, 0, count,
            )
            shade_sphere_run(
                here, y, eye, code, numbers, lights, bits, power, dull, phong, blinn, squared, rgb,
                row, start, stop, work, px, py, pz, nx, ny, nz, view, mu, base, red, green, blue, spare,
            )


@compiled
def draw_general_sine(
    runs, x, y_of_row, top, g, bump, powers, numbers, lights, bits, power, dull, phong, blinn, squared,
    rgb, planes, work,
):
    eye, radius, k_u, k_v, beta, epsilon = g[0], g[1], bump[0], bump[1], bump[2], bump[3]
    p = np.empty((ROWS, ROW_LENGTH))
    px, py, pz, nx, ny, nz, view = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    mu, base, red, green, blue, spare = p[7], p[8], p[9], p[10], p[11], p[12]
    cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v = p[7], p[8], p[9], p[10], p[11], p[12]  # until the lights come
    u, v = p[0], p[1]
    for index in range(runs.shape[0]):
        row, start, stop, code = top + runs[index, 0], runs[index, 1], runs[index, 2], runs[index, 3]
        here, y, count = x[start:], y_of_row[runs[index, 0]], whole_groups(stop - start)
        angles_on_a_row(here, y, eye, radius, cos_theta, sin_theta, cos_phi, sin_phi, 0, count)
        chart_row(cos_theta, sin_theta, cos_phi, sin_phi, u, v, 0, count)
        gradient_sine_row(u, v, k_u, k_v, h_u, h_v, 0, count)
        work[0] += stop - start
        if planes is not None:
            keep_run(planes, row, start, stop, cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v)
        if rgb is None:
            continue
        lit, first, second = lights_of(code, bits)
        if lit == 1 or lit == 2:
            lights_on_a(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                lights, first, second, lit, px, py, pz, nx, dull, phong, blinn, squared, count,
            )
            color_run(
                code, numbers, lights, first, second, lit, power, dull, rgb, row, start, stop, work,
                px, py, pz, nx, red, green, blue, spare,
            )
        else:
            normal_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                px, py, pz, nx, ny, nz, view, 0, count,
            )
            shade_sphere_run(
                here, y, eye, code, numbers, lights, bits, power, dull, phong, blinn, squared, rgb,
                row, start, stop, work, px, py, pz, nx, ny, nz, view, mu, base, red, green, blue, spare,
            )


@compiled
def draw_forward_sine(
    runs, x, y_of_row, top, g, bump, powers, numbers, lights, bits, power, dull, phong, blinn, squared,
    rgb, planes, work,
):
    eye, radius, k_u, k_v, beta, epsilon = g[0], g[1], bump[0], bump[1], bump[2], bump[3]
    p = np.empty((ROWS, ROW_LENGTH))
    px, py, pz, nx, ny, nz, view = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    mu, base, red, green, blue, spare = p[7], p[8], p[9], p[10], p[11], p[12]
    cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v = p[7], p[8], p[9], p[10], p[11], p[12]  # until the lights come
    u, v = p[0], p[1]
    for index in range(runs.shape[0]):
        row, start, stop, code = top + runs[index, 0], runs[index, 1], runs[index, 2], runs[index, 3]
        here, y, count = x[start:], y_of_row[runs[index, 0]], whole_groups(stop - start)
        angles_on_a_row(here, y, eye, radius, cos_theta, sin_theta, cos_phi, sin_phi, 0, count)
        chart_row(cos_theta, sin_theta, cos_phi, sin_phi, u, v, 0, count)
        forward_sine_row(u, v, k_u, k_v, epsilon, h_u, h_v, 0, count)
        work[0] += stop - start
        if planes is not None:
            keep_run(planes, row, start, stop, cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v)
        if rgb is None:
            continue
        lit, first, second = lights_of(code, bits)
        if lit == 1 or lit == 2:
            lights_on_a(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                lights, first, second, lit, px, py, pz, nx, dull, phong, blinn, squared, count,
            )
            color_run(
                code, numbers, lights, first, second, lit, power, dull, rgb, row, start, stop, work,
                px, py, pz, nx, red, green, blue, spare,
            )
        else:
            normal_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                px, py, pz, nx, ny, nz, view, 0, count,
            )
            shade_sphere_run(
                here, y, eye, code, numbers, lights, bits, power, dull, phong, blinn, squared, rgb,
                row, start, stop, work, px, py, pz, nx, ny, nz, view, mu, base, red, green, blue, spare,
            )


@compiled
def draw_central_sine(
    runs, x, y_of_row, top, g, bump, powers, numbers, lights, bits, power, dull, phong, blinn, squared,
    rgb, planes, work,
):
    eye, radius, k_u, k_v, beta, epsilon = g[0], g[1], bump[0], bump[1], bump[2], bump[3]
    p = np.empty((ROWS, ROW_LENGTH))
    px, py, pz, nx, ny, nz, view = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    mu, base, red, green, blue, spare = p[7], p[8], p[9], p[10], p[11], p[12]
    cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v = p[7], p[8], p[9], p[10], p[11], p[12]  # until the lights come
    u, v = p[0], p[1]
    for index in range(runs.shape[0]):
        row, start, stop, code = top + runs[index, 0], runs[index, 1], runs[index, 2], runs[index, 3]
        here, y, count = x[start:], y_of_row[runs[index, 0]], whole_groups(stop - start)
        angles_on_a_row(here, y, eye, radius, cos_theta, sin_theta, cos_phi, sin_phi, 0, count)
        chart_row(cos_theta, sin_theta, cos_phi, sin_phi, u, v, 0, count)
        central_sine_row(u, v, k_u, k_v, epsilon, h_u, h_v, 0, count)
        work[0] += stop - start
        if planes is not None:
            keep_run(planes, row, start, stop, cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v)
        if rgb is None:
            continue
        lit, first, second = lights_of(code, bits)
        if lit == 1 or lit == 2:
            lights_on_a(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                lights, first, second, lit, px, py, pz, nx, dull, phong, blinn, squared, count,
            )
            color_run(
                code, numbers, lights, first, second, lit, power, dull, rgb, row, start, stop, work,
                px, py, pz, nx, red, green, blue, spare,
            )
        else:
            normal_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                px, py, pz, nx, ny, nz, view, 0, count,
            )
            shade_sphere_run(
                here, y, eye, code, numbers, lights, bits, power, dull, phong, blinn, squared, rgb,
                row, start, stop, work, px, py, pz, nx, ny, nz, view, mu, base, red, green, blue, spare,
            )


@compiled
def draw_central4_sine(
    runs, x, y_of_row, top, g, bump, powers, numbers, lights, bits, power, dull, phong, blinn, squared,
    rgb, planes, work,
):
    eye, radius, k_u, k_v, beta, epsilon = g[0], g[1], bump[0], bump[1], bump[2], bump[3]
    p = np.empty((ROWS, ROW_LENGTH))
    px, py, pz, nx, ny, nz, view = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    mu, base, red, green, blue, spare = p[7], p[8], p[9], p[10], p[11], p[12]
    cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v = p[7], p[8], p[9], p[10], p[11], p[12]  # until the lights come
    u, v = p[0], p[1]
    for index in range(runs.shape[0]):
        row, start, stop, code = top + runs[index, 0], runs[index, 1], runs[index, 2], runs[index, 3]
        here, y, count = x[start:], y_of_row[runs[index, 0]], whole_groups(stop - start)
        angles_on_a_row(here, y, eye, radius, cos_theta, sin_theta, cos_phi, sin_phi, 0, count)
        chart_row(cos_theta, sin_theta, cos_phi, sin_phi, u, v, 0, count)
        central4_sine_row(u, v, k_u, k_v, epsilon, h_u, h_v, 0, count)
        work[0] += stop - start
        if planes is not None:
            keep_run(planes, row, start, stop, cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v)
        if rgb is None:
            continue
        lit, first, second = lights_of(code, bits)
        if lit == 1 or lit == 2:
            lights_on_a(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                lights, first, second, lit, px, py, pz, nx, dull, phong, blinn, squared, count,
            )
            color_run(
                code, numbers, lights, first, second, lit, power, dull, rgb, row, start, stop, work,
                px, py, pz, nx, red, green, blue, spare,
            )
        else:
            normal_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                px, py, pz, nx, ny, nz, view, 0, count,
            )
            shade_sphere_run(
                here, y, eye, code, numbers, lights, bits, power, dull, phong, blinn, squared, rgb,
                row, start, stop, work, px, py, pz, nx, ny, nz, view, mu, base, red, green, blue, spare,
            )


@compiled
def draw_algebraic_sine(
    runs, x, y_of_row, top, g, bump, powers, numbers, lights, bits, power, dull, phong, blinn, squared,
    rgb, planes, work,
):
    eye, radius, k_u, k_v, beta, epsilon = g[0], g[1], bump[0], bump[1], bump[2], bump[3]
    p = np.empty((ROWS, ROW_LENGTH))
    px, py, pz, nx, ny, nz, view = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    mu, base, red, green, blue, spare = p[7], p[8], p[9], p[10], p[11], p[12]
    cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v = p[7], p[8], p[9], p[10], p[11], p[12]  # until the lights come
    sin_u, cos_u, sin_v, cos_v, spare_real, spare_imaginary = p[0], p[1], p[2], p[3], p[4], p[5]
    for index in range(runs.shape[0]):
        row, start, stop, code = top + runs[index, 0], runs[index, 1], runs[index, 2], runs[index, 3]
        here, y, count = x[start:], y_of_row[runs[index, 0]], whole_groups(stop - start)
        angles_on_a_row(here, y, eye, radius, cos_theta, sin_theta, cos_phi, sin_phi, 0, count)
        powers_of_angles(cos_theta, sin_theta, -1.0, powers[0], cos_u, sin_u, spare_real, spare_imaginary, count)
        powers_of_angles(cos_phi, sin_phi, 1.0, powers[1], cos_v, sin_v, spare_real, spare_imaginary, count)
        gradient_from_factors_sine_row(sin_u, cos_u, sin_v, cos_v, k_u, k_v, h_u, h_v, 0, count)
        work[0] += stop - start
        if planes is not None:
            keep_run(planes, row, start, stop, cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v)
        if rgb is None:
            continue
        lit, first, second = lights_of(code, bits)
        if lit == 1 or lit == 2:
            lights_on_a(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                lights, first, second, lit, px, py, pz, nx, dull, phong, blinn, squared, count,
            )
            color_run(
                code, numbers, lights, first, second, lit, power, dull, rgb, row, start, stop, work,
                px, py, pz, nx, red, green, blue, spare,
            )
        else:
            normal_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                px, py, pz, nx, ny, nz, view, 0, count,
            )
            shade_sphere_run(
                here, y, eye, code, numbers, lights, bits, power, dull, phong, blinn, squared, rgb,
                row, start, stop, work, px, py, pz, nx, ny, nz, view, mu, base, red, green, blue, spare,
            )


@compiled
def draw_general_ridges(
    runs, x, y_of_row, top, g, bump, powers, numbers, lights, bits, power, dull, phong, blinn, squared,
    rgb, planes, work,
):
    eye, radius, k_u, k_v, beta, epsilon = g[0], g[1], bump[0], bump[1], bump[2], bump[3]
    p = np.empty((ROWS, ROW_LENGTH))
    px, py, pz, nx, ny, nz, view = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    mu, base, red, green, blue, spare = p[7], p[8], p[9], p[10], p[11], p[12]
    cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v = p[7], p[8], p[9], p[10], p[11], p[12]  # until the lights come
    u, v = p[0], p[1]
    for index in range(runs.shape[0]):
        row, start, stop, code = top + runs[index, 0], runs[index, 1], runs[index, 2], runs[index, 3]
        here, y, count = x[start:], y_of_row[runs[index, 0]], whole_groups(stop - start)
        angles_on_a_row(here, y, eye, radius, cos_theta, sin_theta, cos_phi, sin_phi, 0, count)
        chart_row(cos_theta, sin_theta, cos_phi, sin_phi, u, v, 0, count)
        gradient_ridges_row(u, v, k_u, k_v, h_u, h_v, 0, count)
        work[0] += stop - start
        if planes is not None:
            keep_run(planes, row, start, stop, cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v)
        if rgb is None:
            continue
        lit, first, second = lights_of(code, bits)
        if lit == 1 or lit == 2:
            lights_on_a(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                lights, first, second, lit, px, py, pz, nx, dull, phong, blinn, squared, count,
            )
            color_run(
                code, numbers, lights, first, second, lit, power, dull, rgb, row, start, stop, work,
                px, py, pz, nx, red, green, blue, spare,
            )
        else:
            normal_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                px, py, pz, nx, ny, nz, view, 0, count,
            )
            shade_sphere_run(
                here, y, eye, code, numbers, lights, bits, power, dull, phong, blinn, squared, rgb,
                row, start, stop, work, px, py, pz, nx, ny, nz, view, mu, base, red, green, blue, spare,
            )


@compiled
def draw_forward_ridges(
    runs, x, y_of_row, top, g, bump, powers, numbers, lights, bits, power, dull, phong, blinn, squared,
    rgb, planes, work,
):
    eye, radius, k_u, k_v, beta, epsilon = g[0], g[1], bump[0], bump[1], bump[2], bump[3]
    p = np.empty((ROWS, ROW_LENGTH))
    px, py, pz, nx, ny, nz, view = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    mu, base, red, green, blue, spare = p[7], p[8], p[9], p[10], p[11], p[12]
    cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v = p[7], p[8], p[9], p[10], p[11], p[12]  # until the lights come
    u, v = p[0], p[1]
    for index in range(runs.shape[0]):
        row, start, stop, code = top + runs[index, 0], runs[index, 1], runs[index, 2], runs[index, 3]
        here, y, count = x[start:], y_of_row[runs[index, 0]], whole_groups(stop - start)
        angles_on_a_row(here, y, eye, radius, cos_theta, sin_theta, cos_phi, sin_phi, 0, count)
        chart_row(cos_theta, sin_theta, cos_phi, sin_phi, u, v, 0, count)
        forward_ridges_row(u, v, k_u, k_v, epsilon, h_u, h_v, 0, count)
        work[0] += stop - start
        if planes is not None:
            keep_run(planes, row, start, stop, cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v)
        if rgb is None:
            continue
        lit, first, second = lights_of(code, bits)
        if lit == 1 or lit == 2:
            lights_on_a(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                lights, first, second, lit, px, py, pz, nx, dull, phong, blinn, squared, count,
            )
            color_run(
                code, numbers, lights, first, second, lit, power, dull, rgb, row, start, stop, work,
                px, py, pz, nx, red, green, blue, spare,
            )
        else:
            normal_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                px, py, pz, nx, ny, nz, view, 0, count,
            )
            shade_sphere_run(
                here, y, eye, code, numbers, lights, bits, power, dull, phong, blinn, squared, rgb,
                row, start, stop, work, px, py, pz, nx, ny, nz, view, mu, base, red, green, blue, spare,
            )


@compiled
def draw_central_ridges(
    runs, x, y_of_row, top, g, bump, powers, numbers, lights, bits, power, dull, phong, blinn, squared,
    rgb, planes, work,
):
    eye, radius, k_u, k_v, beta, epsilon = g[0], g[1], bump[0], bump[1], bump[2], bump[3]
    p = np.empty((ROWS, ROW_LENGTH))
    px, py, pz, nx, ny, nz, view = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    mu, base, red, green, blue, spare = p[7], p[8], p[9], p[10], p[11], p[12]
    cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v = p[7], p[8], p[9], p[10], p[11], p[12]  # until the lights come
    u, v = p[0], p[1]
    for index in range(runs.shape[0]):
        row, start, stop, code = top + runs[index, 0], runs[index, 1], runs[index, 2], runs[index, 3]
        here, y, count = x[start:], y_of_row[runs[index, 0]], whole_groups(stop - start)
        angles_on_a_row(here, y, eye, radius, cos_theta, sin_theta, cos_phi, sin_phi, 0, count)
        chart_row(cos_theta, sin_theta, cos_phi, sin_phi, u, v, 0, count)
        central_ridges_row(u, v, k_u, k_v, epsilon, h_u, h_v, 0, count)
        work[0] += stop - start
        if planes is not None:
            keep_run(planes, row, start, stop, cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v)
        if rgb is None:
            continue
        lit, first, second = lights_of(code, bits)
        if lit == 1 or lit == 2:
            lights_on_a(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                lights, first, second, lit, px, py, pz, nx, dull, phong, blinn, squared, count,
            )
            color_run(
                code, numbers, lights, first, second, lit, power, dull, rgb, row, start, stop, work,
                px, py, pz, nx, red, green, blue, spare,
            )
        else:
            normal_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                px, py, pz, nx, ny, nz, view, 0, count,
            )
            shade_sphere_run(
                here, y, eye, code, numbers, lights, bits, power, dull, phong, blinn, squared, rgb,
                row, start, stop, work, px, py, pz, nx, ny, nz, view, mu, base, red, green, blue, spare,
            )


@compiled
def draw_central4_ridges(
    runs, x, y_of_row, top, g, bump, powers, numbers, lights, bits, power, dull, phong, blinn, squared,
    rgb, planes, work,
):
    eye, radius, k_u, k_v, beta, epsilon = g[0], g[1], bump[0], bump[1], bump[2], bump[3]
    p = np.empty((ROWS, ROW_LENGTH))
    px, py, pz, nx, ny, nz, view = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    mu, base, red, green, blue, spare = p[7], p[8], p[9], p[10], p[11], p[12]
    cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v = p[7], p[8], p[9], p[10], p[11], p[12]  # until the lights come
    u, v = p[0], p[1]
    for index in range(runs.shape[0]):
        row, start, stop, code = top + runs[index, 0], runs[index, 1], runs[index, 2], runs[index, 3]
        here, y, count = x[start:], y_of_row[runs[index, 0]], whole_groups(stop - start)
        angles_on_a_row(here, y, eye, radius, cos_theta, sin_theta, cos_phi, sin_phi, 0, count)
        chart_row(cos_theta, sin_theta, cos_phi, sin_phi, u, v, 0, count)
        central4_ridges_row(u, v, k_u, k_v, epsilon, h_u, h_v, 0, count)
        work[0] += stop - start
        if planes is not None:
            keep_run(planes, row, start, stop, cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v)
        if rgb is None:
            continue
        lit, first, second = lights_of(code, bits)
        if lit == 1 or lit == 2:
            lights_on_a(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                lights, first, second, lit, px, py, pz, nx, dull, phong, blinn, squared, count,
            )
            color_run(
                code, numbers, lights, first, second, lit, power, dull, rgb, row, start, stop, work,
                px, py, pz, nx, red, green, blue, spare,
            )
        else:
            normal_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                px, py, pz, nx, ny, nz, view, 0, count,
            )
            shade_sphere_run(
                here, y, eye, code, numbers, lights, bits, power, dull, phong, blinn, squared, rgb,
                row, start, stop, work, px, py, pz, nx, ny, nz, view, mu, base, red, green, blue, spare,
            )


@compiled
def draw_algebraic_ridges(
    runs, x, y_of_row, top, g, bump, powers, numbers, lights, bits, power, dull, phong, blinn, squared,
    rgb, planes, work,
):
    eye, radius, k_u, k_v, beta, epsilon = g[0], g[1], bump[0], bump[1], bump[2], bump[3]
    p = np.empty((ROWS, ROW_LENGTH))
    px, py, pz, nx, ny, nz, view = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    mu, base, red, green, blue, spare = p[7], p[8], p[9], p[10], p[11], p[12]
    cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v = p[7], p[8], p[9], p[10], p[11], p[12]  # until the lights come
    sin_u, cos_u, sin_v, cos_v, spare_real, spare_imaginary = p[0], p[1], p[2], p[3], p[4], p[5]
    for index in range(runs.shape[0]):
        row, start, stop, code = top + runs[index, 0], runs[index, 1], runs[index, 2], runs[index, 3]
        here, y, count = x[start:], y_of_row[runs[index, 0]], whole_groups(stop - start)
        angles_on_a_row(here, y, eye, radius, cos_theta, sin_theta, cos_phi, sin_phi, 0, count)
        powers_of_angles(cos_theta, sin_theta, -1.0, powers[0], cos_u, sin_u, spare_real, spare_imaginary, count)
        powers_of_angles(cos_phi, sin_phi, 1.0, powers[1], cos_v, sin_v, spare_real, spare_imaginary, count)
        gradient_from_factors_ridges_row(sin_u, cos_u, sin_v, cos_v, k_u, k_v, h_u, h_v, 0, count)
        work[0] += stop - start
        if planes is not None:
            keep_run(planes, row, start, stop, cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v)
        if rgb is None:
            continue
        lit, first, second = lights_of(code, bits)
        if lit == 1 or lit == 2:
            lights_on_a(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                lights, first, second, lit, px, py, pz, nx, dull, phong, blinn, squared, count,
            )
            color_run(
                code, numbers, lights, first, second, lit, power, dull, rgb, row, start, stop, work,
                px, py, pz, nx, red, green, blue, spare,
            )
        else:
            normal_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                px, py, pz, nx, ny, nz, view, 0, count,
            )
            shade_sphere_run(
                here, y, eye, code, numbers, lights, bits, power, dull, phong, blinn, squared, rgb,
                row, start, stop, work, px, py, pz, nx, ny, nz, view, mu, base, red, green, blue, spare,
            )


@compiled
def draw_general_rings(
    runs, x, y_of_row, top, g, bump, powers, numbers, lights, bits, power, dull, phong, blinn, squared,
    rgb, planes, work,
):
    eye, radius, k_u, k_v, beta, epsilon = g[0], g[1], bump[0], bump[1], bump[2], bump[3]
    p = np.empty((ROWS, ROW_LENGTH))
    px, py, pz, nx, ny, nz, view = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    mu, base, red, green, blue, spare = p[7], p[8], p[9], p[10], p[11], p[12]
    cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v = p[7], p[8], p[9], p[10], p[11], p[12]  # until the lights come
    u, v = p[0], p[1]
    for index in range(runs.shape[0]):
        row, start, stop, code = top + runs[index, 0], runs[index, 1], runs[index, 2], runs[index, 3]
        here, y, count = x[start:], y_of_row[runs[index, 0]], whole_groups(stop - start)
        angles_on_a_row(here, y, eye, radius, cos_theta, sin_theta, cos_phi, sin_phi, 0, count)
        chart_v_row(cos_phi, sin_phi, v, 0, count)
        gradient_rings_row(u, v, k_u, k_v, h_u, h_v, 0, count)
        work[0] += stop - start
        if planes is not None:
            keep_run(planes, row, start, stop, cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v)
        if rgb is None:
            continue
        lit, first, second = lights_of(code, bits)
        if lit == 1 or lit == 2:
            lights_on_a(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                lights, first, second, lit, px, py, pz, nx, dull, phong, blinn, squared, count,
            )
            color_run(
                code, numbers, lights, first, second, lit, power, dull, rgb, row, start, stop, work,
                px, py, pz, nx, red, green, blue, spare,
            )
        else:
            normal_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                px, py, pz, nx, ny, nz, view, 0, count,
            )
            shade_sphere_run(
                here, y, eye, code, numbers, lights, bits, power, dull, phong, blinn, squared, rgb,
                row, start, stop, work, px, py, pz, nx, ny, nz, view, mu, base, red, green, blue, spare,
            )


@compiled
def draw_forward_rings(
    runs, x, y_of_row, top, g, bump, powers, numbers, lights, bits, power, dull, phong, blinn, squared,
    rgb, planes, work,
):
    eye, radius, k_u, k_v, beta, epsilon = g[0], g[1], bump[0], bump[1], bump[2], bump[3]
    p = np.empty((ROWS, ROW_LENGTH))
    px, py, pz, nx, ny, nz, view = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    mu, base, red, green, blue, spare = p[7], p[8], p[9], p[10], p[11], p[12]
    cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v = p[7], p[8], p[9], p[10], p[11], p[12]  # until the lights come
    u, v = p[0], p[1]
    for index in range(runs.shape[0]):
        row, start, stop, code = top + runs[index, 0], runs[index, 1], runs[index, 2], runs[index, 3]
        here, y, count = x[start:], y_of_row[runs[index, 0]], whole_groups(stop - start)
        angles_on_a_row(here, y, eye, radius, cos_theta, sin_theta, cos_phi, sin_phi, 0, count)
        chart_v_row(cos_phi, sin_phi, v, 0, count)
        forward_rings_row(u, v, k_u, k_v, epsilon, h_u, h_v, 0, count)
        work[0] += stop - start
        if planes is not None:
            keep_run(planes, row, start, stop, cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v)
        if rgb is None:
            continue
        lit, first, second = lights_of(code, bits)
        if lit == 1 or lit == 2:
            lights_on_a(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                lights, first, second, lit, px, py, pz, nx, dull, phong, blinn, squared, count,
            )
            color_run(
                code, numbers, lights, first, second, lit, power, dull, rgb, row, start, stop, work,
                px, py, pz, nx, red, green, blue, spare,
            )
        else:
            normal_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                px, py, pz, nx, ny, nz, view, 0, count,
            )
            shade_sphere_run(
                here, y, eye, code, numbers, lights, bits, power, dull, phong, blinn, squared, rgb,
                row, start, stop, work, px, py, pz, nx, ny, nz, view, mu, base, red, green, blue, spare,
            )


@compiled
def draw_central_rings(
    runs, x, y_of_row, top, g, bump, powers, numbers, lights, bits, power, dull, phong, blinn, squared,
    rgb, planes, work,
):
    eye, radius, k_u, k_v, beta, epsilon = g[0], g[1], bump[0], bump[1], bump[2], bump[3]
    p = np.empty((ROWS, ROW_LENGTH))
    px, py, pz, nx, ny, nz, view = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    mu, base, red, green, blue, spare = p[7], p[8], p[9], p[10], p[11], p[12]
    cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v = p[7], p[8], p[9], p[10], p[11], p[12]  # until the lights come
    u, v = p[0], p[1]
    for index in range(runs.shape[0]):
        row, start, stop, code = top + runs[index, 0], runs[index, 1], runs[index, 2], runs[index, 3]
        here, y, count = x[start:], y_of_row[runs[index, 0]], whole_groups(stop - start)
        angles_on_a_row(here, y, eye, radius, cos_theta, sin_theta, cos_phi, sin_phi, 0, count)
        chart_v_row(cos_phi, sin_phi, v, 0, count)
        central_rings_row(u, v, k_u, k_v, epsilon, h_u, h_v, 0, count)
        work[0] += stop - start
        if planes is not None:
            keep_run(planes, row, start, stop, cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v)
        if rgb is None:
            continue
        lit, first, second = lights_of(code, bits)
        if lit == 1 or lit == 2:
            lights_on_a(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                lights, first, second, lit, px, py, pz, nx, dull, phong, blinn, squared, count,
            )
            color_run(
                code, numbers, lights, first, second, lit, power, dull, rgb, row, start, stop, work,
                px, py, pz, nx, red, green, blue, spare,
            )
        else:
            normal_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                px, py, pz, nx, ny, nz, view, 0, count,
            )
            shade_sphere_run(
                here, y, eye, code, numbers, lights, bits, power, dull, phong, blinn, squared, rgb,
                row, start, stop, work, px, py, pz, nx, ny, nz, view, mu, base, red, green, blue, spare,
            )


@compiled
def draw_central4_rings(
    runs, x, y_of_row, top, g, bump, powers, numbers, lights, bits, power, dull, phong, blinn, squared,
    rgb, planes, work,
):
    eye, radius, k_u, k_v, beta, epsilon = g[0], g[1], bump[0], bump[1], bump[2], bump[3]
    p = np.empty((ROWS, ROW_LENGTH))
    px, py, pz, nx, ny, nz, view = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    mu, base, red, green, blue, spare = p[7], p[8], p[9], p[10], p[11], p[12]
    cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v = p[7], p[8], p[9], p[10], p[11], p[12]  # until the lights come
    u, v = p[0], p[1]
    for index in range(runs.shape[0]):
        row, start, stop, code = top + runs[index, 0], runs[index, 1], runs[index, 2], runs[index, 3]
        here, y, count = x[start:], y_of_row[runs[index, 0]], whole_groups(stop - start)
        angles_on_a_row(here, y, eye, radius, cos_theta, sin_theta, cos_phi, sin_phi, 0, count)
        chart_v_row(cos_phi, sin_phi, v, 0, count)
        central4_rings_row(u, v, k_u, k_v, epsilon, h_u, h_v, 0, count)
        work[0] += stop - start
        if planes is not None:
            keep_run(planes, row, start, stop, cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v)
        if rgb is None:
            continue
        lit, first, second = lights_of(code, bits)
        if lit == 1 or lit == 2:
            lights_on_a(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                lights, first, second, lit, px, py, pz, nx, dull, phong, blinn, squared, count,
            )
            color_run(
                code, numbers, lights, first, second, lit, power, dull, rgb, row, start, stop, work,
                px, py, pz, nx, red, green, blue, spare,
            )
        else:
            normal_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                px, py, pz, nx, ny, nz, view, 0, count,
            )
            shade_sphere_run(
                here, y, eye, code, numbers, lights, bits, power, dull, phong, blinn, squared, rgb,
                row, start, stop, work, px, py, pz, nx, ny, nz, view, mu, base, red, green, blue, spare,
            )


@compiled
def draw_algebraic_rings(
    runs, x, y_of_row, top, g, bump, powers, numbers, lights, bits, power, dull, phong, blinn, squared,
    rgb, planes, work,
):
    eye, radius, k_u, k_v, beta, epsilon = g[0], g[1], bump[0], bump[1], bump[2], bump[3]
    p = np.empty((ROWS, ROW_LENGTH))
    px, py, pz, nx, ny, nz, view = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    mu, base, red, green, blue, spare = p[7], p[8], p[9], p[10], p[11], p[12]
    cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v = p[7], p[8], p[9], p[10], p[11], p[12]  # until the lights come
    sin_u, cos_u, sin_v, cos_v, spare_real, spare_imaginary = p[0], p[1], p[2], p[3], p[4], p[5]
    for index in range(runs.shape[0]):
        row, start, stop, code = top + runs[index, 0], runs[index, 1], runs[index, 2], runs[index, 3]
        here, y, count = x[start:], y_of_row[runs[index, 0]], whole_groups(stop - start)
        angles_on_a_row(here, y, eye, radius, cos_theta, sin_theta, cos_phi, sin_phi, 0, count)
        powers_of_angles(cos_phi, sin_phi, 1.0, powers[1], cos_v, sin_v, spare_real, spare_imaginary, count)
        gradient_from_factors_rings_row(sin_u, cos_u, sin_v, cos_v, k_u, k_v, h_u, h_v, 0, count)
        work[0] += stop - start
        if planes is not None:
            keep_run(planes, row, start, stop, cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v)
        if rgb is None:
            continue
        lit, first, second = lights_of(code, bits)
        if lit == 1 or lit == 2:
            lights_on_a(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                lights, first, second, lit, px, py, pz, nx, dull, phong, blinn, squared, count,
            )
            color_run(
                code, numbers, lights, first, second, lit, power, dull, rgb, row, start, stop, work,
                px, py, pz, nx, red, green, blue, spare,
            )
        else:
            normal_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, here, y, eye,
                px, py, pz, nx, ny, nz, view, 0, count,
            )
            shade_sphere_run(
                here, y, eye, code, numbers, lights, bits, power, dull, phong, blinn, squared, rgb,
                row, start, stop, work, px, py, pz, nx, ny, nz, view, mu, base, red, green, blue, spare,
            )


SHADERS = {
    "sine": {
        "general": draw_general_sine,
        "forward": draw_forward_sine,
        "central": draw_central_sine,
        "central4": draw_central4_sine,
        "algebraic": draw_algebraic_sine,
    },
    "ridges": {
        "general": draw_general_ridges,
        "forward": draw_forward_ridges,
        "central": draw_central_ridges,
        "central4": draw_central4_ridges,
        "algebraic": draw_algebraic_ridges,
    },
    "rings": {
        "general": draw_general_rings,
        "forward": draw_forward_rings,
        "central": draw_central_rings,
        "central4": draw_central4_rings,
        "algebraic": draw_algebraic_rings,
    },
}
