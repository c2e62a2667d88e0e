"""Accuracy over the input space, as Herbie draws it: over the chart, over the image, and about the pole."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import panels
from renderer.views import difference_logarithmic
from verify.stability import maps

LOW, HIGH = 0, 8
OFF = 0x80  # the grey of what is not on A
TITLES = ("the seed's form", "ours")
SIDE, REACH = 128, 1e-3
LABEL = "error, in units of the rounding"


def _pictures(found, zoom):
    """Return the two maps as pictures: one unit and less is black, what is off A grey."""
    for name in ("seed", "ours"):
        units = found[name]
        picture = difference_logarithmic(np.where(units > 1, units, 0.0), LOW, HIGH)
        picture = np.where(np.isnan(units)[..., None], np.uint8(OFF), picture)
        yield picture.repeat(zoom, axis=0).repeat(zoom, axis=1)


@cache
def _chart():
    return maps.over_the_chart(side=SIDE)


@cache
def _image(reach):
    return maps.over_the_image(size=SIDE, reach=reach)


def _maps(found):
    """Return the errors that the pictures show, in units of the rounding, NaN where there is none."""
    return {name: found[name] for name in ("seed", "ours")}


def _numbers(found):
    numbers = {}
    for name in ("seed", "ours"):
        numbers[f"{name}_median"], numbers[f"{name}_most"] = maps.summary(found[name])
    return numbers


@figure("accuracy_chart")
def accuracy_chart() -> Drawing:
    """The error of h_u over the chart, relative to h_u itself, in units of 2^-53: the seed's form and ours."""
    found = _chart()
    fig = panels(list(_pictures(found, 2)), TITLES, bar=(LOW, HIGH), bar_label=LABEL)
    return Drawing(fig, numbers=_numbers(found) | {"side": SIDE}, data=_maps(found))


@figure("accuracy_image")
def accuracy_image() -> Drawing:
    """The error of g over sphere A, in units of 2^-53 π k: the seed's form and ours."""
    found = _image(1.0)
    fig = panels(list(_pictures(found, 2)), TITLES, bar=(LOW, HIGH), bar_label=LABEL)
    return Drawing(fig, numbers=_numbers(found), data=_maps(found))


@figure("accuracy_pole")
def accuracy_pole() -> Drawing:
    """The same about the pole, enlarged a thousand times."""
    found = _image(REACH)
    fig = panels(list(_pictures(found, 2)), TITLES, bar=(LOW, HIGH), bar_label=LABEL)
    return Drawing(fig, numbers=_numbers(found) | {"reach": REACH}, data=_maps(found))
