"""The image's derivative with respect to β in closed form: one light's share of a channel, and the clip.

Domain: off μ = 0, off the highlight's clamp (C¹ there for p > 1), and off the final clip's two ends.
"""

from sympy import Pow

from proofs.engine.program import Program
from proofs.engine.vectors import dot, real, where
from proofs.formulas.bump import bumped_by_beta
from proofs.formulas.shading import albedos, clipped, color, halfway, halfway_length, kd, ks, light_colors
from proofs.formulas.symbols import bumped, mu, shininess, specular_base, towards, view

mu_by_beta, base_by_beta, diffuse_by_beta, shine_by_beta, term_by_beta = real(
    "mu_by_beta base_by_beta diffuse_by_beta shine_by_beta term_by_beta"
)

mu_derivative = Program("mu_derivative", (towards, bumped_by_beta), {mu_by_beta: dot(bumped_by_beta, towards)})
"""∂μ/∂β = ∂N'/∂β · ω."""

base_derivatives = {
    "blinn": Program(
        "blinn_base_derivative",
        (halfway, halfway_length, bumped_by_beta),
        {base_by_beta: dot(bumped_by_beta, halfway) / halfway_length},
    ),
    "phong": Program(
        "phong_base_derivative",
        (view, bumped, bumped_by_beta, mu, mu_by_beta),
        {base_by_beta: 2 * (mu_by_beta * dot(bumped, view) + mu * dot(bumped_by_beta, view))},
    ),
}
"""The base's derivative where it is positive: ∂N'/∂β · H/|H|; 2 (∂μ/∂β N'·v̂ + μ ∂N'/∂β · v̂)."""

term_derivative = Program(
    "term_derivative",
    (mu, mu_by_beta, specular_base, base_by_beta, shininess, kd, ks, albedos[0], light_colors[0]),
    {
        diffuse_by_beta: where(mu > 0, kd * mu_by_beta, 0),
        shine_by_beta: where(specular_base > 0, ks * shininess * Pow(specular_base, shininess - 1) * base_by_beta, 0),
        term_by_beta: light_colors[0] * (albedos[0] * diffuse_by_beta + shine_by_beta),
    },
)
"""A light's share of a channel: colour · (albedo · k_d ∂μ/∂β [μ > 0] + k_s p base^(p−1) ∂base/∂β [base > 0])."""

clip_derivative = Program(
    "clip_derivative", (color, term_by_beta), {clipped: where((color > 0) & (color < 1), term_by_beta, 0)}
)
"""The clip keeps the derivative where 0 < channel < 1, and makes it 0 outside."""
