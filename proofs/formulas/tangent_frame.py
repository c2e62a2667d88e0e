"""The tangent frame of sphere A: e_θ along the parallels, e_φ along the meridians.

(e_φ, e_θ, N) is right-handed: e_θ × e_φ = −N (F3).
"""

from sympy import sqrt

from proofs.engine.program import Program
from proofs.engine.vectors import real, vectors
from proofs.formulas.symbols import ANGLES, cos_phi, cos_theta, normal, sin_phi, sin_theta

e_theta, e_phi = vectors("e_theta e_phi")
seed_sin_phi = real("seed_sin_phi")

_nx, _ny, _nz = normal

unit_normal = Program("unit_normal", ANGLES, {normal: (sin_phi * cos_theta, sin_phi * sin_theta, cos_phi)})
"""N = (sin φ cos θ, sin φ sin θ, cos φ)."""

tangent_frame = Program(
    "tangent_frame",
    ANGLES,
    {e_theta: (-sin_theta, cos_theta, 0 * cos_theta), e_phi: (cos_phi * cos_theta, cos_phi * sin_theta, -sin_phi)},
    (e_theta, e_phi),
)
"""The stable form: e_θ = (−sin θ, cos θ, 0) = (∂N/∂θ)/sin φ, e_φ = (cos φ cos θ, cos φ sin θ, −sin φ) = ∂N/∂φ.
Theorem: tangent_frame."""

seed_frame = Program(
    "seed_frame",
    normal,
    {
        seed_sin_phi: sqrt(1 - _nz**2),
        e_theta: (-_ny / seed_sin_phi, _nx / seed_sin_phi, 0 * _nx),
        e_phi: (_nz * _nx / seed_sin_phi, _nz * _ny / seed_sin_phi, -seed_sin_phi),
    },
    (e_theta, e_phi),
)
"""The seed's form, from N: sin φ = √(1 − N_z²) cancels near the pole (F20). Domain: sin φ > 0."""
