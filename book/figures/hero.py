"""The picture on the front page."""

import numpy as np

from book.drawing.registry import Drawing, figure
from renderer import Scene, central, exact, render, stage_of
from renderer.views import to_bytes

WIDTH, HEIGHT, EPS = 928, 420, 2e-2
SEAM = 2  # pixels of paper between the halves


@figure("hero")
def hero() -> Drawing:
    """The default scene, by central differences on the left of the middle and exactly on the right."""
    scene = Scene()
    stage = stage_of(scene, WIDTH, HEIGHT)
    left = to_bytes(render(scene, WIDTH, HEIGHT, central(EPS), stage=stage).rgb)
    right = to_bytes(render(scene, WIDTH, HEIGHT, exact(), stage=stage).rgb)
    picture = np.where(np.arange(WIDTH)[None, :, None] < WIDTH // 2, left, right)
    picture[:, WIDTH // 2 - SEAM // 2 : WIDTH // 2 + SEAM // 2] = 252
    return Drawing(picture, numbers={"eps": EPS})
