"""Certified bounds beside true errors: of a small picture, and of custom fields."""

from random import Random

import numpy as np
from sympy import pi, sin

from book.drawing.registry import Drawing, figure
from book.drawing.style import panels
from book.figures.chapter_scene import FIELD_NAMES, FINE, SIZE, certified_numbers, enlarged, smooth, symbolic
from renderer import HeightField, Scene, render, u, v
from renderer.intervals import rounded_up
from renderer.picture.views import difference_logarithmic
from verify.enclosed_pixels import compared

SIDE, ZOOM = 64, 4  # few enough pixels for 256-bit balls of every one
LOW, HIGH = -18, -8
ACROSS = 200  # four of them stand in a row


@figure
def certified_bounds() -> Drawing:
    """The picture, the bound that it carries, and its true error, of every pixel of a small raster."""
    frame = symbolic(size=SIDE)
    places = ((column, row) for row in range(SIDE) for column in range(SIDE))
    off = [[float(each.upper()) for each in compared(frame, *place)[0]] for place in places]
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


_random = Random(9)
_waves = [(_random.randint(1, 6), _random.uniform(-20, 20), _random.uniform(0, 2)) for _ in range(12)]
BUMPS = {
    "orange_peel": ("v*(sin(44*pi*u + 20*pi*v) + sin(48*pi*u - 36*pi*v) + sin(12*pi*u + 60*pi*v))", 0.012),
    "golf_ball": ("max(0, sin(24*pi*u)*sin(20*pi*v) - 1/4)", 0.08),
    "bricks": ("min(1, 5*abs(sin(8*pi*u + pi*floor(10*v)/2)), 5*abs(sin(10*pi*v)))", -0.03),
    "noise": (sum(sin(pi * (2 * a * u + b * v + c)) / (a + abs(b)) for a, b, c in _waves), 0.5),
}
"""{name: (formula, β)}, as the page has them."""


def scene_of(name: str) -> Scene:
    """Return the chapter's scene with one of the bumps, without sphere B."""
    formula, beta = BUMPS[name]
    return Scene(field=HeightField(name, formula), beta=beta, ball=False)


@figure
def own_fields() -> Drawing:
    """Four bumps on sphere A, and the certified bound of each picture."""
    columns, numbers, frames = [], {}, []
    for name in BUMPS:
        fine, frame = (render(scene_of(name), side, side, bounds=True) for side in (ACROSS * FINE, ACROSS))
        bounds = difference_logarithmic(frame.bounds, LOW, HIGH)
        columns.append(np.vstack([smooth(fine), bounds]))
        frames.append(frame)
        numbers[name] = certified_numbers(frame)
    titles = tuple(name.replace("_", " ") for name in BUMPS)
    fig = panels(columns, titles, (LOW, HIGH), "bound of a channel")
    return Drawing(fig, numbers | {"side": ACROSS}, shown=frames)
