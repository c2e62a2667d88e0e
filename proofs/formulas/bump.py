"""The bump: the tangent vector g, the perturbed normal N' and its derivative with respect to the amplitude β."""

from sympy import sqrt

from proofs.engine.program import Program, chain
from proofs.engine.vectors import dot, real, squared, vectors
from proofs.formulas.symbols import beta, bumped, h_u, h_v, normal
from proofs.formulas.tangent_frame import e_phi, e_theta, tangent_frame, unit_normal

g, m, bumped_by_beta = vectors("g m bumped_by_beta")
m_length, m_scale = real("m_length m_scale")

perturbed = Program(
    "perturbed",
    (normal, g, beta),
    {m: normal + beta * g, m_length: sqrt(squared(m)), m_scale: 1 / m_length, bumped: m * m_scale},
)
"""N' = M/|M|, M = N + βg. Domain: g ⟂ N, so that |M| ≥ 1; any β."""

bumped_normal = chain("bumped_normal", unit_normal, tangent_frame, {g: h_u * e_theta + h_v * e_phi}, perturbed)
"""N' from the angles, the gradient and β: g = h_u e_θ + h_v e_φ. At the pole g = 0. Source: seed, §3."""

normal_by_beta = chain("normal_by_beta", perturbed, {bumped_by_beta: (g - bumped * dot(bumped, g)) / m_length})
"""∂N'/∂β = (I − N'N'ᵀ) g/|M|. Theorem: normal_by_beta."""
