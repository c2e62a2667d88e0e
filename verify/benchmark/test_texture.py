"""Every way to the normal finds it, and the compiled fetch is NumPy's."""

import numpy as np
import pytest

from renderer import exact
from verify.accuracy.frontiers import normal_map
from verify.benchmark import texture

OFF = {"algebraic": 1e-13, "exact": 1e-14, "central": 1e-4, "map_small": 0.1, "map_large": 2e-3,
       "height_derivative": 0.5, "height_difference": 2e-3}  # fmt: skip
"""{way: how far from N' it may be}: rounding, a difference's truncation, the texels."""


@pytest.fixture(scope="module")
def right():
    return normal_map.tangent_normal(texture.SCENE, *texture.points()[0], exact())


def test_no_way_is_left_out():
    assert texture.ways().keys() == OFF.keys()


@pytest.mark.parametrize("name", OFF)
def test_every_way_finds_the_normal(name, right):
    function, at = texture.ways()[name]
    found = np.array(function(*at))
    off = normal_map.apart(found, right).max()
    assert off < OFF[name]
    assert off > OFF[name] / 100 or name in ("algebraic", "exact")  # a difference and a table are no exact way
    assert normal_map.apart(np.roll(found, 1, axis=1), right).max() > 0.5


def test_the_compiled_fetch_is_that_of_numpy():
    chart = texture.points()[0]
    map_ = normal_map.baked(texture.SCENE, texture.SMALL, exact())
    found = np.array(texture.ways()["map_small"][0](*chart))
    assert normal_map.apart(found, normal_map.fetched(map_, *chart)).max() < 2.0**-23  # texels are float32
