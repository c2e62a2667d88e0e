"""What displacement moves: the shadow's edge as the grazed height says, the outline; and the order."""

import numpy as np
import pytest

from renderer import Scene, render
from verify.accuracy.frontiers import boundaries
from verify.accuracy.frontiers.fiction import silhouette_remainders
from verify.accuracy.orders import fitted_slope

LIGHTS = [np.array(light.position) for light in boundaries.SCENE.lights]
BETAS = np.logspace(-3, -2, 4)


def test_the_shadow_moves_in_first_order_and_the_height_says_how_far():
    for light in LIGHTS:
        moved, left = boundaries.shadow_remainders(BETAS, light)
        assert fitted_slope(BETAS, moved) == pytest.approx(1, abs=0.05)
        assert fitted_slope(BETAS, left) == pytest.approx(2, abs=0.1)


def test_the_height_of_another_place_does_not_say_it(monkeypatch):
    right = boundaries.grazed_height
    monkeypatch.setattr(boundaries, "grazed_height", lambda *given: -right(*given))
    _, left = boundaries.shadow_remainders(BETAS, LIGHTS[0])
    assert fitted_slope(BETAS, left) == pytest.approx(1, abs=0.1)


def test_the_outline_is_the_fictions():
    azimuths, beta = 2 * np.pi * np.arange(96) / 96 - np.pi, 0.01
    moved, flat = (boundaries.outline(boundaries.SCENE, azimuths, amplitude) for amplitude in (beta, 0.0))
    assert np.abs(moved - flat).max() == pytest.approx(silhouette_remainders([beta])[0][0], rel=1e-3)


def test_without_amplitude_the_order_is_the_renderers():
    for scene in (boundaries.SCENE, Scene()):
        np.testing.assert_array_equal(boundaries.first_surface(scene, 0.0, 64), render(scene, 64, 64).chambers & 3)
