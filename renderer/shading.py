"""Light on a run of pixels: ambient, then each light's cosine and highlight, then the clip.

One or two lights, which is what most pixels see, are done at once (`renderer.lights`); more, one after another.

What a scene does not need is left out: a light that is occluded or black, and the highlight where k_s = 0.
"""

import numpy as np

from renderer.chambers import ALL_BITS, DARK_BIT, FLOOR, LONGEST_RUN, SPHERE_B, SURFACE_BITS, run_end, whole_groups
from renderer.kernels import (
    blinn_on_floor_row,
    blinn_row,
    blinn_squared_on_floor_row,
    blinn_squared_row,
    clip_row,
    compiled,
    diffuse_term_row,
    highlight_row,
    inlined,
    light_cosine_on_floor_row,
    light_cosine_row,
    light_term_row,
    multiply_row,
    normal_of_b_row,
    phong_on_floor_row,
    phong_row,
    pixels,
    sixteenth_power_row,
    square_row,
    view_length_row,
)
from renderer.lights import add_lights_on_floor, add_lights_on_sphere, lights_on_floor

ROW_LENGTH = LONGEST_RUN + 8  # not a power of two, or all rows would fall on the same lines of the cache
ROWS = 13
"""How many working rows a run needs, each ROW_LENGTH long: the point (px, py, pz), the normal (nx, ny, nz), the view
scale, μ, the base of the highlight, the colour (red, green, blue), a spare row. They are handed on one by one: Numba
counts a reference whenever a row is taken from a 2-D array, which costs more than the arithmetic of a short run."""

WORK = ("gradients", "specular_powers", "light_terms")  # what the kernels count


@inlined
def fill(row, value, count):
    """Write one value into the first pixels of a row."""
    for i in pixels(0, count):
        row[i] = value


@inlined
def lights_of(code, bits):
    """Return how many lights reach a chamber, and the first and the second of them."""
    lit, first, second = np.int64(0), np.int64(0), np.int64(0)  # a literal would compile what follows once more
    for light in range(bits.shape[0]):
        if not code & bits[light]:
            lit += 1
            if lit == 1:
                first = light
            elif lit == 2:
                second = light
    return lit, first, second


@inlined
def albedo_of(numbers, code):
    """Return the red, green and blue albedo of a chamber."""
    surface = code & SURFACE_BITS
    if surface == FLOOR:
        first = 14 if code & DARK_BIT else 12
        return numbers[first], numbers[first], numbers[first + 1]
    first = 9 if surface == SPHERE_B else 6
    return numbers[first], numbers[first + 1], numbers[first + 2]


@compiled
def raise_to_shininess(base, spare, shininess, power, count):
    """Raise a row to the shininess, in place: by repeated squaring if that is whole, else by pow."""
    if power == 0:
        highlight_row(base, shininess, base, 0, count)
        return
    while not power & 15:
        sixteenth_power_row(base, 0, count)
        power >>= 4
    while not power & 1:
        square_row(base, 0, count)
        power >>= 1
    if power == 1:
        return
    for i in pixels(0, count):
        spare[i] = base[i]
    power >>= 1
    while power:
        square_row(spare, 0, count)
        if power & 1:
            multiply_row(base, spare, 0, count)
        power >>= 1


@inlined
def _light_on_floor(x, y, eye, light, view, mu, base, dull, phong, blinn, squared, count):
    """Write μ and the highlight's base of one light on a run of the floor."""
    lx, ly, lz = light[0], light[1], light[2]
    if dull is not None:
        light_cosine_on_floor_row(x, y, lx, ly, lz, mu, 0, count)
    if phong is not None:
        phong_on_floor_row(x, y, eye, view, lx, ly, lz, mu, base, 0, count)
    if squared is not None:
        blinn_squared_on_floor_row(x, y, eye, view, lx, ly, lz, mu, base, 0, count)
    if blinn is not None:
        blinn_on_floor_row(x, y, eye, view, lx, ly, lz, mu, base, 0, count)


