"""The whole pixel as one straight-line program: from (column, row) and the scene to its chamber and its colour.

The same programs that the kernels print, joined: the subject of a theorem about a pixel, and the 50-digit reference.
"""

from collections.abc import Collection, Mapping
from types import MappingProxyType

from sympy import Eq, Max, Piecewise, Symbol

from proofs.engine.program import Program, chain, evaluated
from proofs.engine.vectors import Vector, real, vector, where
from proofs.formulas import camera, shading, shadow
from proofs.formulas.bump import bumped_normal
from proofs.formulas.chart import chart
from proofs.formulas.displacement import surface_normal
from proofs.formulas.height_fields import HeightField, gradient
from proofs.formulas.symbols import ball_center, ball_on, bumped, light, mu, normal, point, radius, specular

CHANNELS = ("red", "green", "blue")


def _channels(before, after=""):
    return real(" ".join(f"{before}{channel}{after}" for channel in CHANNELS))


dark_square = real("dark_square")
rgb, ambient_light, albedo_of_a, albedo_of_b = map(_channels, ("rgb_", "ambient_", "albedo_a_", "albedo_b_"))


def light_position(number: int) -> Vector:
    """Return the position symbols of a light."""
    return vector(f"light_{number}")


def light_color(number: int) -> Vector:
    """Return the colour symbols of a light."""
    return _channels(f"light_{number}_")


def occlusion(number: int) -> Symbol:
    """Return the symbol that is 1 where another body stands before a light, else 0."""
    return real(f"occluded_{number}")


def _suffixed(symbols, suffix):
    return tuple(real(f"{symbol}_{suffix}") for symbol in symbols)


@evaluated
def instance(
    program: Program, suffix: str | int, kept: Collection[Symbol] = (), given: Mapping = MappingProxyType({})
) -> Program:
    """Return the program with its own names suffixed, except those in `kept`, and inputs replaced by `given`."""
    own = tuple(symbol for symbol in dict(program.definitions) if symbol not in kept)
    return program.at({own: _suffixed(own, suffix), **given})


def _by_surface(on_a, on_b, on_floor, otherwise=0):
    surface = camera.surface
    return Piecewise((on_a, Eq(surface, 1)), (on_b, Eq(surface, 2)), (on_floor, Eq(surface, 3)), (otherwise, True))


def _each_by_surface(names, *on_each):
    """Return the lines of names, each by its values on A, on B and on the floor."""
    return {name: _by_surface(*on) for name, *on in zip(names, *on_each, strict=True)}


BUMPS = {"chart": bumped_normal, "surface": surface_normal}

_UPRIGHT = (normal, "on_a"), (normal, "on_b"), (bumped, "on_floor")


def _places(gradient_program, bump):
    """Return the programs for the visible point and its shading normal, on whichever surface it is."""
    seen = chain("seen", camera.image_extent, camera.image_point, camera.visible_surface, camera.angles_on_a)
    return [
        seen,
        instance(camera.point_on_a, "on_a"),
        chart,
        gradient_program,
        instance(BUMPS[bump], "on_a"),
        instance(camera.normal_of_b, "on_b", dict(seen.definitions)),
        instance(camera.normal_of_floor, "on_floor"),
        _each_by_surface(point, *(_suffixed(point, surface) for surface in ("on_a", "on_b", "on_floor")))
        | _each_by_surface(bumped, _suffixed(bumped, "on_a"), _suffixed(normal, "on_b"), _suffixed(bumped, "on_floor")),
    ]


def _shadows(number):
    """Return the programs for one light's occlusion by another body."""
    position = {light: light_position(number)}
    origin = {shadow.center: [0 * radius] * 3, shadow.body_radius: radius}
    ball = {shadow.center: ball_center, shadow.body_radius: camera.ball_radius}
    by_a, by_b = (
        instance(shadow.shadow, f"by_{name}_{number}", given=position | body)
        for name, body in (("a", origin), ("b", ball))
    )
    a, b = by_a.outputs[0], where(ball_on > 0, by_b.outputs[0], 0)
    return [by_a, by_b, {occlusion(number): _by_surface(b, a, Max(a, b))}]


def _light(number, model, before, horizon):
    """Return the programs for one light's share of the colour, and the symbols of the colour after it."""
    base = instance(shading.LIGHT_MODELS[model].program, number, given={light: light_position(number)})
    from_base = (mu, shading.specular_base, specular)
    own = {from_base: _suffixed(from_base, number)}
    power = instance(shading.highlight, number, given=own)
    term = instance(
        shading.light_term, number, given=own | {shading.light_colors: light_color(number), shading.colors: before}
    )
    after = _channels("", f"_after_{number}")
    lit, parts = term.outputs, [base, power, term]
    if horizon:
        parts.append(instance(shading.height_of_light, number, given={light: light_position(number)}))
        lit = [where(parts[-1].outputs[0] > 0, c, b) for b, c in zip(before, lit, strict=True)]
    return [*parts, {s: where(occlusion(number) > 0, b, c) for s, b, c in zip(after, before, lit, strict=True)}], after


@evaluated
def pixel(
    field: HeightField,
    model: str = "blinn",
    lights: int = 2,
    gradient_program: Program | None = None,
    bump: str = "chart",
    horizon: bool = False,
) -> Program:
    """Return the program of a whole pixel.

    field: a HeightField. model: one of LIGHT_MODELS. lights: how many. gradient_program: (u, v, …) → h_u, h_v; default,
    the exact gradient. bump: one of BUMPS. horizon: whether a light from behind the surface itself adds nothing.
    Outputs: surface, occluded_0 …, dark_square, rgb.
    """
    color = _channels("", "_before")
    floor = (shading.floor_red, shading.floor_red, shading.floor_blue)
    parts = [
        *_places(gradient_program or gradient(field), bump),
        shadow.checker,
        {dark_square: _by_surface(0, 0, shadow.dark)},
        shading.floor_albedo.at({shading.floor_dark: dark_square}),
        camera.view_length,
        camera.view_direction,
        _each_by_surface(shading.albedos, albedo_of_a, albedo_of_b, floor),
        {
            s: shading.ambient_term[shading.color].xreplace({shading.ambient: a})
            for s, a in zip(color, ambient_light, strict=True)
        },
    ]
    if horizon:
        parts.append(_each_by_surface(normal, *(_suffixed(n, on) for n, on in _UPRIGHT)))
    for number in range(lights):
        programs, color = _light(number, model, color, horizon)
        parts += [*_shadows(number), *programs]
    clipped = [shading.clipped_value(c) for c in color]
    parts.append(_each_by_surface(rgb, clipped, clipped, clipped))
    outputs = (camera.surface, tuple(map(occlusion, range(lights))), dark_square, rgb)
    return chain(f"pixel_{field.name}_{model}", *parts, outputs=outputs)
