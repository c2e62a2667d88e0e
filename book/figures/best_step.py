"""The best step and its floor against the wave number, and what a representable step buys."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import bound_style, decades, label_line_end, palette, plot
from verify.accuracy.best_step import WAVE_NUMBERS, gain, measured, predicted

LABELS = {(0, False): (50, 4e-7), (0, True): (2, 1.2e-7), (1, False): (2, 6e-8), (1, True): (60, 5e-10)}


@cache
def _found(representable):
    """Return (predicted, measured), each (wave numbers, 2): steps and floors."""
    return tuple(np.array([best(k, representable) for k in WAVE_NUMBERS]) for best in (predicted, measured))


@figure("best_step")
def best_step() -> Drawing:
    """The best step of the central difference of sine and the floor it leaves, for k from 1 to 512."""
    fig, axes = plot("page", 3.7, ncols=2)
    styles = {False: (palette()["numeric"], "o", "ε as given"), True: (palette()["symbolic"], "s", "(u + ε) − u")}
    for index, (ax, name) in enumerate(zip(axes, ("best step", "error it leaves"), strict=True)):
        for representable, (colour, marker, label) in styles.items():
            proved, seen = _found(representable)
            ax.plot(WAVE_NUMBERS, proved[:, index], **bound_style())
            ax.plot(WAVE_NUMBERS, seen[:, index], color=colour, linewidth=0, marker=marker, markersize=4.5)
            k, y = LABELS[index, representable]
            label_line_end(ax, k, y, label, colour)
        decades(ax, xlabel="wave number $k_u$", ylabel=name)
    numbers, data = {}, {"wave_number": WAVE_NUMBERS}
    for representable, short in ((False, "plain"), (True, "trick")):
        proved, seen = _found(representable)
        for index, what in enumerate(("step", "floor")):
            data |= {f"{short}_{what}": seen[:, index], f"{short}_{what}_proved": proved[:, index]}
        for k in (8, 512):
            i = WAVE_NUMBERS.index(k)
            numbers |= {f"{short}_{k}_step": seen[i, 0], f"{short}_{k}_floor": seen[i, 1]}
            numbers |= {f"{short}_{k}_step_proved": proved[i, 0], f"{short}_{k}_floor_proved": proved[i, 1]}
        if not (seen[:, 1] <= proved[:, 1]).all():
            raise ValueError(f"a measured floor ({short}) is above the proved one")
    numbers |= {f"gain_{k}": numbers[f"plain_{k}_floor"] / numbers[f"trick_{k}_floor"] for k in (8, 512)}
    numbers |= {f"library_gain_{k}": gain(k, library=True) for k in (8, 512)}
    return Drawing(fig, numbers=numbers, data=data)
