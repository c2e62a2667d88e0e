"""The U-curve: the error of a central difference against its step, measured at 50 digits."""

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import bound_style, decades, label_line_end, palette, plot, slope_triangle
from renderer.facts import SMOOTH_POINT
from verify.accuracy.differences import Case, parts

UNIT_ROUNDOFF = 2.0**-53
PLACE = Case("smooth", "sine", 8.0, 4.0, *SMOOTH_POINT)


@figure("u_curve")
def u_curve() -> Drawing:
    """The error of the central difference of sine at a smooth point, from ε = 0.1 to 1e-12."""
    steps = np.logspace(-1, -12, 221)
    found = parts(PLACE, steps)
    measured, truncation = np.abs(found.total), np.abs(found.truncation)
    fig, ax = plot(height=3.9)
    colour = palette()["numeric"]
    ax.plot(steps, measured, color=colour, linewidth=0, marker="o", markersize=2.6)
    ax.plot(steps, truncation, **bound_style())
    decades(ax, 2, 2, ylim=(1e-13, 1e2), xlabel="step ε", ylabel="error of $h_u$")
    label_line_end(ax, steps[0], measured[0], "central\ndifference", colour)
    middle, ink = 1e-7, palette()["bound"]
    at_middle = np.abs(parts(PLACE, [middle]).truncation[0])
    label_line_end(ax, middle, at_middle, "truncation, in\nexact arithmetic", ink, side="left")
    slope_triangle(ax, 3e-4, 1e-7, 2, "2")
    branch = (steps < 3e-2) & (steps > 1e-4)
    slope = np.polyfit(np.log(steps[branch]), np.log(measured[branch]), 1)[0]
    best = measured.argmin()
    cited = (1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12)
    at = {f"error_{eps:.0e}": error for eps, error in zip(cited, np.abs(parts(PLACE, cited).total), strict=True)}
    third = (np.pi * PLACE.k_u) ** 3
    numbers = {
        "u": SMOOTH_POINT[0],
        "v": SMOOTH_POINT[1],
        "least": measured[best],
        "best_eps": steps[best],
        "slope": slope,
        "exact": found.slope,
        "third_derivative": third,
        "third_derivative_half": (np.pi * PLACE.k_u / 2) ** 3,
        "predicted_eps": (3 * UNIT_ROUNDOFF / third) ** (1 / 3),
    }
    data = {"step": steps, "error": measured, "truncation": truncation}
    return Drawing(fig, numbers=numbers | at, data=data)
