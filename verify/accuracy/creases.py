"""The creases of a field on the image: the lines on which a crease factor sinpi(w) is zero, seen from the eye.

Functions of float64 numbers, NumPy's arrays or traced values, as the kernels are.
"""

from collections.abc import Callable

from sympy import diff, expand

from proofs.engine.program import Program
from proofs.engine.vectors import real
from proofs.formulas.camera import parallel_radius
from proofs.formulas.chart import chart_inverse
from proofs.formulas.height_fields import HeightField
from proofs.formulas.symbols import k_u, k_v, u, v
from renderer.generate.kernels import function_of
from renderer.operations import Number, where

radius_of_parallel, angles_at = map(function_of, (parallel_radius, chart_inverse))


def crease_rates(field: HeightField) -> Callable:
    """Return the function (k_u, k_v) → for each crease factor sinpi(a u + b v + c): a, b and c."""
    lines: dict = {}
    for number, factor in enumerate(field.creases):
        turns = expand(factor.args[0])
        parts = diff(turns, u), diff(turns, v), turns.subs({u: 0, v: 0})
        lines |= {real(f"rate_{number}_{part}"): value for part, value in enumerate(parts)}
    return function_of(Program(f"creases_{field.name}", (k_u, k_v), lines, [*lines]))


def crease_point(
    rate_u: Number, rate_v: Number, level: Number, along: Number, eye: Number, radius: Number
) -> tuple[Number, Number]:
    """Return the image point of a point of the crease on which rate_u u + rate_v v is `level`, NaN where it is hidden.

    along: u in [0, 1], or v where the crease is a meridian (rate_v is 0).
    """
    is_meridian = rate_v == 0.0
    at_u = where(is_meridian, level / rate_u, along)
    at_v = where(is_meridian, along, (level - rate_u * along) / rate_v)
    cos_theta, sin_theta, cos_phi, sin_phi = angles_at(at_u, at_v)
    rho = radius_of_parallel(sin_phi, cos_phi, eye, radius)
    is_seen = (at_v >= 0.0) & (at_v <= 1.0) & (eye * cos_phi > radius)  # theorem visible_iff
    rho = where(is_seen, rho, float("nan"))
    return rho * cos_theta, rho * sin_theta
