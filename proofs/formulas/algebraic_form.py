"""The algebraic form of the trigonometric factors: powers of algebraic numbers in place of sines.

With πv = φ and πu = θ/2 + π/2, for whole b and even a,

    cos πbv + i sin πbv = (cos φ + i sin φ)^b,    cos πau + i sin πau = (−cos θ − i sin θ)^(a/2),

and cos φ, sin φ, cos θ, sin θ are algebraic in the image point. A negative power conjugates. Off the pole only.
Theorem: algebraic_gradient.
"""

from proofs.engine.program import Program
from proofs.engine.vectors import real
from proofs.formulas.symbols import ANGLES, cos_phi, cos_theta, sin_phi, sin_theta

MAX_WAVE_NUMBER = 64  # beyond it the power's rounding error, which grows like k, is worse than a reduced argument's

base_of_u = (-cos_theta, -sin_theta)
base_of_v = (cos_phi, sin_phi)

_factors = real_part, imaginary_part, other_real, other_imaginary = real(
    "real_part imaginary_part other_real other_imaginary"
)
_product = real("product_real product_imaginary")

complex_square = Program(
    "complex_square",
    _factors[:2],
    {_product: ((real_part - imaginary_part) * (real_part + imaginary_part), 2 * real_part * imaginary_part)},
)
"""(a + ib)² = (a − b)(a + b) + 2iab."""

complex_product = Program(
    "complex_product",
    _factors,
    {
        _product: (
            real_part * other_real - imaginary_part * other_imaginary,
            real_part * other_imaginary + imaginary_part * other_real,
        )
    },
)
"""(a + ib)(c + id)."""

algebraic_bases = Program(
    "algebraic_bases",
    ANGLES,
    {real("base_u_real base_u_imaginary base_v_real base_v_imaginary"): (*base_of_u, *base_of_v)},
)
"""The numbers that are raised to the powers a/2 and b."""
