"""The whole pixel as one straight-line program: from (column, row) and the scene to its chamber and its colour.

The same programs that the kernels print, joined: what a theorem about a pixel speaks of, and the 50-digit reference.
"""

from collections.abc import Collection, Mapping

from sympy import Eq, Expr, Max, Piecewise, Symbol

from proofs.engine.program import Program, chain, evaluated
from proofs.formulas import camera, shading, shadow
from proofs.formulas.bump import bumped_normal
from proofs.formulas.chart import chart
from proofs.formulas.height_fields import HeightField, gradient
from proofs.formulas.symbols import (
    Vector,
    ball_center,
    ball_on,
    bumped,
    light,
    mu,
    normal,
    point,
    radius,
    real,
    specular,
    vector,
    where,
)

CHANNELS = ("red", "green", "blue")
dark_square = real("dark_square")
rgb = real("rgb_red rgb_green rgb_blue")
ambient_light, albedo_of_a, albedo_of_b = (
    real(" ".join(f"{name}_{c}" for c in CHANNELS)) for name in ("ambient", "albedo_a", "albedo_b")
)


def light_position(number: int) -> Vector:
    """Return the position symbols of a light."""
    return vector(f"light_{number}")


def light_color(number: int) -> Vector:
    """Return the colour symbols of a light."""
    return real(" ".join(f"light_{number}_{c}" for c in CHANNELS))


def occlusion(number: int) -> Symbol:
    """Return the symbol that is 1 where another body stands before a light, else 0."""
    return real(f"occluded_{number}")


@evaluated
def instance(
    program: Program, suffix: str | int, kept: Collection[Symbol] = (), given: Mapping[Symbol, Expr] | None = None
) -> Program:
    """Return the program with its own names suffixed, except those in `kept`, and inputs replaced by `given`."""
    own = {s: Symbol(f"{s.name}_{suffix}", real=True) for s, _ in program.definitions if s not in kept}
    changed = {**own, **(given or {})}
    inputs = {t: None for s in program.inputs for t in sorted(changed.get(s, s).free_symbols, key=str)}
    return Program(
        f"{program.name}_{suffix}",
        tuple(inputs),
        tuple((own.get(s, s), e.xreplace(changed)) for s, e in program.definitions),
        tuple(own.get(s, s) for s in program.outputs),
    )


def _program(name, *definitions):
    defined = {s for s, _ in definitions}
    inputs = {t: None for _, e in definitions for t in sorted(e.free_symbols, key=str) if t not in defined}
    return Program(name, tuple(inputs), definitions, tuple(s for s, _ in definitions))


def _by_surface(on_a, on_b, on_floor, otherwise=0):
    surface = camera.surface
    return Piecewise((on_a, Eq(surface, 1)), (on_b, Eq(surface, 2)), (on_floor, Eq(surface, 3)), (otherwise, True))


def _places(gradient_program):
    """Return the programs for the visible point and its shading normal, on whichever surface it is."""
    seen = chain("seen", camera.image_extent, camera.image_point, camera.visible_surface, camera.angles_on_a)
    kept = {s for s, _ in seen.definitions}
    on_a = instance(camera.point_on_a, "on_a")
    bumped_on_a = instance(bumped_normal, "on_a")
    on_b = instance(camera.normal_of_b, "on_b", kept)
    on_floor = instance(camera.normal_of_floor, "on_floor")

    def on(symbol, surface):
        return Symbol(f"{symbol.name}_{surface}", real=True)

    select = _program(
        "select",
        *((p, _by_surface(*(on(p, s) for s in ("on_a", "on_b", "on_floor")))) for p in point),
        *(
            (b, _by_surface(on(b, "on_a"), on(n, "on_b"), on(b, "on_floor")))
            for b, n in zip(bumped, normal, strict=True)
        ),
    )
    return [seen, on_a, chart, gradient_program, bumped_on_a, on_b, on_floor, select]


def _shadows(number):
    """Return the programs for one light's occlusion by another body."""
    position = dict(zip(light, light_position(number), strict=True))
    origin = {**dict.fromkeys(shadow.center, 0 * radius), shadow.body_radius: radius}
    ball = {**dict(zip(shadow.center, ball_center, strict=True)), shadow.body_radius: camera.ball_radius}
    by_a = instance(shadow.shadow, f"by_a_{number}", given=position | origin)
    by_b = instance(shadow.shadow, f"by_b_{number}", given=position | ball)
    a, b = by_a.outputs[0], where(ball_on > 0, by_b.outputs[0], 0)
    return [by_a, by_b, _program(f"occlusion_{number}", (occlusion(number), _by_surface(b, a, Max(a, b))))]


def _light(number, model, before):
    """Return the programs for one light's share of the colour, and the symbols of the colour after it."""
    position = dict(zip(light, light_position(number), strict=True))
    base = instance(shading.LIGHT_MODELS[model].program, number, given=position)
    own = {s: Symbol(f"{s.name}_{number}", real=True) for s in (mu, shading.specular_base, specular)}
    power = instance(shading.highlight, number, given=own)
    colors = dict(zip(shading.light_colors, light_color(number), strict=True))
    term = instance(shading.light_term, number, given=own | colors | dict(zip(shading.colors, before, strict=True)))
    after = real(" ".join(f"{c}_after_{number}" for c in CHANNELS))
    lines = ((s, where(occlusion(number) > 0, b, lit)) for s, b, lit in zip(after, before, term.outputs, strict=True))
    return [base, power, term, _program(f"after_{number}", *lines)], after


@evaluated
def pixel(
    field: HeightField, model: str = "blinn", lights: int = 2, gradient_program: Program | None = None
) -> Program:
    """Return the program of a whole pixel.

    field: a HeightField. model: one of LIGHT_MODELS. lights: how many. gradient_program: (u, v, …) → h_u, h_v; default,
    the exact gradient. Outputs: surface, occluded_0 …, dark_square, rgb.
    """
    parts = _places(gradient_program or gradient(field))
    parts += [
        shadow.checker,
        _program("dark_square", (dark_square, _by_surface(0, 0, shadow.dark))),
        shading.floor_albedo.at({shading.floor_dark: dark_square}),
        camera.view_length,
        camera.view_direction,
    ]
    floor = (shading.floor_red, shading.floor_red, shading.floor_blue)
    reflected = zip(shading.albedos, albedo_of_a, albedo_of_b, floor, strict=True)
    parts.append(_program("albedo", *((s, _by_surface(*three)) for s, *three in reflected)))
    start = real(" ".join(f"{c}_before" for c in CHANNELS))
    ambient = shading.ambient_term[shading.color]
    lines = ((s, ambient.xreplace({shading.ambient: a})) for s, a in zip(start, ambient_light, strict=True))
    parts.append(_program("ambient", *lines))
    color = start
    for number in range(lights):
        programs, color = _light(number, model, color)
        parts += [*_shadows(number), *programs]
    clip = [shading.clip[shading.clipped].xreplace({shading.color: c}) for c in color]
    parts.append(_program("rgb", *((s, _by_surface(c, c, c)) for s, c in zip(rgb, clip, strict=True))))
    outputs = (camera.surface, *(occlusion(n) for n in range(lights)), dark_square, *rgb)
    return chain(f"pixel_{field.name}_{model}", *parts, outputs=outputs)
