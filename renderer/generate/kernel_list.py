"""Which programs become row kernels, and which of their inputs vary along a row."""

from dataclasses import dataclass

from proofs import (
    algebraic_form,
    bounds,
    bump,
    camera,
    creases,
    finite_difference,
    height_fields,
    shading,
    shadow,
    shadow_cone,
)
from proofs.chart import chart
from proofs.program import Program, chain
from proofs.symbols import (
    bumped,
    cos_phi,
    cos_theta,
    h_u,
    h_v,
    mu,
    normal,
    point,
    real,
    sin_phi,
    sin_theta,
    specular,
    specular_base,
    u,
    v,
    x,
)

ANGLES = (cos_theta, sin_theta, cos_phi, sin_phi)


@dataclass(frozen=True)
class RowKernel:
    """A program, and which of its inputs are rows (the rest are scalars). Outputs are rows.

    `into` renames outputs, so that a kernel may overwrite one of its input rows.
    """

    program: Program
    rows: tuple
    into: tuple = ()


def _chamber_kernels():
    """Return the visible surface, and the shadow test at the visible points of each, straight from the image point."""
    on_a = chain("shadow_on_a", camera.angles_on_a, camera.point_on_a, shadow.shadow)
    on_b = chain("shadow_on_b", camera.point_on_b, shadow.shadow)
    on_floor = chain("shadow_on_floor", camera.point_on_floor, shadow.shadow)
    dark = chain("checker", camera.point_on_floor, shadow.checker).keep(shadow.dark)
    return [RowKernel(p, (x,)) for p in (camera.visible_surface, on_a, on_b, on_floor, dark)]


def _geometry_kernels():
    """Return the kernels that place points and normals on the spheres, and say how far the eye is."""
    along = (*point, *bumped, camera.view_scale)
    on_a = chain("normal_on_a", bump.bumped_normal, camera.point_of_normal, camera.view_length, outputs=along)
    on_b = chain("normal_of_b", camera.normal_of_b, camera.view_length, outputs=(*point, *normal, camera.view_scale))
    return [
        RowKernel(camera.angles_on_a, (x,)),
        RowKernel(chart, ANGLES),
        RowKernel(chart.keep(v, name="chart_v"), ANGLES[2:]),
        RowKernel(on_a, (*ANGLES, h_u, h_v, x)),
        RowKernel(on_b, (x,), along),
        RowKernel(camera.view_length, (x,)),
    ]


def _power_kernels():
    """Return the kernels that square and multiply complex numbers and highlights, in place."""
    a, b = algebraic_form.real_part, algebraic_form.imaginary_part
    c, d = algebraic_form.other_real, algebraic_form.other_imaginary
    base, power, second, fourth, eighth = real("base power second fourth eighth")
    square = Program("square", (base,), ((power, base**2),), (power,))
    squarings = ((second, base**2), (fourth, second**2), (eighth, fourth**2), (power, eighth**2))
    sixteenth = Program("sixteenth_power", (base,), squarings, (power,))
    multiply = Program("multiply", (specular, base), ((power, specular * base),), (power,))
    return [
        RowKernel(algebraic_form.complex_square, (a, b), (a, b)),
        RowKernel(_twice(algebraic_form.complex_square), (a, b), (a, b)),
        RowKernel(algebraic_form.complex_product, (a, b, c, d), (a, b)),
        RowKernel(square, (base,), (base,)),
        RowKernel(sixteenth, (base,), (base,)),
        RowKernel(multiply, (specular, base), (specular,)),
    ]


def _twice(program):
    """Return a program done twice in a row, its outputs being its inputs: `{name}_twice`."""
    first = {out: real(f"{out.name}_once") for out in program.outputs}
    lines = tuple((first[symbol], expression) for symbol, expression in program.definitions)
    again = dict(zip(program.inputs, (first[out] for out in program.outputs), strict=True))
    lines += tuple((symbol, expression.xreplace(again)) for symbol, expression in program.definitions)
    return Program(f"{program.name}_twice", program.inputs, lines, program.outputs)


def difference(method, field):
    """Return a difference method's program for a field; where h does not depend on u, without a difference in u."""
    program = finite_difference.METHODS[method](field)
    if field.expression.has(u):
        return program
    lines = tuple((s, 0 * u if s == h_u else e) for s, e in program.definitions)
    needed = Program(program.name, program.inputs, lines, program.outputs).reaches(*program.outputs)
    return Program(program.name, program.inputs, tuple(line for line in lines if line[0] in needed), program.outputs)


def height_evaluations(method, field):
    """Return how many heights a difference of the field evaluates."""
    heights = set(finite_difference.HEIGHTS)
    return sum(symbol in heights for symbol, _ in difference(method, field).definitions)


def field_kernels(field):
    """Return one field's kernels: height, exact gradient, differences, creases."""
    kernels = [
        RowKernel(height_fields.height(field), (u, v)),
        RowKernel(height_fields.gradient(field), (u, v)),
        RowKernel(creases.kink_flag(field), (sin_phi, u, v)),
        RowKernel(creases.straddling(field), (u, v)),
    ]
    kernels += [RowKernel(difference(method, field), (u, v)) for method in finite_difference.METHODS]
    if field.wave_numbers:
        tail = height_fields.gradient_from_factors(field)
        kernels.append(RowKernel(tail, tail.inputs[:4]))
    return kernels


def _light_kernels():
    """Return each model of the highlight, and the cosine alone, on the spheres and (folded) on the floor."""
    kernels = []
    for name, model in {**shading.MODELS, "blinn_squared": shading.blinn_squared}.items():
        seen = chain(name, camera.view_direction, model, outputs=(mu, specular_base))
        kernels.append(RowKernel(seen, (*point, *bumped, x, camera.view_scale)))
        below = chain(f"{name}_on_floor", camera.normal_of_floor, seen, outputs=seen.outputs)
        kernels.append(RowKernel(below.folded(), (x, camera.view_scale)))
    cosine = shading.light_direction.keep(mu, name="light_cosine")
    below = chain("light_cosine_on_floor", camera.normal_of_floor, cosine, outputs=(mu,))
    return [*kernels, RowKernel(cosine, (*point, *bumped)), RowKernel(below.folded(), (x,))]


def _shading_kernels():
    colors = shading.colors
    diffuse = chain("diffuse_term", Program("dull", (), ((specular, 0 * mu),), ()), shading.light_term)
    clip = Program(
        "clip", colors, tuple(zip(shading.lit, map(shading.clipped_value, colors), strict=True)), shading.lit
    )
    return [
        *_light_kernels(),
        RowKernel(shading.highlight, (specular_base,)),
        RowKernel(shading.light_term, (*colors, mu, specular), colors),
        RowKernel(diffuse.folded(), (*colors, mu), colors),
        RowKernel(clip, colors),
        RowKernel(height_fields.slope, (h_u, h_v)),
    ]


ROW_KERNELS = [*_chamber_kernels(), *_geometry_kernels(), *_power_kernels(), *_shading_kernels()]

DISCRIMINANT_OF_A = camera.hit_of_a.keep(camera.discriminant_a, name="discriminant_of_a")

ONCE_A_SCENE = [
    camera.image_extent,
    camera.image_point.keep(x, name="image_x"),
    camera.image_point.keep(camera.y, name="image_y"),
    bounds.tangent_interval,
    shadow_cone.shadow_clearance,
    shading.ambient_term,
    shading.floor_albedo,
]
"""What is evaluated once a scene or raster: not worth compiling."""

SCALAR_PROGRAMS = [DISCRIMINANT_OF_A, *ONCE_A_SCENE]
