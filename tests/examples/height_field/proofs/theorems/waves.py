"""Waves climb in one direction alone."""

from proofs.formulas import height_fields
from proofs.theorems.language import *

_waves = HEIGHT_FIELDS["waves"]
_lines = chain("waves", height_fields.height(_waves), height_fields.gradient(_waves))
_direction = Claim("direction", equation(k_v * h_u, k_u * h_v), lines=_lines)
_slope = Claim("slope", equation(h_u**2 + h_v**2, pi**2 * (k_u**2 + k_v**2) * (1 - h**2)), lines=_lines)

theorem = Theorem(
    "waves_climb_one_way",
    "Waves climb one way",
    r"For waves, $k_v h_u = k_u h_v$, and $h_u^2 + h_v^2 = \pi^2 (k_u^2 + k_v^2)(1 - h^2)$.",
    claims=(_direction, _slope),
    steps={"differentiate": "the chain rule", "square and add": r"$\cos^2 = 1 - \sin^2$"},
    mutants=(
        variant("across the waves", _direction, equation(k_u * h_u, k_v * h_v)),
        variant("without π", _slope, equation(h_u**2 + h_v**2, (k_u**2 + k_v**2) * (1 - h**2))),
    ),
)
