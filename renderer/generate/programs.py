"""Registry of the programs of `proofs/` that become kernels, by name."""

from functools import cache

from proofs.engine.program import Program
from proofs.engine.registry import by_name
from proofs.engine.vectors import real
from proofs.formulas import (
    algebraic_form,
    bounds,
    bump,
    camera,
    creases,
    displacement,
    elementary,
    exponential,
    finite_difference,
    height_fields,
    shading,
    shadow,
    shadow_cone,
)
from proofs.formulas.chart import chart, chart_radians
from proofs.formulas.height_fields import HeightField
from proofs.formulas.symbols import epsilon, h_v, k_u, k_v, mu, x, y

ELEMENTARY = {
    "two_product": elementary.two_product,
    "sinpi": elementary.sine_of_half_turns,
    "cospi": elementary.cosine_of_half_turns,
    "atan2pi": elementary.angle_in_half_turns,
    "exp": exponential.exponential_of_sum,
    "log": exponential.natural_logarithm,
    "power": exponential.raised,
}
"""Our own elementary functions. sinpi, cospi and exp take a product and its error, which is 0 unless it is given."""

KERNELS = (
    # once a scene
    camera.image_extent,
    camera.image_point.keep(x, name="image_x"),
    camera.image_point.keep(y, name="image_y"),
    camera.silhouette_of_a,
    bounds.tangent_interval,
    shadow_cone.shadow_clearance,
    shading.ambient_term,
    shading.floor_albedo,
    # places
    camera.visible_surface,
    camera.angles_on_a,
    camera.point_on_a,
    camera.normal_of_b,
    camera.normal_of_floor,
    camera.view_length,
    camera.view_direction,
    shadow.shadow,
    shadow.checker.keep(shadow.dark),
    # the gradient and the normal
    chart,
    chart_radians,
    algebraic_form.algebraic_bases,
    algebraic_form.complex_square,
    algebraic_form.complex_product,
    height_fields.slope,
    bump.bumped_normal,
    displacement.surface_slopes,
    # light
    shading.light_direction.keep(mu, name="light_cosine"),
    shading.height_of_light,
    *(part for model in shading.LIGHT_MODELS.values() for part in (model.program, model.squared) if part),
    shading.highlight,
    shading.light_term,
    shading.clip,
)
STEP = {epsilon: real("eps")}
"""ε by the name that it has from the command line on; formulas and statements spell it out."""


@cache
def differences() -> dict[str, Program]:
    """Return {name: program} of every difference of a function `height`, and of its part in v alone."""
    by_method: dict[str, Program] = {}
    for method, difference in finite_difference.METHODS.items():
        program = difference(height_fields.ANY_FIELD).at(STEP)
        by_method |= {method: program, f"{method}_in_v": program.keep(h_v)}
    return by_method


def difference_of(method: str, field: HeightField) -> str:
    """Return the name of a field's difference: that in v alone where h does not depend on u."""
    return method if field.depends_on_u else f"{method}_in_v"


def height_evaluations(method: str, field: HeightField) -> int:
    """Return how many heights a difference of the field evaluates."""
    lines = differences()[difference_of(method, field)].definitions
    return sum(symbol in finite_difference.HEIGHTS for symbol, _ in lines)


@cache
def field_programs(field: HeightField) -> dict[str, Program]:
    """Return {role: program} of a height field: its height, exact gradient, creases, and algebraic form."""
    programs = {
        "height": height_fields.height(field),
        "gradient": height_fields.gradient(field),
        "kink": creases.kink_flag(field),
        "straddling": creases.straddling(field).at(STEP),
    }
    if field.wave_numbers:
        waves = real("a b")
        programs["gradient_from_factors"] = height_fields.gradient_from_factors(field)
        programs["wave_numbers"] = Program(f"wave_numbers_{field.name}", (k_u, k_v), {waves: field.wave_numbers}, waves)
    return programs


def named() -> dict[str, Program]:
    """Return {name in renderer/kernels.py: program} of every kernel but the differences, in the order of the file.

    Raises ValueError where two programs have one name.
    """
    of_fields = [p for field in height_fields.HEIGHT_FIELDS.values() for p in field_programs(field).values()]
    return ELEMENTARY | by_name((*KERNELS, *of_fields))
