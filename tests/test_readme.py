"""The README's picture is what the renderer draws today."""

import numpy as np
from PIL import Image

from book.figures.three_pictures import hero, hero_symbolic
from verify.sources import ROOT


def test_picture_is_the_renderers():
    committed = np.asarray(Image.open(ROOT / "book/static/front.png").convert("RGB")).astype(int)
    drawn = hero().picture.astype(int)
    middle = drawn.shape[1] // 2
    drawn[:, middle:] = hero_symbolic().picture[:, middle:]
    assert committed.shape == drawn.shape
    assert np.abs(committed - drawn).max() <= 1  # a byte may round the other way


def test_is_short_enough_to_read():
    assert len((ROOT / "README.md").read_text(encoding="utf-8").splitlines()) < 120
