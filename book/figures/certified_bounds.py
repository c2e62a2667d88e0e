"""Certified bounds beside true errors: of a small picture, and of fields of one's own."""

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import panels
from book.figures.chapter_scene import FIELD_NAMES, FINE, SIZE, certified_numbers, enlarged, smooth, symbolic
from renderer import HeightField, Scene, render
from renderer.generate.reader import parse_expression
from renderer.intervals import rounded_up
from renderer.picture.views import difference_logarithmic
from verify.accuracy.pixels import compared

SIDE, ZOOM = 64, 4  # few enough pixels for 256-bit balls of every one
LOW, HIGH = -18, -8


@figure
def certified_bounds() -> Drawing:
    """The picture, the bound that it carries, and its true error, of every pixel of a small raster."""
    frame = symbolic(size=SIDE)
    places = ((column, row) for row in range(SIDE) for column in range(SIDE))
    off = [[float(each.upper()) for each in compared(frame, *place)[1]] for place in places]
    bounds, errors = frame.bounds, np.reshape(off, (SIDE, SIDE, 3))  # rounded up, from 256-bit balls
    if (errors > bounds).any():
        raise ValueError(f"{(errors > bounds).sum()} colours are further from the truth than their bound")
    fine = symbolic(size=SIZE * FINE)
    maps = [enlarged(difference_logarithmic(each, LOW, HIGH), ZOOM) for each in (bounds, errors)]
    pictures = [smooth(fine), *maps]
    fig = panels(pictures, ("the picture", "its bound", "its error"), (LOW, HIGH), "largest of a channel")
    numbers = {
        "side": SIDE,
        "colours": errors.size,
        "largest_error": float(rounded_up(errors.max(), 2)),
        "median_ratio": np.median(bounds[errors > 0] / errors[errors > 0]),
        "largest_share": (errors[bounds > 0] / bounds[bounds > 0]).max(),
    }
    numbers |= {field: certified_numbers(symbolic(field)) for field in FIELD_NAMES}
    return Drawing(fig, numbers | {"whole_side": SIZE}, shown=(frame, fine))


TEXTS = {
    "crater": "exp(-150*(v - 1/5)**2) - exp(-60*v**2)/2",
    "dunes": "v*(1 + sinpi(k_u*u + 4*sinpi(2*v)))**2/2",
    "hill": "9*v**2*exp(4*(cospi(2*u - 7/4) - 1) - 60*(v - 1/5)**2)",
}


def scene_of(name: str) -> Scene:
    """Return the chapter's scene with one of the three fields."""
    return Scene(field=HeightField(name, parse_expression(TEXTS[name])))


@figure
def own_fields() -> Drawing:
    """Crater, dunes and a hill on sphere A, and the certified bound of each picture."""
    columns, numbers, frames = [], {}, []
    for name in TEXTS:
        fine, frame = (render(scene_of(name), side, side, bounds=True) for side in (SIZE * FINE, SIZE))
        bounds = difference_logarithmic(frame.bounds, LOW, HIGH)
        columns.append(np.vstack([smooth(fine), bounds]))
        frames.append(frame)
        numbers[name] = certified_numbers(frame)
    fig = panels(columns, tuple(TEXTS), (LOW, HIGH), "bound of a channel")
    return Drawing(fig, numbers | {"side": SIZE}, shown=frames)
