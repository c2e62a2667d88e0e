"""The names of the chapter's quantities. All are real; lengths are in units of the world, angles in radians."""

from collections.abc import Mapping, Sequence
from typing import Any

from sympy import Basic, Expr, Piecewise, Symbol, symbols


class Vector(tuple):
    """A tuple of expressions, added and scaled as vectors are."""

    __slots__ = ()

    def __add__(self, other):
        return Vector(a + b for a, b in zip(self, other, strict=True))

    def __sub__(self, other):
        return Vector(a - b for a, b in zip(self, other, strict=True))

    def __neg__(self):
        return Vector(-a for a in self)

    def __mul__(self, scale):
        return Vector(a * scale for a in self)

    def __truediv__(self, scale):
        return Vector(a / scale for a in self)

    def xreplace(self, rule: Mapping[Symbol, Expr]) -> "Vector":
        """Return the vector with what the rule names replaced."""
        return Vector(a.xreplace(rule) for a in self)

    __rmul__ = __mul__


def real(names: str) -> Any:
    """Return real symbols for a blank-separated string of names."""
    return symbols(names, real=True)


def vector(name: str) -> Vector:
    """Return the three real symbols (name_x, name_y, name_z)."""
    return Vector(Symbol(f"{name}_{axis}", real=True) for axis in "xyz")


def vectors(names: str) -> list[Vector]:
    """Return the vectors of a blank-separated string of names."""
    return [vector(name) for name in names.split()]


def dot(a: Sequence[Expr], b: Sequence[Expr]) -> Expr:
    """Return the scalar product of two 3-tuples of expressions."""
    first, *others = (p * q for p, q in zip(a, b, strict=True))
    return sum(others, first)


def squared(a: Sequence[Expr]) -> Expr:
    """Return the square of the length of a 3-tuple of expressions."""
    return dot(a, a)


def cross(a: Sequence[Expr], b: Sequence[Expr]) -> Vector:
    """Return the vector product of two 3-tuples of expressions."""
    (a_x, a_y, a_z), (b_x, b_y, b_z) = a, b
    return Vector((a_y * b_z - a_z * b_y, a_z * b_x - a_x * b_z, a_x * b_y - a_y * b_x))


def where(condition: Basic, value: Any, otherwise: Any) -> Expr:
    """Return the expression that is one value where a condition holds, and another one elsewhere."""
    return Piecewise((value, condition), (otherwise, True))


# Raster: the pixel in `column` (from the left) and `row` (from the top) of `width` × `height` pixels.
column, row, width, height = real("column row width height")
# Image plane: the floor plane z = 0 seen from the eye E = (0, 0, e); half is its vertical half-extent.
x, y, half = real("x y half")
rho, rho_silhouette = real("rho rho_silhouette")

eye, radius, ball_radius = real("eye radius ball_radius")
ball_on, floor_on = real("ball_on floor_on")
ball_center = vector("ball_center")

# Sphere A: the angles of a point, and the chart.
ANGLES = cos_theta, sin_theta, cos_phi, sin_phi = real("cos_theta sin_theta cos_phi sin_phi")
theta, phi = real("theta phi")
u, v = real("u v")

# The height field h(u, v), its wave numbers and its gradient.
k_u, k_v = real("k_u k_v")
h, h_u, h_v = real("h h_u h_v")
beta, epsilon = real("beta epsilon")

# A visible point P, its unit normal N, the bumped normal, the direction to the eye.
point, normal, bumped, view = vectors("point normal bumped view")

# A light: position, and unit direction towards it.
light, towards = vectors("light towards")
mu, specular_base, specular, shininess = real("mu specular_base specular shininess")

TEX_NAMES = {
    eye: "e",
    radius: "R",
    ball_radius: "R_2",
    rho_silhouette: r"\rho_s",
    cos_theta: r"\cos\theta",
    sin_theta: r"\sin\theta",
    cos_phi: r"\cos\varphi",
    sin_phi: r"\sin\varphi",
    phi: r"\varphi",
    epsilon: r"\varepsilon",
    shininess: "p",
} | {
    part: f"{name}_{axis}"
    for components, name in (
        (ball_center, "C"),
        (point, "P"),
        (normal, "N"),
        (bumped, "N'"),
        (view, r"\hat v"),
        (light, "L"),
        (towards, r"\omega"),
    )
    for part, axis in zip(components, "xyz", strict=True)
}
