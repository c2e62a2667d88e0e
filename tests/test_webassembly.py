"""The module for browsers: nothing to link, the same bytes every time. What it computes is compared in a browser."""

from dataclasses import replace

import pytest

from book import simulator_module
from renderer import Scene, exact, kernels
from renderer.machines.webassembly import compiled_module
from renderer.numbers import want_of

KERNELS = {"slope": kernels.slope, "view_length": kernels.view_length}


def test_two_kernels_are_a_small_module_and_always_the_same():
    module, outputs = compiled_module({}, KERNELS)
    assert module.startswith(b"\0asm\1\0\0\0") and len(module) < 1000
    assert all(name.encode() in module for name in KERNELS)
    assert outputs == {"slope": 1, "view_length": 1}
    assert compiled_module({}, KERNELS)[0] == module


def test_what_would_need_a_linker_is_refused():
    """A shininess that is not whole needs pow, which a browser's module would have to import."""
    scene = replace(Scene(), shininess=2.5)
    with pytest.raises(ValueError, match=r"needs a linker.*pow"):
        compiled_module({"draw": want_of(scene, exact())}, {})


def test_every_field_way_and_model_has_its_number():
    data = simulator_module.data(dict.fromkeys((kernel.__name__ for kernel in simulator_module.OVER_POINTS), 1))
    ways = [number for field in data["fields"].values() for way, number in field["ways"].items() if way != "flat"]
    flat = {field["ways"]["flat"] for field in data["fields"].values()}
    assert sorted([*ways, *flat]) == list(range(len(simulator_module.WAYS)))
    assert [model["index"] for model in data["models"].values()] == list(range(len(kernels.LIGHT_MODELS)))
    assert data["models"]["blinn"]["power"] == 16 and data["models"]["phong"]["power"] == 32
    assert data["fields"]["ridges"]["creases"] == [["u", 1.0, 0.0], ["v", 0.0, 1.0]]
    assert len(data["scenes"]) == 2 ** (1 + len(Scene().lights))
