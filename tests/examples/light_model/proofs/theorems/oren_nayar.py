"""On a smooth surface Oren and Nayar's light is Lambert's."""

from proofs.formulas.shading import light_direction, light_distance, oren_nayar
from proofs.theorems.language import *

roughness = real("roughness")
_at = light_distance > 0, equation(roughness, 0)
_smooth = Claim("smooth", equation(mu, light_direction[mu]), _at, oren_nayar(roughness))

theorem = Theorem(
    "smooth_is_lambert",
    "A smooth surface is Lambert's",
    r"At $\sigma = 0$, Oren and Nayar's $\mu$ is $N'\cdot\omega$.",
    hypotheses=r"$L \ne P$",
    claims=_smooth,
    steps={"$A = 1$ and $B = 0$": r"$\sigma = 0$"},
    mutants=(
        variant("σ = 1/2", _smooth, given=(light_distance > 0, equation(roughness, HALF))),
        variant("N' towards the eye", _smooth, equation(mu, dot(bumped, view))),
    ),
)
