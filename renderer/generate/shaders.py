"""The text of `renderer/shaders.py`: for every field and way to its gradient, the loop over sphere A's runs.

Numba calls a function fast only if its name is known when it compiles, so that what differs by a name is printed.
"""

import textwrap

from proofs.height_fields import HEIGHT_FIELDS
from proofs.symbols import u
from renderer.generate.kernel_list import field_kernels

HEADER = '''"""Generated from proofs/ by `python -m renderer.generate`. Do not edit: it is printed there.

Each function draws sphere A's runs of a band: angles, gradient, normal, lights; one for each field and way to its
gradient. `bump` is k_u, k_v, β and ε; `powers` those of the algebraic form. It writes the colours into `rgb`, (3,
height, width), and cos θ, sin θ, cos φ, sin φ, h_u, h_v into `planes`, (6, height, width); None for what is not wanted.
The band's first row is row `top` of the picture.
"""

import numpy as np

from renderer.chambers import whole_groups
from renderer.kernels import (
'''

IMPORTS = """)
from renderer.lights import lights_on_a
from renderer.powers import powers_of_angles
from renderer.shading import ROW_LENGTH, ROWS, color_run, fill, keep_run, lights_of, shade_sphere_run
"""

TEMPLATE = """

@compiled
def {name}(
    runs, x, y_of_row, top, g, bump, powers, numbers, lights, bits, power, dull, phong, blinn, squared,
    rgb, planes, work,
):
    eye, radius, k_u, k_v, beta, epsilon = g[0], g[1], bump[0], bump[1], bump[2], bump[3]
    p = np.empty((ROWS, ROW_LENGTH))
    px, py, pz, nx, ny, nz, view = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    mu, base, red, green, blue, spare = p[7], p[8], p[9], p[10], p[11], p[12]
    cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v = p[7], p[8], p[9], p[10], p[11], p[12]  # until the lights come
{before}
    for index in range(runs.shape[0]):
        row, start, stop, code = top + runs[index, 0], runs[index, 1], runs[index, 2], runs[index, 3]
        here, y, count = x[start:], y_of_row[runs[index, 0]], whole_groups(stop - start)
        angles_on_a_row(here, y, eye, radius, cos_theta, sin_theta, cos_phi, sin_phi, 0, count)
{gradient}
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
"""


def wrapped(function, arguments):
    """Return the lines of a call."""
    return [f"{function}(", *(f"    {line}" for line in textwrap.wrap(", ".join(arguments) + ",", 95)), ")"]


def _call(program, arguments):
    return f"{program.name}_row({', '.join(arguments)}, 0, count)"


def _gradient_lines(field, role, program):
    """Return the line before the loop, the lines that leave h_u and h_v in their rows, and the kernels they call."""
    calls = [f"{program.name}_row"]
    if role == "algebraic":
        before = "sin_u, cos_u, sin_v, cos_v, spare_real, spare_imaginary = p[0], p[1], p[2], p[3], p[4], p[5]"
        spare = "spare_real, spare_imaginary, count"
        lines = [f"powers_of_angles(cos_phi, sin_phi, 1.0, powers[1], cos_v, sin_v, {spare})"]
        if field.expression.has(u):
            lines.insert(0, f"powers_of_angles(cos_theta, sin_theta, -1.0, powers[0], cos_u, sin_u, {spare})")
    else:
        before, both = "u, v = p[0], p[1]", field.expression.has(u)
        lines = [
            "chart_row(cos_theta, sin_theta, cos_phi, sin_phi, u, v, 0, count)"
            if both
            else "chart_v_row(cos_phi, sin_phi, v, 0, count)"
        ]
        calls.append("chart_row" if both else "chart_v_row")
    return (
        before,
        [*lines, _call(program, [*(s.name for s in program.inputs), "h_u", "h_v"]), "work[0] += stop - start"],
        calls,
    )


def _shader(name, before, lines):
    return TEMPLATE.format(name=name, before=f"    {before}", gradient="\n".join(f"        {line}" for line in lines))


def shaders_source():
    """Return the text of renderer/shaders.py."""
    flat = [f"fill({row}, 0.0, count)" for row in ("h_u", "h_v")]
    bodies, table = [_shader("draw_flat", "", flat).replace("\n    \n", "\n")], []
    calls = {"angles_on_a_row", "compiled", "normal_on_a_row"}
    for field in HEIGHT_FIELDS.values():
        table.append(f'    "{field.name}": {{')
        programs = {k.program.name.removesuffix(f"_{field.name}"): k.program for k in field_kernels(field)}
        for role, program in programs.items():
            if role not in ("gradient", "gradient_from_factors", "forward", "central", "central4"):
                continue
            role = {"gradient": "general", "gradient_from_factors": "algebraic"}.get(role, role)
            before, lines, called = _gradient_lines(field, role, program)
            calls.update(called)
            bodies.append(_shader(f"draw_{role}_{field.name}", before, lines))
            table.append(f'        "{role}": draw_{role}_{field.name},')
        table.append("    },")
    imports = "".join(f"    {name},\n" for name in sorted(calls))
    return HEADER + imports + IMPORTS + "".join(bodies) + "\n\nSHADERS = {\n" + "\n".join([*table, "}", ""])
