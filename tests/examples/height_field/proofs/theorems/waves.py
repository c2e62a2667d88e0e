"""Waves climb in one direction alone."""

from sympy import pi

from proofs.engine.claim import Claim, equation
from proofs.engine.theorem import Mutant, Step, Theorem
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.symbols import k_u, k_v

_h, (_h_u, _h_v) = HEIGHT_FIELDS["waves"].expression, HEIGHT_FIELDS["waves"].gradient()
_direction = Claim("direction", (equation(k_v * _h_u, k_u * _h_v),))
_slope = Claim("slope", (equation(_h_u**2 + _h_v**2, pi**2 * (k_u**2 + k_v**2) * (1 - _h**2)),))

theorem = Theorem(
    id="waves_climb_one_way",
    title="Waves climb one way",
    statement=r"For waves, $k_v h_u = k_u h_v$, and $h_u^2 + h_v^2 = \pi^2 (k_u^2 + k_v^2)(1 - h^2)$.",
    claims=(_direction, _slope),
    steps=(Step("differentiate", "the chain rule"), Step("square and add", r"$\cos^2 = 1 - \sin^2$")),
    mutants=(
        Mutant("across the waves", _direction.but(shows=(equation(k_u * _h_u, k_v * _h_v),))),
        Mutant("without π", _slope.but(shows=(equation(_h_u**2 + _h_v**2, (k_u**2 + k_v**2) * (1 - _h**2)),))),
    ),
)
