"""The bump moves no boundary between chambers; the line where a light grazes N' is none, and does move."""

from proofs.formulas import shading
from proofs.formulas.bump import g, perturbed
from proofs.formulas.camera import surface
from proofs.formulas.finite_difference import central
from proofs.formulas.pixel import (
    albedo_of_a,
    albedo_of_b,
    ambient_light,
    dark_square,
    light_color,
    light_position,
    occlusion,
    pixel,
    rgb,
)
from proofs.formulas.shading import LIGHT_MODELS, ka, kd, ks
from proofs.theorems.language import *
from proofs.theorems.normal import at, tangent

_any_gradient = Program("any_gradient", (h_u, h_v), {}, (h_u, h_v))
LIGHTS = 5  # as many as a scene may have
_chamber = (surface, [occlusion(light) for light in range(LIGHTS)], dark_square)
_bump = (h_u, h_v, beta, bumped)
_unmoved = {
    model: Separation(model, pixel(ridges, model, LIGHTS, _any_gradient), _chamber, _bump) for model in LIGHT_MODELS
}
_by_difference = Separation(
    "central",
    pixel(ridges, lights=1, gradient_program=central(ridges)),
    (surface, occlusion(0), dark_square),
    (k_u, k_v, epsilon, _bump),
)
_recorded = """the pixel's whole program, recorded from the shader: every field and difference, any gradient, every
model of light, both bumps, with a horizon and without, at most five lights; A's reach, the boxes of B and of shadows,
which it is given, are found from the geometry alone"""
theorem = Theorem(
    "bump_moves_no_boundary",
    "The bump moves no boundary",
    {
        r"""Which surface a pixel shows, which lights another body hides from it, and its checker square depend on
        none of $h_u$, $h_v$, $\beta$, $\varepsilon$, $k_u$, $k_v$: $N'$ enters the shading alone.""": (
            *_unmoved.values(),
            _by_difference,
            coq("bump_moves_no_boundary__program 75532b6bd884e6fc"),
        )
    },
    hypotheses=_recorded,
    steps={
        """no input of the bump reaches the chamber code, by any line of the program""": """Coq computes this on the
        pixel's program as the renderer's shader itself records it, and proves that it then holds on every machine: of
        real numbers, of float64, or of both with bounds""",
        "write the pixel as a straight-line program": "the lines are those that the kernels print",
        "the names that the chamber reaches are closed under “is used by a line of”": "reading each line once",
        r"none of them is $h_u$, $h_v$, $\beta$, $\varepsilon$, $k_u$, $k_v$ or $N'$": "look",
    },
    mutants=(
        variant("nor does it move the line N'·ω = 0 (F17)", _unmoved["blinn"], outputs=real("mu_0")),
        variant("nor the colour", _unmoved["phong"], outputs=rgb[:1]),
        variant("nor that of a difference", _by_difference, outputs=rgb[:1]),
    ),
)

_colors = [light_color(number) for number in range(LIGHTS)]
_albedos = [albedo_of_a, albedo_of_b, shading.floor_tint]
_shading = (ka, kd, ks, shininess, ambient_light, _albedos, _colors, k_u, k_v, _bump)
_shaded = {model: Separation(model, pixel(ridges, model, LIGHTS), _chamber, _shading) for model in LIGHT_MODELS}

slopes_theorem = Theorem(
    "edges_add_nothing",
    "These numbers move no edge of a chamber",
    {
        r"""Which surface a pixel shows, which lights another body hides from it, and its checker square depend on none
        of $\beta$, $k_u$, $k_v$, $h_u$, $h_v$, $k_a$, $k_d$, $k_s$, $p$, the albedos, the tint, the ambient light and
        the lights' colours: the edges of chambers stay where they are, at speed 0.""": (
            *_shaded.values(),
            coq("edges_add_nothing__program c4e50caac752b99c"),
        )
    },
    hypotheses=(_recorded, "a crease is no edge of a chamber: $k_u$ and $k_v$ move it, and the colour jumps there"),
    steps={
        "none of these numbers reaches the chamber code, by any line of the program": """Coq computes this on the
        pixel's program as the renderer's shader itself records it""",
        "write the pixel as a straight-line program": "the lines are those that the kernels print",
        "the names that the chamber reaches are closed under “is used by a line of”": "reading each line once",
        "none of them is one of these numbers": "look",
    },
    mutants=(
        variant("by the eye's height", _shaded["blinn"], avoid=eye),
        variant("by a light's place", _shaded["phong"], avoid=light_position(0)),
        variant("nor does β move N'·ω = 0, where the slope jumps", _shaded["blinn"], outputs=real("mu_0")),
    ),
)

_in_light = Claim(
    "in_light",
    dot(bumped, towards) > 0,
    (tangent, dot(normal, towards) > 0, equation(squared(towards), 1)),
    perturbed,
    squares=beta * g,
)

attached_shadow = Theorem(
    "attached_shadow",
    "The bump moves no shadow",
    r"Where $N\cdot\omega > 0$, also $N'\cdot\omega > 0$.",
    claims=_in_light,
    refuted_at={**at("3/4"), towards: ("-12/13", 0, "5/13")},
    steps={r"$N' = (3, 0, 4)/5$, $N'\cdot\omega = -16/65$": (r"$\beta g = (3/4, 0, 0)$", "unit_length")},
    mutants=(
        variant("true at β = 0", _in_light, given=(_in_light.given, zero(beta))),
        variant("true where β g·ω ≥ 0", _in_light, given=(_in_light.given, beta * dot(g, towards) >= 0)),
    ),
)
