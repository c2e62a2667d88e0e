"""Every way to the normal finds it."""

import numpy as np

from renderer import exact
from verify.accuracy.frontiers import normal_map
from verify.benchmark import texture

OFF = {"algebraic": 1e-13, "exact": 1e-14, "central": 1e-4, "map_small": 0.1, "map_large": 2e-3,
       "height_derivative": 0.5, "height_difference": 2e-3}  # fmt: skip
"""{way: how far from N' it may be}: rounding, a difference's truncation, the texels."""


def test_every_way_finds_the_normal():
    right = normal_map.tangent_normal(texture.SCENE, *texture.points()[0], exact())
    ways = texture.ways()
    assert ways.keys() == OFF.keys()
    for name, (function, at) in ways.items():
        found = np.array(function(*at))
        off = normal_map.apart(found, right).max()
        assert off < OFF[name], name
        assert off > OFF[name] / 100 or name in ("algebraic", "exact")  # a difference and a table are no exact way
        assert normal_map.apart(np.roll(found, 1, axis=1), right).max() > 0.5
