"""The U-curve: the error of a central difference against its step, by balls of 50 digits."""

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import curve, decades, dots, label_line_end, plot, slope_triangle
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from renderer import Scene
from renderer.generate.step_terms import slope_bound
from renderer.operations import UNIT
from renderer.picture.facts import SMOOTH_POINT
from verify.accuracy.best_step import best_of
from verify.accuracy.differences import Case, parts
from verify.accuracy.orders import fitted_slope
from verify.evaluate.arrays import in_balls

SCENE = Scene(field="sine")
CASE = Case("the chapter's", SCENE.field, SCENE.ku, SCENE.kv, *SMOOTH_POINT)


@figure
def u_curve() -> Drawing:
    """The error of the central difference of sine at a smooth point, from ε = 0.1 to 1e-12."""
    steps = np.logspace(-1, -12, 221)
    curves = {part: np.abs(values) for part, values in parts(CASE, steps).items()}
    measured, truncation = curves["total"], curves["truncation"]
    fig, ax = plot(height=3.9)
    dots(ax, steps, measured, "numeric", 2.6)
    curve(ax, steps, truncation, "bound")
    decades(ax, 2, 2, ylim=(1e-13, 1e2), xlabel="step ε", ylabel="error of $h_u$")
    label_line_end(ax, steps[0], measured[0], "central\ndifference", "numeric")
    at_middle = np.interp(-1e-7, -steps, truncation)
    label_line_end(ax, 1e-7, at_middle, "truncation, in\nexact arithmetic", "bound", "left")
    slope_triangle(ax, 3e-4, 1e-7, 2)
    branch = (steps < 3e-2) & (steps > 1e-4)
    best, predicted = measured.argmin(), best_of(SCENE.ku, UNIT).step
    near = (steps > predicted / 3) & (steps < 3 * predicted)
    cited = (1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12)
    at = {f"error_{eps:.0e}": error for eps, error in zip(cited, np.abs(parts(CASE, cited)["total"]), strict=True)}
    third = slope_bound(SCENE.ku) ** 3
    numbers = {
        "u": SMOOTH_POINT[0],
        "v": SMOOTH_POINT[1],
        "least": measured[best],
        "near_best": np.median(measured[near]),
        "best_eps": steps[best],
        "slope": fitted_slope(steps[branch], measured[branch]),
        "exact": float(in_balls(gradient(HEIGHT_FIELDS[SCENE.field]), CASE.inputs)[CASE.component].item()),
        "third_derivative": third,
        "third_derivative_half": slope_bound(SCENE.ku / 2) ** 3,
        "predicted_eps": predicted,
    }
    data = {"step": steps, "error": measured, "truncation": truncation}
    return Drawing(fig, numbers | at, data)
