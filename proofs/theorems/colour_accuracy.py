"""The error of float64 at B's hit, and between the gradient and the colour: the normal, a cosine, a share, the clip."""

from proofs.formulas import camera
from proofs.formulas.bump import g, perturbed
from proofs.formulas.camera import discriminant_b, toward_b
from proofs.formulas.certified import BLINN, COSINE, NORMAL, PHONG, SHARE, SQUARED
from proofs.formulas.pixel import CHANNELS
from proofs.formulas.shading import (
    albedos,
    blinn_highlight,
    clip,
    clipped,
    colors,
    halfway,
    kd,
    ks,
    light_colors,
    light_direction,
    light_distance,
    light_term,
    lit,
    phong_highlight,
    squared_highlight,
)
from proofs.theorems import hits
from proofs.theorems.language import *

HIT = 112  # how far t_B can be off relative to itself, in units of 2⁻⁵³: no page and no kernel asks
_UNIT = Pow(2, -53)
_m = normal + beta * g
_to_light = light - point
_ray, _to_eye = (squared(Vector((*ends, z))) for ends, z in (((x, y), eye), (ball_center[:2], eye - ball_center[2])))


def _units(*vectors):
    return [Abs(component) <= 1 + Pow(2, -40) for component in vectors]


def _between(least, number, most):
    return number >= Pow(2, least), number <= Pow(2, most)


theorem = Theorem(
    "colour_accuracy",
    "What float64 loses at B's hit, and between the gradient and the colour",
    rf"With $\mu = 2^{{-53}}$, as float64 carries them out: B's hit $t_B$ is within ${HIT}\mu t_B$ of its exact value "
    rf"away from B's outline. Each component of the bumped normal $N'$ is within ${NORMAL}\mu$ "
    rf"of that of $(N + \beta g)/|N + \beta g|$. The light's cosine is within ${COSINE}\mu$ of $N' \cdot \omega$. The "
    rf"base of Blinn's highlight is within ${BLINN}\mu$ of $\max(0, N' \cdot h/|h|)$, $h = \omega + \hat v$; "
    rf"squared, made of $h$ times a distance, it is within ${SQUARED}\mu$ of its square. That of "
    rf"Phong's is within ${PHONG}\mu$ of $\max(0, (2(N' \cdot \omega)N' - \omega) \cdot \hat v)$. A light's share "
    rf"leaves a channel within ${SHARE}\mu$ of its exact value and $10^{{-30}}$. The clip loses nothing.",
    hypotheses=(
        r"of the hit, with $D, b, c, d$ of its theorem: $|D|^2R_2^2 \le 16d$, so that the ray passes $C$ within 97 % "
        r"of $R_2$; $4R_2^2 \le |E - C|^2 \le 2^{40}R_2^2$; $2^{-40} \le |D|^2 \le 2^{100}$, $2^{-20} \le R_2 \le "
        r"2^{50}$; $b > 0$: B is before the eye",
        r"of the normal $1 \le |N + \beta g|^2 \le 2^{900}$, and no $\beta g_i$ is longer than $N + \beta g$",
        r"of a cosine and of the highlights $|N'_i| \le 1 + 2^{-40}$, of Phong also $|\omega_i|$, $|\hat v_i|$ and "
        r"$|N' \cdot \omega|$; of a cosine $2^{-40} \le |L - P|^2 \le 2^{900}$, of Blinn's base $2^{-40} \le |h|^2 "
        r"\le 2^{900}$, squared $2^{-40} \le |h|^2 \le 2^{400}$, a distance from $2^{-20}$ to $2^{200}$",
        r"of a share: light and albedo are at most $2^{20}$; they, the weights and what they add to are not negative",
        "nothing overflows",
        "each stage is of its own float64 inputs",
    ),
    rounded=(
        Rounded(
            "hit",
            camera.hit_of_b,
            {camera.t_b: HIT * _UNIT * hits.hit_of_b.expand(hits.t_b)},
            (
                _between(-40, _ray, 100),
                _between(-20, ball_radius, 50),
                (_to_eye >= 4 * ball_radius**2, _to_eye <= Pow(2, 40) * ball_radius**2),
                camera.hit_of_b.expand(discriminant_b) >= _ray * ball_radius**2 / 16,
                camera.hit_of_b.expand(toward_b) > 0,
                ball_on > 0,
            ),
        ),
        Rounded(
            "normal",
            perturbed,
            tuple((component, NORMAL * _UNIT) for component in bumped),
            (squared(_m) >= 1, squared(_m) <= Pow(2, 900), [(beta * component) ** 2 <= squared(_m) for component in g]),
        ),
        Rounded(
            "cosine", light_direction, {mu: COSINE * _UNIT}, (_between(-40, squared(_to_light), 900), _units(*bumped))
        ),
        Rounded(
            "blinn",
            blinn_highlight,
            {specular_base: BLINN * _UNIT},
            (_between(-40, squared(halfway), 900), _units(*bumped)),
        ),
        Rounded(
            "squared",
            squared_highlight,
            {specular_base: SQUARED * _UNIT},
            (_between(-40, squared(halfway), 400), _between(-20, light_distance, 200), _units(*bumped)),
        ),
        Rounded("phong", phong_highlight, {specular_base: PHONG * _UNIT}, _units(*bumped, *view, *towards, mu)),
        [
            Rounded(
                f"share_{name}",
                light_term,
                {channel: SHARE * _UNIT * light_term.expand(channel) + Pow(10, -30)},
                (
                    nonnegative(before, color, albedo, kd, ks, specular),
                    [weight <= Pow(2, 20) for weight in (color, albedo)],
                ),
            )
            for name, channel, before, color, albedo in zip(CHANNELS, lit, colors, light_colors, albedos, strict=True)
        ],
        Rounded("clip", clip, {clipped: Rational(0)}),
    ),
    steps={
        r"$d$ is off by $31\mu|D|^2R_2|E - C|$, its root by $63\mu|D||E - C|$": (
            r"$|D \times (E - C)| \le |D|R_2$; $\sqrt d \ge |D|R_2/4$"
        ),
        r"$b + \sqrt d$ is off by $82\mu$ of itself, $c$ by $28\mu$": (
            r"$b^2 \ge \tfrac34|D|^2|E - C|^2$ and $c \ge \tfrac34|E - C|^2$"
        ),
        r"$N + \beta g$ is off by $\tfrac94\mu$ of its length": "two roundings a component",
        "its square by 11, its length by 7, the quotient by 12 of them": "three products, two sums, a root, a quotient",
        "the highlight": "sums of bounded products; of Blinn's, 8 of the length, over a length that is off by 7",
        "its square": r"$|N'|^2 \le 3$, twice 8 and 15 roundings of what is at most 3",
        "the share": "nothing cancels in a sum of what is not negative",
    },
)
