"""The maps of accuracy, and what the attribution of an error adds up to."""

import numpy as np
import pytest

from renderer import Scene
from verify.stability import attribution, maps

SCENE = Scene()
POINTS = np.random.default_rng(12).uniform(0.02, 0.98, (2, 150))


def test_over_the_chart_ours_is_right_to_the_last_places():
    """Ours ≤ 16 roundings of h_u itself, wherever, and 0 on a crease; the seed's form misses those zeros altogether."""
    found = maps.over_the_chart(side=64)
    assert found["ours"].max() <= 16
    assert found["seed"].max() == maps.MISSED_ZERO


def test_over_the_image_nothing_is_lost_off_the_rim():
    """8(1 + k) = 72 roundings are allowed where 1 − (ρ/ρ_s)² ≥ 0.1, that is within 0.94 ρ_s."""
    found = maps.over_the_image(size=40, reach=0.66)
    assert np.nanmax(found["ours"]) <= 72
    assert maps.summary(found["seed"])[1] > maps.summary(found["ours"])[1] + 5


def test_each_step_has_its_own_term():
    kinds = {eps: attribution.shares(attribution.dominant(SCENE, *POINTS, eps)) for eps in (0.06, 1e-4, 1e-9)}
    assert kinds[0.06]["straddling"] > 0.5
    assert kinds[1e-4]["truncation"] > 0.95
    assert kinds[1e-9]["argument rounding"] + kinds[1e-9]["roundoff"] == pytest.approx(1)


def test_at_the_pole_the_step_is_one_sided():
    """v < ε: the crease in reach is the end of the chart, and no sample lies beyond it."""
    kinds = attribution.dominant(SCENE, np.full(5, 0.07), np.linspace(1e-3, 9e-3, 5), 1e-2)
    assert (kinds == attribution.TERMS.index("one-sided")).all()
