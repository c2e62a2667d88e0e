"""Generated from proofs/ by `python -m renderer.generate`. Do not edit: it is printed there.

One or two of the lights, `lights[first]` and `lights[second]`, on a run of `count` pixels: μ and the base of the
highlight into `mu` and `base`, the other light's into `other_mu` and `other_base`; then the colours. The albedo is
a sphere's (red, green, blue), or two rows: red and green, and blue.
"""

from renderer.kernels import (
    blinn_of_1_on_a_row,
    blinn_of_1_on_floor_row,
    blinn_of_2_on_a_row,
    blinn_of_2_on_floor_row,
    compiled,
    diffuse_terms_of_1_on_floor_row,
    diffuse_terms_of_1_on_sphere_row,
    diffuse_terms_of_2_on_floor_row,
    diffuse_terms_of_2_on_sphere_row,
    dull_of_1_on_a_row,
    dull_of_1_on_floor_row,
    dull_of_2_on_a_row,
    dull_of_2_on_floor_row,
    light_terms_of_1_on_floor_row,
    light_terms_of_1_on_sphere_row,
    light_terms_of_2_on_floor_row,
    light_terms_of_2_on_sphere_row,
    phong_of_1_on_a_row,
    phong_of_1_on_floor_row,
    phong_of_2_on_a_row,
    phong_of_2_on_floor_row,
    squared_of_1_on_a_row,
    squared_of_1_on_floor_row,
    squared_of_2_on_a_row,
    squared_of_2_on_floor_row,
)


@compiled
def lights_on_floor(
    x, y, eye,
    lights, first, second, lit, mu, base, other_mu, other_base,
    dull, phong, blinn, squared, count,
):
    if dull is not None:
        if lit == 1:
            dull_of_1_on_floor_row(
                x, y, lights[first, 0], lights[first, 1], lights[first, 2], mu, 0, count,
            )
        else:
            dull_of_2_on_floor_row(
                x, y, lights[first, 0], lights[first, 1], lights[first, 2], lights[second, 0], lights[second,
                1], lights[second, 2], mu, other_mu, 0, count,
            )
    if blinn is not None:
        if lit == 1:
            blinn_of_1_on_floor_row(
                x, y, eye, lights[first, 0], lights[first, 1], lights[first, 2], mu, base, 0, count,
            )
        else:
            blinn_of_2_on_floor_row(
                x, y, eye, lights[first, 0], lights[first, 1], lights[first, 2], lights[second, 0],
                lights[second, 1], lights[second, 2], mu, base, other_mu, other_base, 0, count,
            )
    if phong is not None:
        if lit == 1:
            phong_of_1_on_floor_row(
                x, y, eye, lights[first, 0], lights[first, 1], lights[first, 2], mu, base, 0, count,
            )
        else:
            phong_of_2_on_floor_row(
                x, y, eye, lights[first, 0], lights[first, 1], lights[first, 2], lights[second, 0],
                lights[second, 1], lights[second, 2], mu, base, other_mu, other_base, 0, count,
            )
    if squared is not None:
        if lit == 1:
            squared_of_1_on_floor_row(
                x, y, eye, lights[first, 0], lights[first, 1], lights[first, 2], mu, base, 0, count,
            )
        else:
            squared_of_2_on_floor_row(
                x, y, eye, lights[first, 0], lights[first, 1], lights[first, 2], lights[second, 0],
                lights[second, 1], lights[second, 2], mu, base, other_mu, other_base, 0, count,
            )


