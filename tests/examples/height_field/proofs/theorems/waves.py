"""Waves climb in one direction alone."""

from sympy import pi

from proofs.engine.claim import Claim, equation
from proofs.engine.program import chain
from proofs.engine.theorem import Mutant, Step, Theorem
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient, height
from proofs.formulas.symbols import h, h_u, h_v, k_u, k_v

_lines = chain("waves", height(HEIGHT_FIELDS["waves"]), gradient(HEIGHT_FIELDS["waves"]))
_direction = Claim("direction", (equation(k_v * h_u, k_u * h_v),), lines=_lines)
_slope = Claim("slope", (equation(h_u**2 + h_v**2, pi**2 * (k_u**2 + k_v**2) * (1 - h**2)),), lines=_lines)

theorem = Theorem(
    id="waves_climb_one_way",
    title="Waves climb one way",
    statement=r"For waves, $k_v h_u = k_u h_v$, and $h_u^2 + h_v^2 = \pi^2 (k_u^2 + k_v^2)(1 - h^2)$.",
    claims=(_direction, _slope),
    steps=(Step("differentiate", "the chain rule"), Step("square and add", r"$\cos^2 = 1 - \sin^2$")),
    mutants=(
        Mutant("across the waves", _direction.but(shows=(equation(k_u * h_u, k_v * h_v),))),
        Mutant("without π", _slope.but(shows=(equation(h_u**2 + h_v**2, (k_u**2 + k_v**2) * (1 - h**2)),))),
    ),
)
