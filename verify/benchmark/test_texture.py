"""Every way to the normal finds it, the compiled fetch is NumPy's, and the kept numbers say what they were made of.

No time is asserted.
"""

import json

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


@pytest.mark.parametrize("name", texture.ways())
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


def test_a_ratio_is_taken_round_by_round():
    """A round in which the machine is ten times slower, or a call that is interrupted, leaves the ratio as it was."""
    fast = np.repeat([1.0, 1.0, 10.0, 1.0, 1.0], texture.CALLS)
    slow = 2 * fast
    slow[1] = 50.0
    seconds = dict.fromkeys(texture.ways(), fast) | {"central": slow}
    numbers = texture.numbers_of(seconds, 1)
    assert [numbers[f"central_to_exact{end}"] for end in ("_low", "", "_high")] == pytest.approx([2, 2, 2])
    numbers = texture.numbers_of(seconds | {"central": slow * np.repeat([1, 2, 3, 4, 5], texture.CALLS)}, 1)
    assert [numbers[f"central_to_exact{end}"] for end in ("_low", "", "_high")] == pytest.approx([4, 6, 8])


def test_the_kept_ratios_lie_between_their_quartiles():
    result = json.loads((texture.RESULTS / "texture.json").read_text(encoding="utf-8"))
    numbers = result["numbers"]
    assert {"machine", "date", "commit"} <= result["label"].keys() and numbers["load"] >= 0
    assert {f"{name}_ns" for name in texture.ways()} <= numbers.keys()
    for name in (*texture.RATIOS, *(f"{way}_ns" for way in texture.ways())):
        assert 0 < numbers[f"{name}_low"] <= numbers[name] <= numbers[f"{name}_high"]


def test_a_small_run_writes_what_it_measured(tmp_path):
    texture.main(["--rounds", "2", "--output", str(tmp_path)])
    numbers = json.loads((tmp_path / "texture.json").read_text(encoding="utf-8"))["numbers"]
    assert numbers["rounds"] == 2 and numbers["points"] == len(texture.points()[0][0])
