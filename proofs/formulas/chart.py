"""The chart of sphere A: azimuth θ ∈ (−π, π], polar angle φ ∈ [0, π], u = (θ + π)/2π ∈ [0, 1), v = φ/π ∈ [0, 1]."""

from sympy import acos, atan2, pi

from proofs.engine.half_turns import atan2pi, cospi, sinpi
from proofs.engine.program import Program
from proofs.engine.vectors import real, where
from proofs.formulas.symbols import ANGLES, cos_phi, cos_theta, normal, phi, sin_phi, sin_theta, u, v

u_closed, theta = real("u_closed theta")

chart = Program(
    "chart",
    ANGLES,
    {
        u_closed: (1 + atan2pi(sin_theta, cos_theta)) / 2,
        u: where(u_closed < 1, u_closed, 0),
        v: atan2pi(sin_phi, cos_phi),
    },
    (u, v),
)
"""u = (1 + θ/π)/2 reduced to [0, 1) (θ = π gives 1, which is 0), v = φ/π, both by atan2. Theorem: chart."""

chart_inverse = Program("chart_inverse", (u, v), {ANGLES: (-cospi(2 * u), -sinpi(2 * u), cospi(v), sinpi(v))})
"""The angles from the chart: cos θ = −cos 2πu, sin θ = −sin 2πu, φ = πv. Domain: 0 ≤ v ≤ 1, any u. Theorem:
chart_inverse."""

chart_radians = Program("chart_radians", (u, v), {theta: pi * (2 * u - 1), phi: pi * v}, (theta, phi))
"""The angles themselves, θ = 2πu − π and φ = πv. Theorem: chart."""

seed_chart = Program(
    "seed_chart", normal, {u: (atan2(normal[1], normal[0]) + pi) / (2 * pi), v: acos(normal[2]) / pi}, (u, v)
)
"""The seed's chart, from N: v by acos loses digits at the pole, and u = 1 is not reduced (F20)."""
