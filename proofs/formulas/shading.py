"""The models of light, and the colour of a pixel: ambient + Σ over the lights of diffuse and specular, then a clip."""

from dataclasses import dataclass

from sympy import Expr, Max, Min, Pow, sqrt

from proofs.engine.program import Program, chain
from proofs.engine.registry import by_name, check_name
from proofs.engine.vectors import dot, real, squared, vectors, where
from proofs.formulas.symbols import bumped, light, mu, normal, point, shininess, specular, specular_base, towards, view

to_light, halfway = vectors("to_light halfway")
light_distance, light_scale, ungated = real("light_distance light_scale ungated")
halfway_length, halfway_squared, along_halfway = real("halfway_length halfway_squared along_halfway")
distance_squared, along_light, above = real("distance_squared along_light above")

light_direction = Program(
    "light_direction",
    (point, light, bumped),
    {
        to_light: light - point,
        light_distance: sqrt(squared(to_light)),
        light_scale: 1 / light_distance,
        towards: to_light * light_scale,
        mu: dot(bumped, towards),
    },
    (towards, mu),
)
"""ω = (L − P)/|L − P|, μ = N'·ω. Domain: L ≠ P."""

height_of_light = Program("height_of_light", (point, light, normal), {above: dot(normal, light - point)})
"""N·(L − P), positive where a light stands above the surface's own horizon; N of any length."""

halfway_vector = chain("halfway_vector", light_direction, {halfway: towards + view})
"""ω + v̂, not normalised."""

blinn = chain(
    "blinn",
    halfway_vector,
    {
        halfway_length: sqrt(squared(halfway)),
        specular_base: where(halfway_length > 0, Max(0, dot(bumped, halfway) / halfway_length), 0),
    },
    outputs=(mu, specular_base),
)
"""Blinn–Phong: the base of the highlight is max(0, N'·(ω + v̂)/|ω + v̂|), and 0 where ω = −v̂."""

blinn_squared = Program(
    "blinn_squared",
    (point, light, bumped, view),
    {
        to_light: light - point,
        distance_squared: squared(to_light),
        light_distance: sqrt(distance_squared),
        halfway: to_light + light_distance * view,
        halfway_squared: squared(halfway),
        along_light: dot(bumped, to_light),
        along_halfway: Max(0, dot(bumped, halfway)),
        light_scale: where(halfway_squared > 0, 1 / (light_distance * halfway_squared), 0),
        mu: where(halfway_squared > 0, along_light * halfway_squared * light_scale, -dot(bumped, view)),
        specular_base: along_halfway**2 * light_distance * light_scale,
    },
    (mu, specular_base),
)
"""Blinn–Phong's μ and the square of its base, from one root and one division: base^p = (base²)^(p/2), p not odd.

The halfway vector is |L − P| (ω + v̂) = (L − P) + |L − P| v̂; where it vanishes ω = −v̂. Theorem: squared_highlight."""


def _gated(program):
    """Return a program's base where μ > 0, else 0: no highlight where the bumped normal turns away from the light."""
    lines = dict(program.definitions)
    lines |= {ungated: lines.pop(specular_base), specular_base: where(mu > 0, ungated, 0)}
    return Program(program.name.replace("blinn", "blinn_gated"), program.inputs, lines, program.outputs)


phong = chain(
    "phong",
    light_direction,
    {specular_base: Max(0, 2 * mu * dot(bumped, view) - dot(towards, view))},
    outputs=(mu, specular_base),
)
"""Phong: the base is max(0, (2μN' − ω)·v̂)."""

blinn_highlight = Program("blinn_highlight", (bumped, halfway), blinn.definitions[-2:])
phong_highlight = Program("phong_highlight", (bumped, view, towards, mu), phong.definitions[-1:])
squared_highlight = Program(
    "squared_highlight",
    (bumped, halfway, light_distance),
    {symbol: blinn_squared[symbol] for symbol in (halfway_squared, along_halfway, light_scale, specular_base)},
    specular_base,
)
"""The base alone, or its square, of what it is made of: ω + v̂, |L − P| (ω + v̂) and |L − P|, or ω and μ."""


@dataclass(frozen=True)
class LightModel:
    """A model of light: the share of a light at L in the colour at P, seen from the direction v̂.

    name: identifier. program: (P, L, N', v̂) → μ, the cosine that scatters light (0 where it is negative), and the
    base of the highlight. squared: the same for the square of the base, where that is cheaper, or None. Raises
    ValueError where the name is not allowed.
    """

    name: str
    program: Program
    squared: Program | None = None

    def __post_init__(self):
        check_name(self.name)

    def __str__(self):
        return self.name


LIGHT_MODELS: dict[str, LightModel] = by_name((
    LightModel("blinn", blinn, blinn_squared),
    LightModel("phong", phong),
    LightModel("blinn_gated", _gated(blinn), _gated(blinn_squared)),
))  # fmt: skip
"""The models of light. A model is data: add an entry, and its kernels, the scene's, the command line's and the
simulator's choices follow from it."""

highlight = Program("highlight", (specular_base, shininess), {specular: Pow(specular_base, shininess)})
"""The highlight is base^p, p > 0: not gated by the sign of μ, as in the seed."""

color, ka, kd, ks, ambient = real("color ka kd ks ambient")
colors, lit = real("red green blue"), real("lit_red lit_green lit_blue")
albedos, light_colors = real("albedo_red albedo_green albedo_blue"), real("light_red light_green light_blue")
diffuse, shine, clipped = real("diffuse shine clipped")

ambient_term = Program("ambient_term", (ka, ambient), {color: ka * ambient})
"""k_a · ambient, per channel."""

light_term = Program(
    "light_term",
    (colors, light_colors, albedos, kd, ks, mu, specular),
    {
        diffuse: kd * Max(0, mu),
        shine: ks * specular,
        lit: [c + i * (a * diffuse + shine) for c, i, a in zip(colors, light_colors, albedos, strict=True)],
    },
)
"""A light adds colour · (k_d · albedo · max(0, μ) + k_s · base^p) per channel, unless it is occluded."""


def clipped_value(channel: Expr) -> Expr:
    """Return a channel clipped to [0, 1]."""
    return Min(1, Max(0, channel))


clip = Program("clip", color, {clipped: clipped_value(color)})
"""A channel is clipped to [0, 1]."""

floor_dark, floor_tint, floor_base, floor_red, floor_blue = real(
    "floor_dark floor_tint floor_base floor_red floor_blue"
)
floor_albedo = Program(
    "floor_albedo",
    (floor_dark, floor_tint),
    {
        floor_base: where(floor_dark > 0, Pow(20, -1) * 3, Pow(20, -1) * 17),
        floor_red: floor_base * (1 - floor_tint),
        floor_blue: floor_base,
    },
    (floor_red, floor_blue),
)
"""The floor's albedo: 17/20 on light squares, 3/20 on dark ones; red and green are dimmed by the tint."""
