"""What float64 loses between the gradient and the colour: the bumped normal, the light's cosine, a share, the clip."""

from proofs.formulas.bump import g, perturbed
from proofs.formulas.certified import COSINE, NORMAL, SHARE
from proofs.formulas.pixel import CHANNELS
from proofs.formulas.shading import (
    albedos,
    clip,
    clipped,
    colors,
    kd,
    ks,
    light_colors,
    light_direction,
    light_term,
    lit,
)
from proofs.theorems.language import *

_UNIT = Pow(2, -53)
_m = normal + beta * g
_to_light = light - point

theorem = Theorem(
    "colour_accuracy",
    "What float64 loses between the gradient and the colour",
    rf"With $\mu = 2^{{-53}}$, as float64 carries them out: each component of $N'$ is within ${NORMAL}\mu$ "
    rf"of that of $(N + \beta g)/|N + \beta g|$; the light's cosine is within ${COSINE}\mu$ of $N' \cdot \omega$; a "
    rf"light's share leaves a channel within ${SHARE}\mu$ of its exact value and $10^{{-30}}$; the clip loses nothing.",
    hypotheses=(
        r"$1 \le |N + \beta g|^2 \le 2^{900}$, and no $\beta g_i$ is longer than that; $|N'_i| \le 1 + 2^{-40}$",
        r"$2^{-40} \le |L - P|^2 \le 2^{900}$; a light, its weights and what it adds to are not negative",
        "each stage is of its own float64 inputs",
    ),
    rounded=(
        Rounded(
            "normal",
            perturbed,
            tuple((component, NORMAL * _UNIT) for component in bumped),
            (squared(_m) >= 1, squared(_m) <= Pow(2, 900), [(beta * component) ** 2 <= squared(_m) for component in g]),
        ),
        Rounded(
            "cosine",
            light_direction,
            {mu: COSINE * _UNIT},
            (
                squared(_to_light) >= Pow(2, -40),
                squared(_to_light) <= Pow(2, 900),
                [Abs(component) <= 1 + Pow(2, -40) for component in bumped],
            ),
        ),
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
        r"$N + \beta g$ is off by $\tfrac94\mu$ of its length": "two roundings a component",
        "its square by 11, its length by 7, the quotient by 12 of them": "three products, two sums, a root, a quotient",
        "the share": "nothing cancels in a sum of what is not negative",
    },
    expected="measured",
)
