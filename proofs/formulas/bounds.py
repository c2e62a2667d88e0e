"""The extent of a sphere, seen from a point above it: the interval between its two tangents in a vertical plane.

Seen from the eye it bounds the sphere's image; seen from a light, its shadow on the floor and on whatever stands in
the shadow's way. A renderer need look for neither outside the interval.
"""

from sympy import sqrt

from proofs.engine.program import Program
from proofs.engine.vectors import real

apex, apex_height, center, center_height, sphere_radius, level = real(
    "apex apex_height center center_height sphere_radius level"
)
across, drop, spread, slope_low, slope_high = real("across drop spread slope_low slope_high")
low, high = real("low high")

tangent_interval = Program(
    "tangent_interval",
    (apex, apex_height, center, center_height, sphere_radius, level),
    {
        across: center - apex,
        drop: apex_height - center_height,
        spread: sphere_radius * sqrt(across**2 + (drop - sphere_radius) * (drop + sphere_radius)),
        slope_low: (across * drop - spread) / ((drop - sphere_radius) * (drop + sphere_radius)),
        slope_high: (across * drop + spread) / ((drop - sphere_radius) * (drop + sphere_radius)),
        low: apex + slope_low * (apex_height - level),
        high: apex + slope_high * (apex_height - level),
    },
    (low, high),
)
"""Where the two tangents from (apex, apex_height) to the circle of radius r about (center, center_height) meet the
height `level`. A tangent x = apex + s (apex_height − z) has |across − s drop| = r √(1 + s²). Every line from the apex
that meets the sphere stays between them below the apex. Domain: drop > r, level < apex_height."""
