"""The shadow test, and the floor's checker."""

from sympy import And, Ne, floor

from proofs.engine.program import Program
from proofs.engine.vectors import cross, dot, real, squared, vectors, where
from proofs.formulas.symbols import light, point

center, segment, offset = vectors("center segment offset")
body_radius, segment_squared, toward_center, shadow_discriminant, occluded = real(
    "body_radius segment_squared toward_center shadow_discriminant occluded"
)
square, dark = real("square dark")
_x, _y, _z = point

shadow = Program(
    "shadow",
    (point, light, center, body_radius),
    {
        segment: light - point,
        offset: center - point,
        segment_squared: squared(segment),
        toward_center: dot(segment, offset),
        shadow_discriminant: segment_squared * body_radius**2 - squared(cross(segment, offset)),
        occluded: where(And(shadow_discriminant >= 0, toward_center > 0, toward_center < segment_squared), 1, 0),
    },
)
"""The test for a sphere between a point P and a light L: |P + s (L − P) − C| = r for some s in (0, 1).

Both ends lie outside the sphere, so the quadratic in s is positive at 0 and 1 and has a root between them exactly if
its discriminant is not negative and its vertex lies between them. The discriminant is written by Lagrange's identity.
Domain: P and L outside the sphere."""

checker = Program(
    "checker",
    (_x, _y),
    {
        square: floor(_x) + floor(_y),
        dark: where(And(Ne(square, 2 * floor(square / 2)), Ne(_x, floor(_x)), Ne(_y, floor(_y))), 1, 0),
    },
)
"""The test for a dark floor square: sin πx · sin πy < 0, by the parity of ⌊x⌋ + ⌊y⌋. A grid line is light."""
