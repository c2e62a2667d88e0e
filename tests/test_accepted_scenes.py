"""No NaN, infinity or warning escapes `render`: 400 scenes here, 100,000 in the committed long run."""

import numpy as np
import pytest
from hypothesis import given, settings

from renderer import Scene, exact
from tests import accepted_scenes
from tests.accepted_scenes import VARIANTS, check, check_rejected
from tests.strategies import methods, rasters, scenes


@settings(max_examples=400)
@given(scenes(), rasters(10), methods)
def test_accepted_scenes(scene, size, method):
    check(scene, size, method)


def test_a_chunk_counts_what_it_does():
    drawn, pixels = accepted_scenes.chunk(1, 5)
    assert 1 <= drawn <= 5 < pixels
    assert len(VARIANTS) == 6


def test_one_bad_number_is_found(monkeypatch):
    """In the picture; behind the clip; and an accepted value that was to be refused."""
    frame, record = accepted_scenes.render(Scene(), 8, 8), accepted_scenes.pixel(Scene(), 8, 8, 4, 4)
    monkeypatch.setattr(accepted_scenes, "render", lambda *a, **k: frame)
    monkeypatch.setattr(accepted_scenes, "pixel", lambda *a: record)
    check(Scene(), (8, 8), exact())
    good = frame.rgb[0, 0, 0]
    for value in (np.nan, np.inf, -1e-9, 1 + 1e-9):
        frame.rgb[0, 0, 0] = value
        with pytest.raises(AssertionError):
            check(Scene(), (8, 8), exact())
    frame.rgb[0, 0, 0] = good
    object.__setattr__(record.lights[0], "mu", float("nan"))
    with pytest.raises(AssertionError):
        check(Scene(), (8, 8), exact())
    with pytest.raises(AssertionError, match="was accepted"):
        check_rejected(Scene(), "beta", 1.0)
