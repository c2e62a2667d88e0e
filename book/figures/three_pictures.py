"""The chapter's pictures: the front page's, numeric beside symbolic and their difference, and the views of a frame."""

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import panels
from book.figures.chapter_scene import FIELD_NAMES, FINE, SCENE, TELLING_EPS, averaged, numeric, symbolic
from renderer import central, exact, render, stage_of
from renderer.picture.sweep import difference_on_a, rms
from renderer.picture.views import difference_logarithmic, image_view, kink_view, slope_view, to_bytes

LOW, HIGH = -8, 0
SIDE, VIEW_SIDE = 264, 220
WIDTH, HEIGHT, HERO_EPS = 928, 420, 2e-2
SEAM = 2  # pixels of paper between the halves
GAP = 12
TITLES = ("numeric", "symbolic", "difference")


def _three(field, size):
    delta = numeric(field, size).rgb - symbolic(field, size).rgb
    fine = (averaged(image_view(frame(field, size * FINE))) for frame in (numeric, symbolic))
    return *fine, difference_logarithmic(delta, LOW, HIGH)


def _column(pictures):
    """Return pictures one above another, with a gap that lets the page through: (…, width, 4)."""
    width = pictures[0].shape[1]
    opaque = [np.dstack([p, np.full(p.shape[:2], 255, np.uint8)]) for p in pictures]
    gap = np.zeros((GAP, width, 4), np.uint8)
    return np.concatenate([part for p in opaque for part in (p, gap)][:-1])


@figure("three_pictures")
def three_pictures() -> Drawing:
    """Ridges by central differences, exactly, and the difference on a logarithmic scale."""
    fig = panels(_three("ridges", SIDE), TITLES, bar=(LOW, HIGH), bar_label="largest |ΔI| of a channel")
    delta = difference_on_a(numeric("ridges", SIDE), symbolic("ridges", SIDE))
    numbers = {"eps": TELLING_EPS, "largest": np.abs(delta).max(), "rms": rms(delta), "side": SIDE}
    whole = numeric("ridges", SIDE).rgb - symbolic("ridges", SIDE).rgb
    return Drawing(fig, numbers=numbers, data={"largest_of_a_channel": np.abs(whole).max(axis=2)})


@figure("contact_sheet")
def contact_sheet() -> Drawing:
    """Sine, ridges and rings, from the top: numeric, symbolic, difference."""
    rows = [_three(field, SIDE) for field in FIELD_NAMES]
    columns = [_column([row[column] for row in rows]) for column in range(3)]
    fig = panels(columns, TITLES, bar=(LOW, HIGH), bar_label="largest |ΔI| of a channel")
    numbers = {"eps": TELLING_EPS}
    for field in FIELD_NAMES:
        delta = difference_on_a(numeric(field, SIDE), symbolic(field, SIDE))
        numbers |= {f"{field}_rms": rms(delta), f"{field}_largest": np.abs(delta).max()}
    return Drawing(fig, numbers=numbers)


@figure("views")
def views() -> Drawing:
    """The symbolic picture of ridges, its slope, its kink flags, and the pixels whose difference straddles."""
    fine, fine_step = symbolic("ridges", VIEW_SIDE * FINE), numeric("ridges", VIEW_SIDE * FINE)
    straddling = np.where(fine_step.straddling[..., None], np.uint8(255), image_view(fine) // 3)
    pictures = [image_view(fine), slope_view(fine), kink_view(fine), straddling]
    pictures = [averaged(np.dstack([picture] * 3) if picture.ndim == 2 else picture) for picture in pictures]
    fig = panels(pictures, ("image", "slope |∇h|", "kink flag", "straddling"))
    frame, stepped = symbolic("ridges", VIEW_SIDE), numeric("ridges", VIEW_SIDE)
    on_a = int(frame.stage.on_a.sum())
    numbers = {
        "eps": stepped.method.eps,
        "steepest": frame.slope.max(),
        "kink_share": frame.kink.sum() / on_a,
        "straddling_share": stepped.straddling.sum() / on_a,
    }
    data = {"slope": frame.slope, "kink": frame.kink, "straddling": stepped.straddling}
    return Drawing(fig, numbers=numbers, data=data)


@figure("hero")
def hero() -> Drawing:
    """The default scene, by central differences on the left of the middle and exactly on the right."""
    stage = stage_of(SCENE, WIDTH, HEIGHT)
    left = to_bytes(render(SCENE, WIDTH, HEIGHT, central(HERO_EPS), stage=stage).rgb)
    right = to_bytes(render(SCENE, WIDTH, HEIGHT, exact(), stage=stage).rgb)
    picture = np.where(np.arange(WIDTH)[None, :, None] < WIDTH // 2, left, right)
    picture[:, WIDTH // 2 - SEAM // 2 : WIDTH // 2 + SEAM // 2] = 252
    return Drawing(picture, numbers={"eps": HERO_EPS})
