"""No NaN, infinity or warning escapes `render`: 400 scenes here, 100,000 in the committed long run."""

import numpy as np
import pytest
from hypothesis import given, settings

from renderer import Scene, central, exact
from tests import accepted_scenes
from tests.accepted_scenes import VARIANTS, check, check_behind_the_clip, check_rejected
from tests.strategies import methods, rasters, scenes


@settings(max_examples=400)
@given(scenes(), rasters(10), methods)
def test_accepted_scenes(scene, size, method):
    check(scene, size, method)


def test_a_chunk_counts_what_it_does():
    drawn, pixels = accepted_scenes.chunk(1, 5)
    assert 1 <= drawn <= 5 < pixels
    assert len(VARIANTS) == 6


@pytest.mark.parametrize("value", [np.nan, np.inf, -1e-9, 1 + 1e-9])
def test_one_bad_number_is_found(monkeypatch, value):
    frame = accepted_scenes.render(Scene(), 8, 8)
    frame.rgb[0, 0, 0] = value
    monkeypatch.setattr(accepted_scenes, "render", lambda *a, **k: frame)
    with pytest.raises(AssertionError):
        check(Scene(), (8, 8), exact())


def test_a_bad_number_behind_the_clip_is_found(monkeypatch):
    record = accepted_scenes.pixel(Scene(), 8, 8, 4, 4, central(1e-3))
    object.__setattr__(record.lights[0], "mu", float("nan"))
    monkeypatch.setattr(accepted_scenes, "pixel", lambda *a: record)
    with pytest.raises(AssertionError):
        check_behind_the_clip(Scene(), (8, 8), exact(), np.array([[4, 4]]))


def test_an_accepted_value_is_no_rejection():
    with pytest.raises(AssertionError, match="was accepted"):
        check_rejected(Scene(), "beta", 1.0)
