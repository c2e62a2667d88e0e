"""Finite differences of a height field: forward, central, fourth order.

u wraps around the seam, v is clamped to [0, 1]; ε is used as given. Where v ± ε leaves [0, 1] the difference in v
is one-sided and divides by the clamped span. Domain: 0 < ε ≤ 1/2.
"""

from sympy import And, Max, Min, floor

from proofs.engine.program import Program, evaluated
from proofs.formulas.height_fields import HeightField
from proofs.formulas.symbols import epsilon, h_u, h_v, k_u, k_v, real, u, v, where

u_plus, u_minus, v_plus, v_minus = real("u_plus u_minus v_plus v_minus")
u_plus_2, u_minus_2, v_plus_2, v_minus_2 = real("u_plus_2 u_minus_2 v_plus_2 v_minus_2")
h_here, h_u_plus, h_u_minus, h_v_plus, h_v_minus = real("h_here h_u_plus h_u_minus h_v_plus h_v_minus")
h_u_plus_2, h_u_minus_2, h_v_plus_2, h_v_minus_2 = real("h_u_plus_2 h_u_minus_2 h_v_plus_2 h_v_minus_2")
span_v, near_difference_u, near_difference_v = real("span_v near_difference_u near_difference_v")

HEIGHTS = (h_here, h_u_plus, h_u_minus, h_v_plus, h_v_minus, h_u_plus_2, h_u_minus_2, h_v_plus_2, h_v_minus_2)
"""The names of heights in a difference."""

HEIGHT_EVALUATIONS = {"forward": 3, "central": 4, "central4": 8}


def _wrapped(moved):
    return moved - floor(moved)


_plus_and_minus = (
    (u_plus, _wrapped(u + epsilon)),
    (u_minus, _wrapped(u - epsilon)),
    (v_plus, Min(1, v + epsilon)),
    (v_minus, Max(0, v - epsilon)),
    (span_v, where(And(v + epsilon <= 1, v - epsilon >= 0), 2 * epsilon, v_plus - v_minus)),
)
_four = ((h_u_plus, u_plus, v), (h_u_minus, u_minus, v), (h_v_plus, u, v_plus), (h_v_minus, u, v_minus))
_four_twice_as_far = (
    (h_u_plus_2, u_plus_2, v),
    (h_u_minus_2, u_minus_2, v),
    (h_v_plus_2, u, v_plus_2),
    (h_v_minus_2, u, v_minus_2),
)


def _heights(field, *samples):
    """Return the definitions name = h(u', v') for samples (name, u', v')."""
    return tuple((name, field.expression.xreplace({u: at_u, v: at_v})) for name, at_u, at_v in samples)


@evaluated
def forward(field: HeightField) -> Program:
    """Return (h(u + ε) − h)/ε, and backward in v where v + ε > 1. First order; 3 height evaluations."""
    stepped = real("stepped")
    lines = (
        (u_plus, _wrapped(u + epsilon)),
        (stepped, where(v + epsilon <= 1, v + epsilon, v - epsilon)),
        *_heights(field, (h_here, u, v), (h_u_plus, u_plus, v), (h_v_plus, u, stepped)),
        (h_u, (h_u_plus - h_here) / epsilon),
        (h_v, where(v + epsilon <= 1, (h_v_plus - h_here) / epsilon, (h_here - h_v_plus) / epsilon)),
    )
    return _program("forward", field, lines)


@evaluated
def central(field: HeightField) -> Program:
    """Return (h(u + ε) − h(u − ε))/2ε, the same in v, clamped at the poles. Second order; 4 evaluations."""
    lines = (
        *_plus_and_minus,
        *_heights(field, *_four),
        (h_u, (h_u_plus - h_u_minus) / (2 * epsilon)),
        (h_v, (h_v_plus - h_v_minus) / span_v),
    )
    return _program("central", field, lines)


@evaluated
def central4(field: HeightField) -> Program:
    """Return (8 (h(u + ε) − h(u − ε)) − (h(u + 2ε) − h(u − 2ε)))/12ε; near a pole, central in v. 8 evaluations."""
    lines = (
        *_plus_and_minus,
        (u_plus_2, _wrapped(u + 2 * epsilon)),
        (u_minus_2, _wrapped(u - 2 * epsilon)),
        (v_plus_2, Min(1, v + 2 * epsilon)),
        (v_minus_2, Max(0, v - 2 * epsilon)),
        *_heights(field, *_four, *_four_twice_as_far),
        (near_difference_u, h_u_plus - h_u_minus),  # named, or 8 is multiplied in and equal heights do not cancel
        (h_u, (8 * near_difference_u - (h_u_plus_2 - h_u_minus_2)) / (12 * epsilon)),
        (near_difference_v, h_v_plus - h_v_minus),
        (
            h_v,
            where(
                And(v + 2 * epsilon <= 1, v - 2 * epsilon >= 0),
                (8 * near_difference_v - (h_v_plus_2 - h_v_minus_2)) / (12 * epsilon),
                near_difference_v / span_v,
            ),
        ),
    )
    return _program("central4", field, lines)


def _program(name, field, lines):
    return Program(f"{name}_{field.name}", (u, v, k_u, k_v, epsilon), lines, (h_u, h_v))


METHODS = {"forward": forward, "central": central, "central4": central4}
