"""The certified bound of every colour over the picture, beside the error itself."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import panels
from book.figures.chapter_scene import FIELD_NAMES, SIZE, averaged, certified_numbers, enlarged, symbolic
from renderer.picture.differences import rounded_up
from renderer.picture.views import difference_logarithmic, image_view
from verify.accuracy.pixels import errors_of, truth_of

SIDE, ZOOM = 64, 4  # few enough pixels for 256-bit balls of every one
LOW, HIGH = -18, -9


@cache
def _errors():
    """Return how far each colour of the small picture is from 256-bit balls, rounded up: (SIDE, SIDE, 3)."""
    frame = symbolic(size=SIDE)
    places = ((column, row) for row in range(SIDE) for column in range(SIDE))
    errors = [[float(off.upper()) for off in errors_of(frame, *p, truth_of(frame, *p))] for p in places]
    return np.reshape(errors, (SIDE, SIDE, 3))


@figure
def certified_bounds() -> Drawing:
    """The picture, the bound that it carries, and its true error, of every pixel of a small raster."""
    frame, errors = symbolic(size=SIDE), _errors()
    bounds = frame.bounds
    if (errors > bounds).any():
        raise ValueError(f"{(errors > bounds).sum()} colours are further from the truth than their bound")
    maps = [enlarged(difference_logarithmic(each, LOW, HIGH), ZOOM) for each in (bounds, errors)]
    pictures = [averaged(image_view(symbolic(size=SIZE * 3))), *maps]
    fig = panels(pictures, ("the picture", "its bound", "its error"), (LOW, HIGH), "largest of a channel")
    numbers = {
        "side": SIDE,
        "colours": errors.size,
        "largest_error": float(rounded_up(errors.max(), 2)),
        "median_ratio": np.median(bounds[errors > 0] / errors[errors > 0]),
        "largest_share": (errors[bounds > 0] / bounds[bounds > 0]).max(),
    }
    numbers |= {field: certified_numbers(symbolic(field)) for field in FIELD_NAMES}
    data = {"bound": bounds.max(axis=2), "error": errors.max(axis=2)}
    return Drawing(fig, numbers | {"whole_side": SIZE}, data, (frame, symbolic(size=SIZE * 3)))
