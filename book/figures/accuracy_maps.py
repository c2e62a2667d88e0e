"""Accuracy over the input space, as Herbie draws it: over the chart, over the image, and about the pole."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import panels
from book.figures.chapter_scene import enlarged
from renderer.picture.views import difference_logarithmic
from verify.stability import maps

LOW, HIGH = 0, 8
OFF = 0x80  # the grey of what is not on A
TITLES = {"seed": "the seed's form", "ours": "ours"}
SIDE, REACH, ZOOM = 128, 1e-3, 2
_chart, _image = cache(maps.over_the_chart), cache(maps.over_the_image)


def _picture(units):
    """Return a map as a picture: one unit and less is black, what is off A grey."""
    picture = difference_logarithmic(np.where(units > 1, units, 0.0), LOW, HIGH)
    return enlarged(np.where(np.isnan(units)[..., None], np.uint8(OFF), picture), ZOOM)


def _drawing(errors, **numbers) -> Drawing:
    """Both maps beside each other, their medians and largest errors; the data are NaN where there is no error."""
    pictures = [_picture(errors[name]) for name in TITLES]
    fig = panels(pictures, list(TITLES.values()), (LOW, HIGH), "error, in units of the rounding")
    summaries = {name: dict(zip(("median", "most"), maps.summary(errors[name]), strict=True)) for name in TITLES}
    return Drawing(fig, summaries | numbers, {name: errors[name] for name in TITLES})


@figure
def accuracy_chart() -> Drawing:
    """The error of h_u over the chart, relative to h_u itself, in units of 2^-53: the seed's form and ours."""
    return _drawing(_chart(side=SIDE), side=SIDE)


@figure
def accuracy_image() -> Drawing:
    """The error of g over sphere A, in units of 2^-53 π k: the seed's form and ours."""
    return _drawing(_image(size=SIDE, reach=1.0))


@figure
def accuracy_pole() -> Drawing:
    """The same about the pole, enlarged a thousand times."""
    return _drawing(_image(size=SIDE, reach=REACH), reach=REACH)
