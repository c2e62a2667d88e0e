"""No NaN, infinity or warning escapes `render`: 400 scenes here, 100,000 in the committed long run."""

import numpy as np
import pytest

from renderer import Scene, exact
from tests import accepted_scenes
from tests.accepted_scenes import VARIANTS, check, check_rejected


def test_accepted_scenes():
    """Each in every field and by both models; and what is drawn is counted."""
    drawn, pixels = accepted_scenes.chunk(1, 400)
    assert drawn == 400 < pixels and len(VARIANTS) == 6


def test_one_bad_number_is_found(monkeypatch):
    """In the picture; behind the clip; and an accepted value that was to be refused."""
    frame, record = accepted_scenes.render(Scene(), 8, 8), accepted_scenes.pixel(Scene(), 8, 8, 4, 4)
    monkeypatch.setattr(accepted_scenes, "render", lambda *a, **k: frame)
    monkeypatch.setattr(accepted_scenes, "pixel", lambda *a: record)
    given = Scene(), (8, 8), exact()
    check(*given)
    good = frame.rgb[0, 0, 0]
    for value in (np.nan, np.inf, -1e-9, 1 + 1e-9):
        frame.rgb[0, 0, 0] = value
        with pytest.raises(AssertionError):
            check(*given)
    frame.rgb[0, 0, 0] = good
    object.__setattr__(record.lights[0], "mu", float("nan"))
    with pytest.raises(AssertionError):
        check(*given)
    with pytest.raises(AssertionError, match="was accepted"):
        check_rejected(Scene(), "beta", 1.0)
