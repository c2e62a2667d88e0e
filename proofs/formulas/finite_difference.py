"""Finite differences of a height field: forward, central, fourth order.

u wraps around the seam, v is clamped to [0, 1]; ε is used as given. Where v ± ε leaves [0, 1] the difference in v
is one-sided and divides by the clamped span. Domain: 0 < ε ≤ 1/2.
"""

from collections.abc import Iterable

from sympy import And, Expr, Max, Min, Symbol, floor

from proofs.engine.program import Program, evaluated
from proofs.engine.vectors import real, where
from proofs.formulas.height_fields import IN_CHART, HeightField
from proofs.formulas.symbols import epsilon, h_u, h_v, u, v

NEAR = u_plus, u_minus, v_plus, v_minus = real("u_plus u_minus v_plus v_minus")
FAR = real("u_plus_2 u_minus_2 v_plus_2 v_minus_2")
h_here = real("h_here")
NEAR_HEIGHTS = h_u_plus, h_u_minus, h_v_plus, h_v_minus = real("h_u_plus h_u_minus h_v_plus h_v_minus")
FAR_HEIGHTS = h_u_plus_2, h_u_minus_2, h_v_plus_2, h_v_minus_2 = real("h_u_plus_2 h_u_minus_2 h_v_plus_2 h_v_minus_2")
span_v, stepped = real("span_v stepped")
near_difference_u, near_difference_v = real("near_difference_u near_difference_v")

HEIGHTS = (h_here, *NEAR_HEIGHTS, *FAR_HEIGHTS)
"""The names of heights in a difference."""

HEIGHT_EVALUATIONS = {"forward": 3, "central": 4, "central4": 8}


def _wrapped(moved):
    return moved - floor(moved)


def neighbours(names: Iterable[Symbol], step: Expr) -> dict[Symbol, Expr]:
    """Return the lines of u ± step, wrapped around the seam, and of v ± step, clamped at the poles."""
    moved = (_wrapped(u + step), _wrapped(u - step), Min(1, v + step), Max(0, v - step))
    return dict(zip(names, moved, strict=True))


def _heights(field, names, moved):
    """Return the lines of the heights at the moved coordinates: u up and down, then v."""
    samples = [(at, v) for at in moved[:2]] + [(u, at) for at in moved[2:]]
    return {name: field.at(*sample) for name, sample in zip(names, samples, strict=True)}


_span = where(And(v + epsilon <= 1, v - epsilon >= 0), 2 * epsilon, v_plus - v_minus)
_steps = neighbours(NEAR, epsilon) | {span_v: _span}


@evaluated
def forward(field: HeightField) -> Program:
    """Return (h(u + ε) − h)/ε, and backward in v where v + ε > 1. First order; 3 height evaluations."""
    has_room = v + epsilon <= 1
    lines = {
        u_plus: _wrapped(u + epsilon),
        stepped: where(has_room, v + epsilon, v - epsilon),
        h_here: field.at(u, v),
        h_u_plus: field.at(u_plus, v),
        h_v_plus: field.at(u, stepped),
        h_u: (h_u_plus - h_here) / epsilon,
        h_v: where(has_room, (h_v_plus - h_here) / epsilon, (h_here - h_v_plus) / epsilon),
    }
    return _program("forward", field, lines)


@evaluated
def central(field: HeightField) -> Program:
    """Return (h(u + ε) − h(u − ε))/2ε, the same in v, clamped at the poles. Second order; 4 evaluations."""
    lines = {
        **_steps,
        **_heights(field, NEAR_HEIGHTS, NEAR),
        h_u: (h_u_plus - h_u_minus) / (2 * epsilon),
        h_v: (h_v_plus - h_v_minus) / span_v,
    }
    return _program("central", field, lines)


@evaluated
def central4(field: HeightField) -> Program:
    """Return (8 (h(u + ε) − h(u − ε)) − (h(u + 2ε) − h(u − 2ε)))/12ε; near a pole, central in v. 8 evaluations."""
    lines = {
        **_steps,
        **neighbours(FAR, 2 * epsilon),
        **_heights(field, NEAR_HEIGHTS, NEAR),
        **_heights(field, FAR_HEIGHTS, FAR),
        near_difference_u: h_u_plus - h_u_minus,  # named, or 8 is multiplied in and equal heights do not cancel
        h_u: (8 * near_difference_u - (h_u_plus_2 - h_u_minus_2)) / (12 * epsilon),
        near_difference_v: h_v_plus - h_v_minus,
        h_v: where(
            And(v + 2 * epsilon <= 1, v - 2 * epsilon >= 0),
            (8 * near_difference_v - (h_v_plus_2 - h_v_minus_2)) / (12 * epsilon),
            near_difference_v / span_v,
        ),
    }
    return _program("central4", field, lines)


def _program(name, field, lines):
    return Program(f"{name}_{field.name}", (IN_CHART, epsilon), lines, (h_u, h_v))


METHODS = {"forward": forward, "central": central, "central4": central4}
