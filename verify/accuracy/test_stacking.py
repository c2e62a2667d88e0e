"""A mean over a lamp is as systematic as one sample."""

from renderer import Scene
from verify.accuracy.stacking import stacked


def test_a_mean_does_not_heal_a_difference():
    """A difference's error has one sign over a lamp; as noise the mean of 16 points would be a quarter."""
    one, many = (stacked(Scene(field="sine"), lamp=lamp, side=64).rms.value for lamp in (1, 4))
    assert 0.9 < many / one < 1
