"""The central difference's error against its step, by balls of 50 digits; the best step against the wave number."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import curve, decades, dots, label_line_end, plot, slope_triangle
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from renderer import Scene
from renderer.generate.step_terms import slope_bound
from renderer.operations import UNIT
from renderer.picture.facts import SMOOTH_POINT
from verify.accuracy.best_step import WAVE_NUMBERS, best_of, gain, measured, predicted
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
    total, truncation = curves["total"], curves["truncation"]
    fig, ax = plot(height=3.9)
    dots(ax, steps, total, "numeric", 2.6)
    curve(ax, steps, truncation, "bound")
    decades(ax, 2, 2, ylim=(1e-13, 1e2), xlabel="step ε", ylabel="error of $h_u$")
    label_line_end(ax, steps[0], total[0], "central\ndifference", "numeric")
    at_middle = np.interp(-1e-7, -steps, truncation)
    label_line_end(ax, 1e-7, at_middle, "truncation, in\nexact arithmetic", "bound", "left")
    slope_triangle(ax, 3e-4, 1e-7, 2)
    branch = (steps < 3e-2) & (steps > 1e-4)
    best, step = total.argmin(), best_of(SCENE.ku, UNIT).step
    near = (steps > step / 3) & (steps < 3 * step)
    cited = (1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12)
    at = {f"error_{eps:.0e}": error for eps, error in zip(cited, np.abs(parts(CASE, cited)["total"]), strict=True)}
    numbers = {
        "u": SMOOTH_POINT[0],
        "v": SMOOTH_POINT[1],
        "least": total[best],
        "near_best": np.median(total[near]),
        "best_eps": steps[best],
        "slope": fitted_slope(steps[branch], total[branch]),
        "exact": float(in_balls(gradient(HEIGHT_FIELDS[SCENE.field]), CASE.inputs)[CASE.component].item()),
        "third_derivative": slope_bound(SCENE.ku) ** 3,
        "third_derivative_half": slope_bound(SCENE.ku / 2) ** 3,
        "predicted_eps": step,
    }
    data = {"step": steps, "error": total, "truncation": truncation}
    return Drawing(fig, numbers | at, data)


LABELS = {(0, False): (50, 4e-7), (0, True): (2, 1.2e-7), (1, False): (2, 6e-8), (1, True): (60, 5e-10)}


@cache
def _steps_and_floors(representable):
    """Return (predicted, measured), each (wave numbers, 2): steps and floors."""
    return tuple(np.array([best(k, representable) for k in WAVE_NUMBERS]) for best in (predicted, measured))


@figure
def best_step() -> Drawing:
    """The best step of the central difference of sine and the floor it leaves, for k from 1 to 512."""
    fig, axes = plot("page", 3.7, ncols=2)
    styles = {False: ("numeric", "o", "ε as given"), True: ("symbolic", "s", "(u + ε) − u")}
    for index, (ax, name) in enumerate(zip(axes, ("best step", "error it leaves"), strict=True)):
        for representable, (role, marker, label) in styles.items():
            proved, seen = _steps_and_floors(representable)
            curve(ax, WAVE_NUMBERS, proved[:, index], "bound")
            dots(ax, WAVE_NUMBERS, seen[:, index], role, 4.5, marker)
            label_line_end(ax, *LABELS[index, representable], label, role)
        decades(ax, xlabel="wave number $k_u$", ylabel=name)
    numbers, data = {}, {"wave_number": WAVE_NUMBERS}
    for representable, short in ((False, "plain"), (True, "trick")):
        proved, seen = _steps_and_floors(representable)
        columns = {}
        for index, what in enumerate(("step", "floor")):
            columns |= {what: seen[:, index], f"{what}_proved": proved[:, index]}
        data[short] = columns
        numbers[short] = {
            k: {what: column[WAVE_NUMBERS.index(k)] for what, column in columns.items()} for k in (8, 512)
        }
        if not (seen[:, 1] <= proved[:, 1]).all():
            raise ValueError(f"a measured floor ({short}) is above the proved one")
    for k in (8, 512):
        numbers[f"gain_{k}"] = numbers["plain"][k]["floor"] / numbers["trick"][k]["floor"]
        numbers[f"library_gain_{k}"] = gain(k, library=True)
    return Drawing(fig, numbers, data)
