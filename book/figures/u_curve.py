"""The U-curve: the error of a central difference against its step, measured by mpmath at 50 digits."""

from functools import partial

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import curve, decades, dots, label_line_end, plot, slope_triangle
from renderer import Scene
from renderer.picture.facts import SMOOTH_POINT
from verify.accuracy import u_curve as by_mpmath
from verify.accuracy.clamped_order import fitted_slope

SCENE = Scene(field="sine")
UNIT_ROUNDOFF = 2.0**-53


errors = partial(by_mpmath.errors, *SMOOTH_POINT)
truncation = partial(by_mpmath.truncation, *SMOOTH_POINT)


@figure
def u_curve() -> Drawing:
    """The error of the central difference of sine at a smooth point, from ε = 0.1 to 1e-12."""
    steps = np.logspace(-1, -12, 221)
    measured = errors(steps)
    fig, ax = plot(height=3.9)
    dots(ax, steps, measured, "numeric", 2.6)
    curve(ax, steps, truncation(steps), "bound")
    decades(ax, 2, 2, ylim=(1e-13, 1e2), xlabel="step ε", ylabel="error of $h_u$")
    label_line_end(ax, steps[0], measured[0], "central\ndifference", "numeric")
    label_line_end(ax, 1e-7, truncation([1e-7])[0], "truncation, in\nexact arithmetic", "bound", "left")
    slope_triangle(ax, 3e-4, 1e-7, 2)
    branch = (steps < 3e-2) & (steps > 1e-4)
    best = measured.argmin()
    cited = (1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12)
    at = {f"error_{eps:.0e}": error for eps, error in zip(cited, errors(cited), strict=True)}
    third = (np.pi * SCENE.ku) ** 3
    numbers = {
        "u": SMOOTH_POINT[0],
        "v": SMOOTH_POINT[1],
        "least": measured[best],
        "best_eps": steps[best],
        "slope": fitted_slope(steps[branch], measured[branch]),
        "exact": float(by_mpmath.exact_slope(*SMOOTH_POINT)),
        "third_derivative": third,
        "third_derivative_half": (np.pi * SCENE.ku / 2) ** 3,
        "predicted_eps": (3 * UNIT_ROUNDOFF / third) ** (1 / 3),
    }
    data = {"step": steps, "error": measured, "truncation": truncation(steps)}
    return Drawing(fig, numbers | at, data)
