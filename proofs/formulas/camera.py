"""The camera: image points, the ray through one, and its hits with sphere A, sphere B and the floor.

The eye E = (0, 0, e) looks down; the image plane is the floor plane z = 0. The ray through the image point (x, y)
is P(t) = (t x, t y, e (1 − t)): the eye at t = 0, the floor at t = 1. A hit needs t > 0.
"""

from sympy import And, Max, Piecewise, Rational, oo, sqrt, symbols

from proofs.engine.program import Program, chain
from proofs.engine.vectors import Vector, cross, real, squared, vectors, where
from proofs.formulas.symbols import (
    ANGLES,
    ball_center,
    ball_on,
    ball_radius,
    bumped,
    column,
    cos_phi,
    cos_theta,
    eye,
    floor_on,
    half,
    height,
    normal,
    point,
    radius,
    rho,
    rho_silhouette,
    row,
    sin_phi,
    sin_theta,
    view,
    width,
    x,
    y,
)

POLE = Rational(1, 10**150)  # below this ρ/e a point is the pole itself

t_a, t_b, t_floor = symbols("t_a t_b t_floor", extended_real=True)  # infinity: no hit
surface, tangent_squared = real("surface tangent_squared")
discriminant_a, root_a, rho_raw = real("discriminant_a root_a rho_raw")
toward_b, discriminant_b, root_b = real("toward_b discriminant_b root_b")
distance, view_scale, rho_inverse, hit_scale = real("distance view_scale rho_inverse hit_scale")

ray_direction = Vector((x, y, -eye))
_cx, _cy, _cz = ball_center
_from_center = (-_cx, -_cy, distance)  # the eye less B's centre
_tangent = {tangent_squared: (eye - radius) * (eye + radius)}  # squared length of the tangents from E to A

image_extent = Program("image_extent", (eye, radius), _tangent | {half: 5 * eye * radius / (4 * sqrt(tangent_squared))})
"""half = 5/4 · e R/√(e² − R²): the image plane's vertical half-extent, 1.25 silhouette radii. Source: seed, Cell 1."""

image_point = Program(
    "image_point",
    (column, row, width, height, half),
    {x: half * (2 * column + 1 - width) / height, y: half * ((height - 1 - 2 * row) / height - Rational(3, 20))},
    (x, y),
)
"""The centre of a pixel. Pixels are square: the horizontal half-extent is half · width/height. The view is centred
3/20 half below the axis. Domain: 0 ≤ column < width, 0 ≤ row < height. Source: seed, Cell 1."""

image_radius = Program(
    "image_radius", (x, y, eye), {rho_raw: sqrt(x**2 + y**2), rho: where(rho_raw >= POLE * eye, rho_raw, 0)}
)
"""ρ = √(x² + y²), and 0 at the pole (ρ below 10⁻¹⁵⁰ of the eye's height)."""

silhouette_of_a = Program(
    "silhouette_of_a", (eye, radius), _tangent | {rho_silhouette: eye * radius / sqrt(tangent_squared)}
)
"""ρ_s = e R/√(e² − R²): the image radius of sphere A's silhouette."""

hit_of_a = chain(
    "hit_of_a",
    image_radius,
    silhouette_of_a,
    {
        discriminant_a: tangent_squared * (rho_silhouette - rho) * (rho_silhouette + rho),
        root_a: sqrt(Max(0, discriminant_a)),
        t_a: where(discriminant_a >= 0, tangent_squared / (eye**2 + root_a), oo),
    },
)
"""The near hit with sphere A: t = (e² − R²)/(e² + √d), d = (e² − R²)(ρ_s² − ρ²), and ∞ where d < 0.

The quadratic |P(t)|² = R² has the roots (e² ∓ √d)/(ρ² + e²); the near one is written with the conjugate, which
cancels nothing. Domain: e > R > 0. Theorem: hit_of_a."""

hit_of_b = Program(
    "hit_of_b",
    (x, y, eye, ball_center, ball_radius, ball_on),
    {
        distance: eye - _cz,
        toward_b: x * _cx + y * _cy + eye * distance,
        discriminant_b: squared(ray_direction) * ball_radius**2 - squared(cross(ray_direction, _from_center)),
        root_b: sqrt(Max(0, discriminant_b)),
        t_b: where(
            And(discriminant_b >= 0, toward_b > 0, ball_on > 0),
            (_cx**2 + _cy**2 + (distance - ball_radius) * (distance + ball_radius)) / (toward_b + root_b),
            oo,
        ),
    },
)
"""The near hit with sphere B: t = c/(b + √d), where b = −D·(E − C), c = |E − C|² − R₂², D = (x, y, −e) and
d = b² − |D|² c = |D|² R₂² − |D × (E − C)|² (Lagrange's identity); ∞ where d < 0 or b ≤ 0 (behind the eye), or
where there is no B. Domain: E outside B. Theorem: hit_of_b. The seed has c = |C|² − R₂²: refuted, F1."""

