"""Real symbols, and vectors of three expressions."""

from collections.abc import Mapping, Sequence
from typing import Any

from sympy import Basic, Expr, Piecewise, Symbol, symbols


class Vector(tuple):
    """A tuple of expressions, added and scaled as vectors are.

    >>> from proofs.theorems.language import Vector, vector
    >>> vector("a") + 2 * Vector((1, 0, 0))
    (a_x + 2, a_y, a_z)
    """

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
        """Return the vector with the rule's symbols replaced."""
        return Vector(a.xreplace(rule) for a in self)

    __rmul__ = __mul__


def real(names: str) -> Any:
    """Return real symbols for a blank-separated string of names.

    >>> from proofs.theorems.language import real
    >>> real("x y")
    (x, y)
    """
    return symbols(names, real=True)


def vector(name: str) -> Vector:
    """Return the three real symbols (name_x, name_y, name_z).

    >>> from proofs.theorems.language import vector
    >>> vector("a")
    (a_x, a_y, a_z)
    """
    return Vector(Symbol(f"{name}_{axis}", real=True) for axis in "xyz")


def vectors(names: str) -> list[Vector]:
    """Return the vectors of a blank-separated string of names.

    >>> from proofs.theorems.language import vectors
    >>> vectors("a b")
    [(a_x, a_y, a_z), (b_x, b_y, b_z)]
    """
    return [vector(name) for name in names.split()]


def dot(a: Sequence[Expr], b: Sequence[Expr]) -> Expr:
    """Return the scalar product of two 3-tuples of expressions.

    >>> from proofs.theorems.language import dot
    >>> dot((1, 2, 3), (1, 0, -1))
    -2
    """
    first, *others = (p * q for p, q in zip(a, b, strict=True))
    return sum(others, first)


def squared(a: Sequence[Expr]) -> Expr:
    """Return the square of the length of a 3-tuple of expressions.

    >>> from proofs.theorems.language import squared, vector
    >>> squared(vector("a"))
    a_x**2 + a_y**2 + a_z**2
    """
    return dot(a, a)


def cross(a: Sequence[Expr], b: Sequence[Expr]) -> Vector:
    """Return the vector product of two 3-tuples of expressions.

    >>> from proofs.theorems.language import cross
    >>> cross((1, 0, 0), (0, 1, 0))
    (0, 0, 1)
    """
    (a_x, a_y, a_z), (b_x, b_y, b_z) = a, b
    return Vector((a_y * b_z - a_z * b_y, a_z * b_x - a_x * b_z, a_x * b_y - a_y * b_x))


def where(condition: Basic, value: Any, otherwise: Any) -> Expr:
    """Return the expression that is one value where a condition holds, and another one elsewhere.

    >>> from proofs.theorems.language import real, where
    >>> where(real("x") > 0, 1, 0)
    Piecewise((1, x > 0), (0, True))
    """
    return Piecewise((value, condition), (otherwise, True))
