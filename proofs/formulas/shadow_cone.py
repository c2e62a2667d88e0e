"""The clearance of a sphere from the cone of light that ends on a ball: where it is positive, there is no shadow."""

from sympy import Piecewise

from proofs.engine.program import Program
from proofs.engine.vectors import dot, real, squared, vectors, where
from proofs.formulas.shadow import body_radius, center
from proofs.formulas.symbols import ball_center, ball_radius, light

from_body, along = vectors("from_body along")
at_light, half_slope, curvature = real("at_light half_slope curvature")
turning, at_ball, at_an_end, at_turning = real("turning at_ball at_an_end at_turning")
clearance, shortest = real("clearance shortest")

shadow_clearance = Program(
    "shadow_clearance",
    (light, center, body_radius, ball_center, ball_radius),
    {
        from_body: light - center,
        along: ball_center - light,
        at_light: squared(from_body) - body_radius**2,
        half_slope: dot(from_body, along) - body_radius * ball_radius,
        curvature: squared(along) - ball_radius**2,
        turning: Piecewise((0, half_slope >= 0), (1, half_slope + curvature <= 0), (-half_slope / curvature, True)),
        at_ball: at_light + 2 * half_slope + curvature,
        at_turning: at_light + turning * (2 * half_slope + turning * curvature),
        at_an_end: where(at_ball < at_light, at_ball, at_light),
        shortest: where(at_turning < at_an_end, at_turning, at_an_end),
        clearance: shortest / (squared(from_body) + squared(along)),
    },
)
"""Positive only if no segment from the light to a point of the ball meets the body: the least value, over the share t
of the way, of |from_body + t · along|² − (body_radius + t · ball_radius)², over a scale of its terms, so that a guard
is a number of roundings. Domain: the light lies outside both. Theorem: shadow_out_of_reach."""