_nearest = Program(
    "nearest",
    (t_a, t_b, floor_on),
    {
        t_floor: where(floor_on > 0, 1, oo),
        surface: Piecewise(
            (1, And(t_a < oo, t_a <= t_b, t_a <= t_floor)),
            (2, And(t_b < oo, t_b <= t_floor)),
            (3, t_floor < oo),
            (0, True),
        ),
    },
)

visible_surface = chain("visible_surface", hit_of_a, hit_of_b, _nearest)
"""The surface that a ray meets first: 0 none, 1 sphere A, 2 sphere B, 3 floor."""

angles_on_a = chain(
    "angles_on_a",
    hit_of_a,
    {
        rho_inverse: where(rho > 0, 1 / rho, 0),
        hit_scale: 1 / (radius * (eye**2 + root_a)),
        cos_theta: x * rho_inverse,
        sin_theta: y * rho_inverse,
        sin_phi: tangent_squared * rho * hit_scale,
        cos_phi: eye * (root_a + radius**2) * hit_scale,
    },
    outputs=ANGLES,
)
"""The angles of the visible point of A from ρ and t alone: sin φ = tρ/R, cos φ = e(1 − t)/R, θ's from x/ρ, y/ρ.

No term cancels, so they keep their digits up to the pole, where both of θ's are set to 0; quotients with one divisor
share its reciprocal. Theorem: stable_frame."""

point_on_a = Program(
    "point_on_a", (ANGLES, radius), {point: radius * Vector((sin_phi * cos_theta, sin_phi * sin_theta, cos_phi))}
)
"""P = R N, N = (sin φ cos θ, sin φ sin θ, cos φ)."""

point_on_b = chain("point_on_b", hit_of_b, {point: (t_b * x, t_b * y, eye * (1 - t_b))})
"""P = P(t_B)."""

moment, radius_vector = vectors("moment radius_vector")
ray_length_squared, radius_length = real("ray_length_squared radius_length")

normal_of_b = chain(
    "normal_of_b",
    hit_of_b,
    {
        moment: cross(ray_direction, _from_center),
        ray_length_squared: squared(ray_direction),
        radius_vector: (cross(moment, ray_direction) - root_b * ray_direction) / ray_length_squared,
        radius_length: sqrt(squared(radius_vector)),
        normal: radius_vector / radius_length,
        point: ball_center + ball_radius * normal,
    },
).keep(*point, *normal)
"""P − C = ((D × (E − C)) × D − √d D)/|D|²: what of E − C is perpendicular to the ray, and from there along it to the
near root. Nothing cancels, however small B is beside its distance from the eye; P(t) − C would. N = (P − C)/|P − C|,
whose length is R₂ but for rounding: the rounded one makes N a unit vector. P = C + R₂ N. Theorem: hit_of_b."""

point_on_floor = Program("point_on_floor", (x, y), {point: (x, y, 0 * x)})
"""P = (x, y, 0): the image plane is the floor."""

normal_of_floor = chain("normal_of_floor", point_on_floor, {bumped: (0 * x, 0 * x, 0 * x + 1)}, outputs=(point, bumped))
"""N' = N = (0, 0, 1)."""

view_length = Program("view_length", (x, y, eye), {view_scale: 1 / sqrt(x**2 + y**2 + eye**2)})
"""1/|E − (x, y, 0)|."""

view_direction = Program("view_direction", (x, y, eye, view_scale), {view: Vector((-x, -y, eye)) * view_scale})
"""v̂ = (E − P)/|E − P| = (−x, −y, e)/√(x² + y² + e²): the same for every point of a ray. Domain: t > 0."""

parallel_radius = Program(
    "parallel_radius", (sin_phi, cos_phi, eye, radius), {rho: eye * radius * sin_phi / (eye - radius * cos_phi)}
)
"""ρ = e R sin φ/(e − R cos φ): the image radius of the parallel φ of sphere A. It is visible where cos φ > R/e.
Theorems: kink_loci, visible_iff."""
