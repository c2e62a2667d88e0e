"""Creases of a height field: the kink flag that the views show, and the pixels whose difference straddles a crease.

Of a crease factor sinpi(w) with w linear in u and v the zeros are known: where w is a whole number. Any other's are
places where a crease may be, and a difference is taken to cross one where the factor has both signs at its heights;
one that is crossed twice within a step is not noticed.
"""

from sympy import Abs, And, Max, Min, Or, Rational, diff

from proofs.engine.half_turns import rint, sinpi
from proofs.engine.program import Program
from proofs.engine.vectors import real, where
from proofs.formulas.finite_difference import NEAR, neighbours
from proofs.formulas.height_fields import IN_CHART, HeightField
from proofs.formulas.symbols import epsilon, sin_phi, u, v

KINK_BAND = Rational(3, 100)  # the seed's: a crease factor below it in magnitude is shown as a kink

kink, straddles = real("kink straddles")


def kink_flag(field: HeightField) -> Program:
    """Return the program → 1 where a crease factor is below KINK_BAND in magnitude, and at the pole; else 0."""
    at_pole = sin_phi <= 0
    close = [Abs(factor) < KINK_BAND for factor in field.creases]
    return Program(f"kink_{field.name}", (sin_phi, IN_CHART), {kink: where(Or(at_pole, *close), 1, 0)})


def _is_straight(factor):
    return isinstance(factor, sinpi) and not any(diff(factor.args[0], c).has(u, v) for c in (u, v))


def straddling(field: HeightField) -> Program:
    """Return the program → 1 where a crease lies strictly inside (u − ε, u + ε) or (v − ε, v + ε); else 0.

    Where a factor depends on v alone and is zero at v = 0, that is the pole: the chart ends there, nothing is crossed.
    """
    lines: dict = {}
    conditions: list = []
    for number, factor in enumerate(field.creases):
        if not _is_straight(factor):
            lines |= neighbours(NEAR, epsilon)
            places = {u: (*NEAR[:2], u), v: (*NEAR[2:], v)}
            for c, at in places.items():
                sides = real(" ".join(f"side_{number}_{place}" for place in at))
                lines |= {side: factor.xreplace({c: place}) for side, place in zip(sides, at, strict=True)}
                conditions.append(And(Min(*sides) < 0, Max(*sides) > 0))
            continue
        (argument,) = factor.args
        distance = real(f"crease_distance_{number}")
        ends_at_pole = argument.subs(v, 0) == 0
        nearest = Max(1, rint(Abs(argument))) if ends_at_pole else rint(argument)
        lines[distance] = Abs((Abs(argument) if ends_at_pole else argument) - nearest)
        conditions += [distance < Abs(rate) * epsilon for c in (u, v) if (rate := diff(argument, c)) != 0]
    lines[straddles] = where(Or(*conditions), 1, 0) if conditions else 0 * epsilon
    return Program(f"straddling_{field.name}", (IN_CHART, epsilon), lines)
