"""The module for browsers: nothing to link, the same bytes every time. What it computes is compared in a browser."""

from dataclasses import replace

import numpy as np
import pytest

from book import simulator_module
from renderer import Scene, exact, kernels
from renderer.machines.webassembly import compiled_module
from renderer.picture.views import difference_logarithmic, to_bytes
from renderer.shader.numbers import want_of

KERNELS = {"slope": kernels.slope, "view_length": kernels.view_length}


def test_two_kernels_are_a_small_module_and_always_the_same():
    module, outputs = compiled_module({}, KERNELS, {})
    assert module.startswith(b"\0asm\1\0\0\0") and len(module) < 1000
    assert all(name.encode() in module for name in KERNELS)
    assert outputs == {"slope": 1, "view_length": 1}
    assert compiled_module({}, KERNELS, {})[0] == module


def test_what_would_need_a_linker_is_refused():
    """A shininess that is not whole needs pow, which a browser's module would have to import."""
    scene = replace(Scene(), shininess=2.5)
    with pytest.raises(ValueError, match=r"needs a linker.*pow"):
        compiled_module({"draw": want_of(scene, exact())}, {}, {})


def test_the_thresholds_are_where_the_renderers_bytes_change():
    """And no cell of a table has two of them, so that one comparison is enough."""
    tables = simulator_module.data({kernel.__name__: 1 for kernel in simulator_module.OVER_POINTS})["tables"]
    linear, sizes = (np.array(tables[name]["thresholds"]) for name in ("srgb", "sizes"))
    levels = np.arange(1, 256)
    np.testing.assert_array_equal(to_bytes(linear), levels)
    np.testing.assert_array_equal(to_bytes(np.nextafter(linear, 0)), levels - 1)
    colours = np.array(tables["inferno"], np.uint32).view(np.uint8).reshape(-1, 4)[:, :3]
    np.testing.assert_array_equal(difference_logarithmic(sizes), colours[levels])
    np.testing.assert_array_equal(difference_logarithmic(np.nextafter(sizes, 0)), colours[levels - 1])
    cells = np.floor(linear * tables["srgb"]["cells"]), sizes.view(np.int64) >> (64 - tables["sizes"]["bits"])
    assert all((np.diff(cell) > 0).all() for cell in cells)


def test_every_field_way_and_model_has_its_number():
    data = simulator_module.data(dict.fromkeys((kernel.__name__ for kernel in simulator_module.OVER_POINTS), 1))
    ways = [number for field in data["fields"].values() for way, number in field["ways"].items() if way != "flat"]
    flat = {field["ways"]["flat"] for field in data["fields"].values()}
    assert sorted([*ways, *flat]) == list(range(len(simulator_module.WAYS)))
    assert [model["index"] for model in data["models"].values()] == list(range(len(kernels.LIGHT_MODELS)))
    assert data["models"]["blinn"]["power"] == 16 and data["models"]["phong"]["power"] == 32
    assert [data["fields"][name]["creases"] for name in ("sine", "ridges", "rings")] == [0, 2, 0]
    assert len(data["scenes"]) == 2 ** (1 + len(Scene().lights))