@inlined
def light_on_sphere(x, y, eye, light, px, py, pz, nx, ny, nz, view, mu, base, dull, phong, blinn, squared, count):
    """Write μ and the highlight's base of one light on a run of A or B: points, normals and view scales are given."""
    lx, ly, lz = light[0], light[1], light[2]
    if dull is not None:
        light_cosine_row(px, py, pz, lx, ly, lz, nx, ny, nz, mu, 0, count)
    if phong is not None:
        phong_row(x, y, eye, view, px, py, pz, lx, ly, lz, nx, ny, nz, mu, base, 0, count)
    if squared is not None:
        blinn_squared_row(x, y, eye, view, px, py, pz, lx, ly, lz, nx, ny, nz, mu, base, 0, count)
    if blinn is not None:
        blinn_row(x, y, eye, view, px, py, pz, lx, ly, lz, nx, ny, nz, mu, base, 0, count)


@inlined
def _add_light(numbers, light, albedo, mu, base, red, green, blue, spare, power, dull, count, pixels, work):
    """Add one light to the colours of a run, from its μ and the base of its highlight."""
    lr, lg, lb, kd, ks = light[3], light[4], light[5], numbers[0], numbers[1]
    work[2] += pixels
    if dull is not None:
        diffuse_term_row(red, green, blue, lr, lg, lb, albedo[0], albedo[1], albedo[2], kd, mu, 0, count)
    if dull is None:
        work[1] += pixels
        raise_to_shininess(base, spare, numbers[2], power, count)
        light_term_row(red, green, blue, lr, lg, lb, albedo[0], albedo[1], albedo[2], kd, ks, mu, base, 0, count)


@inlined
def _keep_row(values, target):
    for i in pixels(0, target.shape[0]):
        target[i] = values[i]


@compiled
def keep_run(planes, row, start, stop, cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v):
    """Copy the angles and the gradient of a run of A into (6, height, width)."""
    _keep_row(cos_theta, planes[0, row, start:stop])
    _keep_row(sin_theta, planes[1, row, start:stop])
    _keep_row(cos_phi, planes[2, row, start:stop])
    _keep_row(sin_phi, planes[3, row, start:stop])
    _keep_row(h_u, planes[4, row, start:stop])
    _keep_row(h_v, planes[5, row, start:stop])


@inlined
def _ambient(numbers, red, green, blue, count):
    fill(red, numbers[3], count)
    fill(green, numbers[4], count)
    fill(blue, numbers[5], count)


@inlined
def _clip_into(rgb, red, green, blue, row, start, stop):
    to = slice(start, stop)
    clip_row(red, green, blue, rgb[0, row, to], rgb[1, row, to], rgb[2, row, to], 0, stop - start)


@inlined
def raise_both(numbers, lit, base, other_base, spare, power, dull, count, pixels, work):
    """Raise the highlights' bases of one or two lights to the shininess, and count the work."""
    work[2] += lit * pixels
    if dull is None:
        work[1] += lit * pixels
        raise_to_shininess(base, spare, numbers[2], power, count)
        if lit == 2:
            raise_to_shininess(other_base, spare, numbers[2], power, count)


@compiled
def color_run(
    code, numbers, lights, first, second, lit, power, dull, rgb, row, start, stop, work,
    mu, base, other_mu, other_base, red, green, blue, spare,
):  # fmt: skip
    """Write the colours of a run of a sphere under one or two lights, given μ and the highlight's base of each."""
    count, albedo = whole_groups(stop - start), albedo_of(numbers, code)
    raise_both(numbers, lit, base, other_base, spare, power, dull, count, stop - start, work)
    add_lights_on_sphere(
        numbers, albedo, lights, first, second, lit, mu, base, other_mu, other_base, red, green, blue, dull, count
    )
    _clip_into(rgb, red, green, blue, row, start, stop)


@inlined
def _floor_albedo(codes, row, start, stop, numbers, albedo, albedo_blue):
    """Write the albedo of a run of the floor: of its dark or its light squares."""
    code_row = codes[row, start:stop]
    for i in pixels(0, stop - start):
        dark = code_row[i] // DARK_BIT
        albedo[i] = numbers[12 + 2 * dark]
        albedo_blue[i] = numbers[13 + 2 * dark]


@compiled
def shade_sphere_run(
    x, y, eye, code, numbers, lights, bits, power, dull, phong, blinn, squared, rgb, row, start, stop, work,
    px, py, pz, nx, ny, nz, view, mu, base, red, green, blue, spare,
):  # fmt: skip
    """Write the colours of a run [start, stop) of A or B into a row of `rgb`, (3, height, width). x begins there.

    The points, normals and view scales of its pixels are given, the other working rows are used up.
    """
    count, albedo = whole_groups(stop - start), albedo_of(numbers, code)
    _ambient(numbers, red, green, blue, count)
    for light in range(lights.shape[0]):
        if not code & bits[light]:
            light_on_sphere(
                x, y, eye, lights[light], px, py, pz, nx, ny, nz, view, mu, base, dull, phong, blinn, squared, count
            )
            _add_light(
                numbers,
                lights[light],
                albedo,
                mu,
                base,
                red,
                green,
                blue,
                spare,
                power,
                dull,
                count,
                stop - start,
                work,
            )
    _clip_into(rgb, red, green, blue, row, start, stop)


