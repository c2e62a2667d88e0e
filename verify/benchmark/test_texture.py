"""Every way to the normal finds it."""

import numpy as np

from renderer import exact
from verify.accuracy.frontiers import normal_map
from verify.benchmark import texture

OFF = {"algebraic": 1e-13, "exact": 1e-14, "central": 1e-4, "map_small": 0.1, "map_large": 2e-3,
       "height_derivative": 0.5, "height_difference": 2e-3}  # fmt: skip
"""{way: how far from N' it may be}: rounding, a difference's truncation, the texels."""


def test_every_way_finds_the_normal_and_the_compiled_fetch_is_that_of_numpy():
    chart, ways = texture.points()[0], texture.ways()
    assert ways.keys() == OFF.keys()
    right = normal_map.tangent_normal(texture.SCENE, *chart, exact())
    found = {name: np.array(function(*at)) for name, (function, at) in ways.items()}
    for name, most in OFF.items():
        off = normal_map.apart(found[name], right).max()
        assert off < most, name
        assert off > most / 100 or name in ("algebraic", "exact")  # a difference and a table are no exact way
        assert normal_map.apart(np.roll(found[name], 1, axis=1), right).max() > 0.5
    fetched = normal_map.fetched(normal_map.baked(texture.SCENE, texture.SMALL, exact()), *chart)
    assert normal_map.apart(found["map_small"], fetched).max() < 2.0**-23  # texels are float32
