"""What displacement moves: the shadow's edge is a true edge, and moves as the grazed height says; and the order."""

from dataclasses import replace

import numpy as np
import pytest

from renderer import Scene, render
from verify.accuracy.frontiers import boundaries
from verify.accuracy.frontiers.fiction import silhouette_remainders
from verify.accuracy.orders import fitted_slope

SCENE = boundaries.SCENE
LIGHTS = [np.array(light.position) for light in SCENE.lights]
BETAS = np.logspace(-3, -2, 4)


@pytest.mark.parametrize("light", LIGHTS, ids=["first", "second"])
def test_the_shadow_moves_in_first_order_and_the_height_says_how_far(light):
    moved, left = boundaries.shadow_remainders(BETAS, light)
    assert fitted_slope(BETAS, moved) == pytest.approx(1, abs=0.05)
    assert fitted_slope(BETAS, left) == pytest.approx(2, abs=0.1)


def test_the_height_of_another_place_does_not_say_it(monkeypatch):
    right = boundaries.grazed_height
    monkeypatch.setattr(boundaries, "grazed_height", lambda *given: -right(*given))
    _, left = boundaries.shadow_remainders(BETAS, LIGHTS[0])
    assert fitted_slope(BETAS, left) == pytest.approx(1, abs=0.1)


@pytest.mark.parametrize("beta", [0.0, 0.02, 0.1])
def test_an_edge_has_light_on_one_side_and_shadow_on_the_other(beta):
    """By points of the ray, without any halving."""
    light, azimuths = LIGHTS[0], boundaries.away_from(LIGHTS[0], 9)
    found = boundaries.edge(SCENE, light, azimuths, beta)
    for off, is_dark in ((-1e-3, True), (1e-3, False)):
        floor = (found + off) * np.array([np.cos(azimuths), np.sin(azimuths), 0 * azimuths])
        ray = floor[..., None] + np.linspace(0, 1, 20_001) * (light[:, None] - floor)[..., None]
        assert ((boundaries.above(SCENE, beta, ray) < 0).any(axis=-1) == is_dark).all()


def test_without_amplitude_the_edge_is_the_renderers():
    """The floor's pixels that A hides from a light are those within the smooth edge."""
    frame = render(replace(SCENE, ball=False), 96, 96)
    x, y = np.meshgrid(frame.stage.x, frame.stage.y)
    azimuth, chambers = np.arctan2(y, x), frame.chambers
    for number, light in enumerate(LIGHTS):
        away = np.cos(azimuth - np.arctan2(-light[1], -light[0])) > np.cos(boundaries.SPREAD)
        seen = away & (chambers & 3 == 3)
        dark = np.hypot(x, y) < boundaries.smooth_edge(light, azimuth)[0]
        np.testing.assert_array_equal(dark[seen], (chambers[seen] >> (2 + number) & 1).astype(bool))
        assert dark[seen].any() and not dark[seen].all()


def test_the_outline_is_the_fictions():
    azimuths, beta = 2 * np.pi * np.arange(96) / 96 - np.pi, 0.01
    moved = boundaries.outline(SCENE, azimuths, beta) - boundaries.outline(SCENE, azimuths, 0.0)
    assert np.abs(moved).max() == pytest.approx(silhouette_remainders([beta])[0][0], rel=1e-3)


def test_the_order_is_the_renderers_without_amplitude_and_another_with_it():
    for scene in (SCENE, Scene()):
        plain = boundaries.first_surface(scene, 0.0, 64)
        np.testing.assert_array_equal(plain, render(scene, 64, 64).chambers & 3)
        changed = [np.count_nonzero(boundaries.first_surface(scene, beta, 64) != plain) for beta in (0.05, 0.1)]
        assert 0 < changed[0] < changed[1]
