"""The best step and its floor against the wave number, and what a representable step buys."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import curve, decades, dots, label_line_end, plot
from verify.accuracy.best_step import WAVE_NUMBERS, gain, measured, predicted

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
