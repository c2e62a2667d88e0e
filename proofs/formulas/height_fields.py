"""The height fields h(u, v). A field is data: add an entry here, and its gradient, its kernels, the scene's and the
command line's choices and the book's tables follow from it.
"""

from dataclasses import dataclass

from sympy import Abs, Expr, diff, sqrt

from proofs.engine.program import Program
from proofs.formulas.half_turns import cospi, sinpi
from proofs.formulas.symbols import h, h_u, h_v, k_u, k_v, real, u, v

sin_u, cos_u, sin_v, cos_v = real("sin_u cos_u sin_v cos_v")


@dataclass(frozen=True)
class HeightField:
    """One height field.

    name: identifier. expression: h in u, v, k_u, k_v. creases: the factors sinpi(w), w linear in u and v, whose
    zeros are the field's creases. wave_numbers: (a, b) if h depends on u and v through the sine and cosine of
    πa u and πb v alone (0 where it does not depend on that coordinate): the algebraic form; else None.
    """

    name: str
    expression: Expr
    creases: tuple[Expr, ...] = ()
    wave_numbers: tuple[Expr, Expr] | None = None

    def gradient(self) -> tuple[Expr, Expr]:
        """Return (∂h/∂u, ∂h/∂v) by differentiation; valid off the creases, with sign 0 = 0 on them."""
        return tuple(diff(self.expression, coordinate) for coordinate in (u, v))


_product = sinpi(k_u * u) * sinpi(k_v * v)

HEIGHT_FIELDS = {
    field.name: field
    for field in (
        HeightField("sine", _product, wave_numbers=(k_u, k_v)),
        HeightField("ridges", Abs(_product), (sinpi(k_u * u), sinpi(k_v * v)), (k_u, k_v)),
        HeightField("rings", sinpi(2 * k_v * v), wave_numbers=(0 * k_u, 2 * k_v)),
    )
}
"""sine: sin(πk_u u) sin(πk_v v). ridges: its absolute value, creased along u = m/k_u and v = m/k_v.
rings: sin(2πk_v v). Domain: u ∈ [0, 1), v ∈ [0, 1], real k_u and k_v. Source: seed, §2."""


def _named_factors(field):
    """Return {trigonometric factor: its name} for a field with an algebraic form."""
    a, b = field.wave_numbers
    names = {sinpi(b * v): sin_v, cospi(b * v): cos_v}
    if a != 0:
        names |= {sinpi(a * u): sin_u, cospi(a * u): cos_u}
    return names


def height(field: HeightField) -> Program:
    """Return the program (u, v, k_u, k_v) → h."""
    return Program(f"height_{field.name}", (u, v, k_u, k_v), ((h, field.expression),))


def factors(field: HeightField) -> Program:
    """Return the program (u, v, k_u, k_v) → the field's trigonometric factors, by name."""
    lines = tuple((name, factor) for factor, name in sorted(_named_factors(field).items(), key=lambda p: str(p[1])))
    return Program(f"factors_{field.name}", (u, v, k_u, k_v), lines, tuple(name for name, _ in lines))


def gradient_from_factors(field: HeightField) -> Program:
    """Return the program (factors, k_u, k_v) → h_u, h_v: the derivative with its factors named."""
    names = _named_factors(field)
    slopes = tuple(derivative.subs(names) for derivative in field.gradient())
    inputs = (sin_u, cos_u, sin_v, cos_v, k_u, k_v)
    return Program(f"gradient_from_factors_{field.name}", inputs, (((h_u, h_v), slopes),))


def gradient(field: HeightField) -> Program:
    """Return the program (u, v, k_u, k_v) → h_u, h_v: the general exact gradient, any real k_u and k_v."""
    if field.wave_numbers is None:
        return Program(f"gradient_{field.name}", (u, v, k_u, k_v), (((h_u, h_v), field.gradient()),))
    named, tail = factors(field), gradient_from_factors(field)
    return Program(f"gradient_{field.name}", (u, v, k_u, k_v), named.definitions + tail.definitions, (h_u, h_v))


slope_value = real("slope")
slope = Program("slope", (h_u, h_v), ((slope_value, sqrt(h_u**2 + h_v**2)),))
"""|∇h| = √(h_u² + h_v²), in the chart."""
