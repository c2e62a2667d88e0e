"""The U-curve: the error of a central difference against its step."""

import numpy as np
from sympy import Rational

from book.drawing.registry import Drawing, figure
from book.drawing.style import bound_style, decades, label_line_end, palette, plot, readable, slope_triangle
from proofs.formulas.half_turns import ordinary
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.symbols import k_u, k_v, u, v
from renderer import Scene, central, gradient_at
from renderer.facts import SMOOTH_POINT

SCENE = Scene(field="sine")
UNIT_ROUNDOFF = 2.0**-53


def reference(digits=50):
    """Return h_u of sine at the smooth point, as float64, from the exact expression at 50 digits."""
    values = {u: Rational(SMOOTH_POINT[0]), v: Rational(SMOOTH_POINT[1]), k_u: int(SCENE.ku), k_v: int(SCENE.kv)}
    return float(ordinary(HEIGHT_FIELDS["sine"].gradient()[0]).subs(values).evalf(digits))


def errors(steps):
    """Return |central h_u − reference| for each step."""
    right = reference()
    return np.array([abs(float(gradient_at(SCENE, *SMOOTH_POINT, central(eps))[0]) - right) for eps in steps])


def truncation(steps):
    """Return the error in exact arithmetic: |h_u| · (1 − sinc(πkε)), where it can be told from 0."""
    angle = np.pi * SCENE.ku * steps
    return abs(reference()) * np.where(angle > 1e-4, 1 - np.sin(angle) / angle, angle**2 / 6)


@figure("u_curve")
def u_curve() -> Drawing:
    """The error of the central difference of sine at a smooth point, from ε = 0.1 to 1e-12."""
    steps = np.logspace(-1, -12, 221)
    measured = errors(steps)
    fig, ax = plot(height=3.9)
    colour = palette()["numeric"]
    ax.plot(steps, measured, color=colour, linewidth=0, marker="o", markersize=2.6)
    ax.plot(steps, truncation(steps), **bound_style())
    decades(ax, "x", every=2)
    decades(ax, "y", every=2)
    ax.set_ylim(1e-13, 1e2)
    ax.set_xlabel("step ε")
    ax.set_ylabel("error of $h_u$")
    label_line_end(ax, steps[0], measured[0], "central\ndifference", readable(colour))
    middle, ink = 1e-7, readable(palette()["bound"])
    at_middle = truncation(np.array([middle]))[0]
    label_line_end(ax, middle, at_middle, "truncation, in\nexact arithmetic", ink, side="left")
    slope_triangle(ax, 3e-4, 1e-7, 2, "2")
    branch = (steps < 3e-2) & (steps > 1e-4)
    slope = np.polyfit(np.log(steps[branch]), np.log(measured[branch]), 1)[0]
    best = measured.argmin()
    cited = (1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12)
    at = {f"error_{eps:.0e}": error for eps, error in zip(cited, errors(cited), strict=True)}
    third = (np.pi * SCENE.ku) ** 3
    numbers = {
        "u": SMOOTH_POINT[0],
        "v": SMOOTH_POINT[1],
        "least": measured[best],
        "best_eps": steps[best],
        "slope": slope,
        "exact": reference(),
        "third_derivative": third,
        "third_derivative_half": (np.pi * SCENE.ku / 2) ** 3,
        "predicted_eps": (3 * UNIT_ROUNDOFF / third) ** (1 / 3),
    }
    data = {"step": steps, "error": measured, "truncation": truncation(steps)}
    return Drawing(fig, numbers=numbers | at, data=data)
