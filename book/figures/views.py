"""The views of one frame: picture, slope, kinks, straddling pixels."""

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import panels
from book.figures.chapter_scene import numeric, symbolic
from renderer.views import image_view, kink_view, slope_view

SIDE = 220


@figure("views")
def views() -> Drawing:
    """The symbolic picture of ridges, its slope, its kink flags, and the pixels whose difference straddles."""
    frame, stepped = symbolic("ridges", SIDE), numeric("ridges", SIDE)
    straddling = np.where(stepped.straddling[..., None], np.uint8(255), image_view(frame) // 3)
    pictures = [image_view(frame), slope_view(frame), kink_view(frame), straddling]
    fig = panels(pictures, ("image", "slope |∇h|", "kink flag", "straddling"))
    on_a = int(frame.stage.on_a.sum())
    numbers = {
        "eps": stepped.method.eps,
        "steepest": frame.slope.max(),
        "kink_share": frame.kink.sum() / on_a,
        "straddling_share": stepped.straddling.sum() / on_a,
    }
    data = {"slope": frame.slope, "kink": frame.kink, "straddling": stepped.straddling}
    return Drawing(fig, numbers=numbers, data=data)
