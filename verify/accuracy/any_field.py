"""The error of a central difference of any smooth field, and a bound on it that knows nothing of the field's form.

Where both samples lie on the chart and no crease lies between them, truncation is at most ε²/6 times the largest |h‴|
there (Taylor, Lagrange's remainder), which a ball around the point encloses. What rounding adds is bounded by the
difference's own lines, run on numbers with bounds.
"""

from typing import NamedTuple

import numpy as np
from flint import arb
from sympy import Expr, Symbol, diff

from proofs.engine.program import chain
from proofs.engine.vectors import real
from proofs.formulas.finite_difference import central
from proofs.formulas.height_fields import HeightField, gradient
from renderer.checks import not_allowed
from renderer.machines.enclosing import SLACK
from verify.evaluate.arrays import BITS, Inputs, distance, in_balls, with_bounds
from verify.evaluate.balls import Balls

THIRD = real("third")


class Curve(NamedTuple):
    """The error of a slope over steps, the bound on it, and truncation's share: arrays of float64, one for each."""

    error: np.ndarray
    bound: np.ndarray
    truncation: np.ndarray


def third_derivatives(field: HeightField, along: Symbol, inputs: Inputs, steps: np.ndarray) -> np.ndarray:
    """Return what |h‴| along u or v is at most within a step of the point, for each step. inputs: u, v, k_u, k_v.

    Raises ValueError on a field with creases, and where there is no bound.
    """
    if field.creases:
        raise not_allowed("field", field.name, "one without creases")
    third: Expr = diff(field.expression, along, 3)
    balls = Balls(chain("third", {THIRD: third}))
    found = []
    for step in steps.tolist():
        size = balls({**inputs, along.name: arb(inputs[along.name], step)}, BITS)["third"].abs_upper()
        if not size.is_finite():
            raise not_allowed("step", step, f"one within which {field.name} is smooth")
        found.append(float(size) * SLACK)
    return np.array(found)


def u_curve(field: HeightField, along: Symbol, inputs: Inputs, steps: np.ndarray) -> Curve:
    """Return the error of the slope along u or v, and its bound, over steps that keep both samples inside [0, 1].

    inputs: u, v, k_u, k_v. Raises ValueError as the above.
    """
    slope = f"h_{along.name}"
    computed = with_bounds(central(field), {**inputs, "epsilon": steps})[slope]
    exact = in_balls(gradient(field), inputs)[slope]
    truncation = steps**2 / 6 * third_derivatives(field, along, inputs, steps) * SLACK
    return Curve(distance(computed.value, exact), (truncation + computed.bound) * SLACK, truncation)
