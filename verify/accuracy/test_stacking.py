"""A mean over a lamp or a pixel: within the mean of the bounds, of the same chambers, as systematic as one sample."""

import numpy as np
import pytest

from renderer import Light, Scene, central, exact, render
from verify.accuracy import stacking
from verify.accuracy.stacking import stacked

SIDE = 64
SINE = Scene(field="sine")


@pytest.mark.parametrize("scene", [SINE, Scene()], ids=["sine", "ridges"])
@pytest.mark.parametrize("samples", [{"lamp": 4}, {"pixel": 3}, {"lamp": 2, "pixel": 2}], ids=str)
def test_a_mean_keeps_the_bound_and_moves_no_boundary(scene, samples):
    mean = stacked(scene, **samples, side=SIDE)
    assert 0 < mean.of_the_bound <= 1
    assert mean.flips == 0 and mean.on_a.any()


def test_a_bound_without_the_highlight_is_exceeded(monkeypatch):
    """The check can fail: k_s p is most of L."""
    monkeypatch.setattr(stacking, "steepest", lambda scene: np.array(scene.albedo_a) * scene.kd / 8)
    assert stacked(SINE, lamp=2, side=SIDE).of_the_bound > 1


def test_one_point_is_the_plain_pair_of_pictures():
    one = stacked(SINE, side=SIDE)
    numeric, symbolic = (render(SINE, SIDE, SIDE, method).rgb for method in (central(stacking.EPS), exact()))
    assert (one.difference == numeric - symbolic).all() and (one.picture == symbolic).all()


def test_a_mean_does_not_heal_a_difference():
    """What a difference is off by has one sign over a lamp: were it noise, 16 points would leave a quarter."""
    one, many = (stacked(SINE, lamp=lamp, side=SIDE).rms.value for lamp in (1, 4))
    assert 0.9 < many / one < 1


def test_the_rms_is_enclosed():
    """Where every sample is moved as far as it may be, to one side, it is still between the ends; 1e-6 more is not."""
    mean = stacked(SINE, lamp=2, side=SIDE)
    moved = mean._replace(difference=mean.difference + np.sign(mean.difference) * mean.within)
    assert mean.rms.lower < mean.rms.value < moved.rms.value <= mean.rms.upper < mean.rms.value * (1 + 1e-6)


def test_a_lamp_is_spread_about_its_light():
    points = np.array([light.position for light in stacking.lamp_points(Light((1.0, 2.0, 3.0)), 4)])
    np.testing.assert_allclose(points.mean(axis=0), (1, 2, 3))
    np.testing.assert_allclose(np.ptp(points, axis=0) / stacking.HALF, (1.5, 1.5, 0))


def test_mirrored_rays_part_with_the_pipelines_and_not_without_a_bump():
    """So a lobe of reflected directions is no mean of this kind."""
    apart, pixels = stacking.mirrors_apart(Scene(), SIDE)
    assert 0.02 < apart / pixels < 0.12
    assert stacking.mirrors_apart(Scene(beta=0.0), SIDE) == (0, pixels)
    assert {*stacking.mirrored(Scene(), render(Scene(), SIDE, SIDE).planes_on_a)} == {*range(5)}