@compiled
def _shade_floor_run(
    x, y, eye, code, numbers, lights, bits, power, dull, phong, blinn, squared, rgb, row, start, stop, work,
    view, mu, base, red, green, blue, spare,
):  # fmt: skip
    count, albedo = whole_groups(stop - start), albedo_of(numbers, code)
    _ambient(numbers, red, green, blue, count)
    if dull is None:
        view_length_row(x, y, eye, view, 0, count)
    for light in range(lights.shape[0]):
        if not code & bits[light]:
            _light_on_floor(x, y, eye, lights[light], view, mu, base, dull, phong, blinn, squared, count)
            _add_light(
                numbers,
                lights[light],
                albedo,
                mu,
                base,
                red,
                green,
                blue,
                spare,
                power,
                dull,
                count,
                stop - start,
                work,
            )
    _clip_into(rgb, red, green, blue, row, start, stop)


@compiled
def shade_elsewhere(
    runs, x, y_of_row, top, g, numbers, lights, bits, power, dull, phong, blinn, squared, rgb, work, codes
):
    """Write the colours of a band's runs off sphere A into `rgb`, (3, height, width); row `top` is the band's first.

    codes: (height, width), the chambers.
    """
    p = np.empty((ROWS, ROW_LENGTH))
    px, py, pz, nx, ny, nz, view = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    mu, base, red, green, blue, spare = p[7], p[8], p[9], p[10], p[11], p[12]
    eye, bx, by, bz, ball_radius, ball_on = g[0], g[2], g[3], g[4], g[5], g[6]
    for index in range(runs.shape[0]):
        row, start, stop, code = top + runs[index, 0], runs[index, 1], runs[index, 2], runs[index, 3]
        here, y, surface = x[start:], y_of_row[runs[index, 0]], code & SURFACE_BITS
        if surface == SPHERE_B:
            normal_of_b_row(
                here,
                y,
                eye,
                bx,
                by,
                bz,
                ball_radius,
                ball_on,
                px,
                py,
                pz,
                nx,
                ny,
                nz,
                view,
                0,
                whole_groups(stop - start),
            )
            shade_sphere_run(
                here, y, eye, code, numbers, lights, bits, power, dull, phong, blinn, squared, rgb,
                row, start, stop, work,
                px, py, pz, nx, ny, nz, view, mu, base, red, green, blue, spare,
            )  # fmt: skip
        elif surface == FLOOR:
            lit, first, second = lights_of(code, bits)
            if lit == 1 or lit == 2:
                count = whole_groups(stop - start)
                lights_on_floor(
                    here, y, eye, lights, first, second, lit, mu, base, px, py, dull, phong, blinn, squared, count
                )
                raise_both(numbers, lit, base, py, spare, power, dull, count, stop - start, work)
                _floor_albedo(codes, row, start, stop, numbers, pz, nx)
                add_lights_on_floor(
                    numbers, pz, nx, lights, first, second, lit, mu, base, px, py, red, green, blue, dull, count
                )
                _clip_into(rgb, red, green, blue, row, start, stop)
                continue
            while start < stop:  # square by square
                end = run_end(codes[row], start, stop, ALL_BITS)
                _shade_floor_run(
                    x[start:], y, eye, codes[row, start], numbers, lights, bits, power, dull, phong, blinn, squared,
                    rgb, row, start, end, work, view, mu, base, red, green, blue, spare,
                )  # fmt: skip
                start = end
        else:
            for channel in range(3):
                fill(rgb[channel, row, start:stop], 0.0, stop - start)


@compiled
def copy_runs(runs, top, source, rgb):
    """Copy the colours of a band's runs from one picture to another, both (3, height, width)."""
    for index in range(runs.shape[0]):
        row, start, stop = top + runs[index, 0], runs[index, 1], runs[index, 2]
        for channel in range(3):
            _keep_row(source[channel, row, start:stop], rgb[channel, row, start:stop])
