"""The bump: the tangent vector g, the perturbed normal N' and its derivative with respect to the amplitude β."""

from sympy import sqrt

from proofs.engine.program import Program, chain
from proofs.formulas.symbols import beta, bumped, dot, h_u, h_v, normal, real, vector
from proofs.formulas.tangent_frame import e_phi, e_theta, tangent_frame, unit_normal

g, m = vector("g"), vector("m")
m_length, m_scale = real("m_length m_scale")
bumped_by_beta = vector("bumped_by_beta")

perturbed = Program(
    "perturbed",
    (*normal, *g, beta),
    (
        *((m_i, n_i + beta * g_i) for m_i, n_i, g_i in zip(m, normal, g, strict=True)),
        (m_length, sqrt(dot(m, m))),
        (m_scale, 1 / m_length),
        *((b_i, m_i * m_scale) for b_i, m_i in zip(bumped, m, strict=True)),
    ),
    bumped,
)
"""N' = M/|M|, M = N + βg. Domain: g ⟂ N, so that |M| ≥ 1; any β."""

bumped_normal = chain(
    "bumped_normal",
    unit_normal,
    tangent_frame,
    Program(
        "tangent_vector",
        (*e_theta, *e_phi, h_u, h_v),
        tuple((g_i, h_u * t_i + h_v * p_i) for g_i, t_i, p_i in zip(g, e_theta, e_phi, strict=True)),
        g,
    ),
    perturbed,
)
"""N' from the angles, the gradient and β: g = h_u e_θ + h_v e_φ. At the pole g = 0. Source: seed, §3."""

normal_by_beta = chain(
    "normal_by_beta",
    perturbed,
    Program(
        "projection",
        (*g, *bumped, m_length),
        tuple(
            (d, (g_i - b_i * dot(bumped, g)) / m_length) for d, g_i, b_i in zip(bumped_by_beta, g, bumped, strict=True)
        ),
        bumped_by_beta,
    ),
)
"""∂N'/∂β = (I − N'N'ᵀ) g/|M|. Theorem: normal_by_beta."""