@compiled
def lights_on_a(
    cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, x, y, eye,
    lights, first, second, lit, mu, base, other_mu, other_base,
    dull, phong, blinn, squared, count,
):
    if dull is not None:
        if lit == 1:
            dull_of_1_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, lights[first, 0], lights[first,
                1], lights[first, 2], mu, 0, count,
            )
        else:
            dull_of_2_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, lights[first, 0], lights[first,
                1], lights[first, 2], lights[second, 0], lights[second, 1], lights[second, 2], mu, other_mu, 0,
                count,
            )
    if blinn is not None:
        if lit == 1:
            blinn_of_1_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, x, y, eye, lights[first, 0],
                lights[first, 1], lights[first, 2], mu, base, 0, count,
            )
        else:
            blinn_of_2_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, x, y, eye, lights[first, 0],
                lights[first, 1], lights[first, 2], lights[second, 0], lights[second, 1], lights[second, 2],
                mu, base, other_mu, other_base, 0, count,
            )
    if phong is not None:
        if lit == 1:
            phong_of_1_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, x, y, eye, lights[first, 0],
                lights[first, 1], lights[first, 2], mu, base, 0, count,
            )
        else:
            phong_of_2_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, x, y, eye, lights[first, 0],
                lights[first, 1], lights[first, 2], lights[second, 0], lights[second, 1], lights[second, 2],
                mu, base, other_mu, other_base, 0, count,
            )
    if squared is not None:
        if lit == 1:
            squared_of_1_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, x, y, eye, lights[first, 0],
                lights[first, 1], lights[first, 2], mu, base, 0, count,
            )
        else:
            squared_of_2_on_a_row(
                cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, x, y, eye, lights[first, 0],
                lights[first, 1], lights[first, 2], lights[second, 0], lights[second, 1], lights[second, 2],
                mu, base, other_mu, other_base, 0, count,
            )


@compiled
def add_lights_on_sphere(
    numbers, albedo,
    lights, first, second, lit, mu, base, other_mu, other_base,
    red, green, blue, dull, count,
):
    if dull is not None:
        if lit == 1:
            diffuse_terms_of_1_on_sphere_row(
                mu, numbers[3], numbers[4], numbers[5], lights[first, 3], lights[first, 4], lights[first, 5],
                albedo[0], albedo[1], albedo[2], numbers[0], red, green, blue, 0, count,
            )
        else:
            diffuse_terms_of_2_on_sphere_row(
                mu, numbers[3], numbers[4], numbers[5], lights[first, 3], lights[first, 4], lights[first, 5],
                albedo[0], albedo[1], albedo[2], numbers[0], lights[second, 3], lights[second, 4],
                lights[second, 5], other_mu, red, green, blue, 0, count,
            )
    if dull is None:
        if lit == 1:
            light_terms_of_1_on_sphere_row(
                numbers[3], numbers[4], numbers[5], lights[first, 3], lights[first, 4], lights[first, 5],
                albedo[0], albedo[1], albedo[2], numbers[0], numbers[1], mu, base, red, green, blue, 0, count,
            )
        else:
            light_terms_of_2_on_sphere_row(
                numbers[3], numbers[4], numbers[5], lights[first, 3], lights[first, 4], lights[first, 5],
                albedo[0], albedo[1], albedo[2], numbers[0], numbers[1], mu, base, lights[second, 3],
                lights[second, 4], lights[second, 5], other_mu, other_base, red, green, blue, 0, count,
            )


@compiled
def add_lights_on_floor(
    numbers, albedo, albedo_blue,
    lights, first, second, lit, mu, base, other_mu, other_base,
    red, green, blue, dull, count,
):
    if dull is not None:
        if lit == 1:
            diffuse_terms_of_1_on_floor_row(
                mu, numbers[3], numbers[4], numbers[5], lights[first, 3], lights[first, 4], lights[first, 5],
                albedo, albedo, albedo_blue, numbers[0], red, green, blue, 0, count,
            )
        else:
            diffuse_terms_of_2_on_floor_row(
                mu, numbers[3], numbers[4], numbers[5], lights[first, 3], lights[first, 4], lights[first, 5],
                albedo, albedo, albedo_blue, numbers[0], lights[second, 3], lights[second, 4], lights[second,
                5], other_mu, red, green, blue, 0, count,
            )
    if dull is None:
        if lit == 1:
            light_terms_of_1_on_floor_row(
                numbers[3], numbers[4], numbers[5], lights[first, 3], lights[first, 4], lights[first, 5],
                albedo, albedo, albedo_blue, numbers[0], numbers[1], mu, base, red, green, blue, 0, count,
            )
        else:
            light_terms_of_2_on_floor_row(
                numbers[3], numbers[4], numbers[5], lights[first, 3], lights[first, 4], lights[first, 5],
                albedo, albedo, albedo_blue, numbers[0], numbers[1], mu, base, lights[second, 3],
                lights[second, 4], lights[second, 5], other_mu, other_base, red, green, blue, 0, count,
            )
