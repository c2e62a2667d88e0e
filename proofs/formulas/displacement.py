"""The surface that the bump pretends to be: P + βhN on the unit sphere, and its normal; and Blinn's, also of radius R.

The chapter's own N' is none of these: it has the opposite sign, no metric factor 1/sin φ and no chart scale (F18).
"""

from sympy import pi

from proofs.engine.program import Program, chain
from proofs.engine.vectors import real, vector, where
from proofs.formulas.bump import bumped_normal
from proofs.formulas.symbols import beta, h, h_u, h_v, normal, radius, sin_phi
from proofs.formulas.tangent_frame import e_phi, e_theta, tangent_frame, unit_normal

h_theta, h_phi, lift = real("h_theta h_phi lift")
displaced = vector("displaced")

_angular_slopes = Program("angular_slopes", (h_u, h_v), {h_theta: h_u / 2 / pi, h_phi: h_v / pi}, (h_theta, h_phi))
"""h_θ = h_u/2π, h_φ = h_v/π: the chart's scale."""


def _normal(name, height_of_n):
    lines = {lift: height_of_n, displaced: lift * normal - beta * (h_theta / sin_phi * e_theta + h_phi * e_phi)}
    return chain(name, unit_normal, tangent_frame, _angular_slopes, lines)


displaced_normal = _normal("displaced_normal", 1 + beta * h)
"""(1 + βh) N − β (h_θ/sin φ · e_θ + h_φ e_φ), not normalised: the normal of P + βhN on the unit sphere.
Domain: sin φ > 0, 1 + βh > 0."""

blinn_normal = _normal("blinn_normal", 1 + 0 * beta)
"""N − β (h_θ/sin φ · e_θ + h_φ e_φ): the same to first order in β (Blinn 1978). Domain: sin φ > 0."""

arc, slope_theta, slope_phi = real("arc slope_theta slope_phi")

surface_slopes = Program(
    "surface_slopes",
    (sin_phi, radius, h_u, h_v),
    {
        arc: -pi * radius,
        slope_theta: where(sin_phi > 0, h_u / (2 * arc * sin_phi), 0),
        slope_phi: where(sin_phi > 0, h_v / arc, 0),
    },
    (slope_theta, slope_phi),
)
"""−h_θ/(R sin φ) and −h_φ/R, the slopes of h along the sphere of radius R, turned; 0 at the pole, where h has none."""

surface_normal = chain("surface_normal", surface_slopes, bumped_normal.at({(h_u, h_v): surface_slopes.outputs}))
"""N' = M/|M|, M = N + β (slope_θ e_θ + slope_φ e_φ): Blinn's of the sphere of radius R; at the pole it is N."""
