"""A mean over a lamp: a bound of it can be exceeded, and it is as systematic as one sample."""

import numpy as np

from renderer import Scene
from verify.accuracy import stacking
from verify.accuracy.stacking import stacked

SIDE = 64
SINE = Scene(field="sine")


def test_a_bound_without_the_highlight_is_exceeded(monkeypatch):
    """The check can fail: without k_s p, most of L, the bound is exceeded."""
    monkeypatch.setattr(stacking, "steepest", lambda scene: np.array(scene.albedo_a) * scene.kd / 8)
    assert stacked(SINE, lamp=2, side=SIDE).of_the_bound > 1


def test_a_mean_does_not_heal_a_difference():
    """A difference's error has one sign over a lamp; as noise the mean of 16 points would be a quarter."""
    one, many = (stacked(SINE, lamp=lamp, side=SIDE).rms.value for lamp in (1, 4))
    assert 0.9 < many / one < 1
