"""The module for browsers: nothing to link, the same bytes every time. What it computes is compared in a browser."""

import base64

import numpy as np
import pytest

from book import simulator_module
from renderer import Scene, central, exact, kernels, render
from renderer.machines import enclosing, native, numpy_rows
from renderer.machines.webassembly import compiled_module
from renderer.picture.views import difference_logarithmic, to_bytes
from renderer.shader.numbers import want_of
from tests.drawing_memory import drawer_over_memory
from tests.test_machines import SCENES, drawn_by
from verify.benchmark.methods.compiled import loop_of


def encoded(data: bytes) -> str:
    return base64.b64encode(data).decode()


KERNELS = {"slope": kernels.slope, "view_length": kernels.view_length}


def test_two_kernels_are_a_small_module_and_always_the_same():
    module, outputs = compiled_module({}, KERNELS, {})
    assert module.startswith(b"\0asm\1\0\0\0") and len(module) < 1000
    assert all(name.encode() in module for name in KERNELS)
    assert outputs == {"slope": 1, "view_length": 1}
    assert compiled_module({}, KERNELS, {})[0] == module


def test_what_would_need_a_linker_is_refused():
    """A browser's module would have to import libm's sine; no scene needs anything of the kind."""
    with pytest.raises(ValueError, match=r"needs a linker.*sin"):
        compiled_module({}, {"sine": lambda x: x.machine.call("sin", x)}, {})
    assert compiled_module({"draw": want_of(Scene(shininess=2.5), exact())}, {}, {})


# Runs each kernel of a module over points, given their inputs as float64: its one output, as a list of bytes.
RUN = """async ([module, arrays, points]) => {
    const decoded = text => Uint8Array.from(atob(text), c => c.charCodeAt(0)), size = 8 * points, first = 1024;
    const memory = new WebAssembly.Memory({ initial: 16 }), whole = new BigInt64Array(memory.buffer);
    const { instance } = await WebAssembly.instantiate(decoded(module), { env: { __linear_memory: memory } });
    return Object.entries(arrays).map(([name, inputs]) => {
        const given = decoded(inputs), end = first + given.length;
        new Uint8Array(memory.buffer).set(given, first);
        for (let i = 0; first + i * size <= end; i++) whole[1 + i] = BigInt(first + i * size);
        whole[0] = BigInt(points);
        instance.exports[name](0);
        return [...new Uint8Array(memory.buffer, end, size)];
    });
}"""


def test_our_functions_have_the_same_bits_on_every_machine(browser):
    """Outside their range, too."""
    rng, edges = np.random.default_rng(6), [0.0, -0.0, 5e-324, 1e-310, -1.0, np.inf, -np.inf, np.nan, 1e308, 709.1]
    numbers = np.concatenate([rng.uniform(-720, 720, 490), 2.0 ** rng.uniform(-1074, 1024, 500), edges])
    inputs = {"exp": [numbers, rng.normal(0, 1e-17, 1000)], "log": [numbers], "power": [numbers, numbers[::-1]]}
    ours = {name: getattr(kernels, name) for name in inputs}
    texts = {name: encoded(np.stack(arrays).tobytes()) for name, arrays in inputs.items()}
    with browser.new_page() as tab:
        found = tab.evaluate(RUN, [encoded(compiled_module({}, ours, {})[0]), texts, len(numbers)])
    for output, (name, kernel) in zip(found, ours.items(), strict=True):
        with np.errstate(all="ignore"):
            expected = kernel(*inputs[name])
        for bits in (np.array(output, np.uint8).view(float), loop_of(kernel, 1)(*inputs[name])[0]):
            np.testing.assert_array_equal(bits, expected, name)


# Draws by a module on a memory that begins with `drawing_code.ARGUMENTS`: what it is afterwards, as text.
DRAW = """async ([module, given]) => {
    const decoded = text => Uint8Array.from(atob(text), c => c.charCodeAt(0)), bytes = decoded(given);
    const memory = new WebAssembly.Memory({ initial: Math.ceil(bytes.length / 65536) });
    const { instance } = await WebAssembly.instantiate(decoded(module), { env: { __linear_memory: memory } });
    const whole = new Uint8Array(memory.buffer);
    whole.set(bytes);
    instance.exports.draw(0);
    let text = "";
    for (const byte of whole.subarray(0, bytes.length)) text += String.fromCharCode(byte);
    return btoa(text);
}"""


def drawer_in(tab):
    """Return a machine's `drawer` that draws in a browser's tab."""

    def run(want, memory):
        module, _ = compiled_module({"draw": want}, {}, {})
        return base64.b64decode(tab.evaluate(DRAW, [encoded(module), encoded(memory)]))

    return drawer_over_memory(run)


def bytes_of(drawer, scene, method, size=(49, 32)):
    """Return the bytes of all that a machine's frame with bounds holds, by name, and what it counted."""
    with drawn_by(drawer):
        frame = render(scene, *size, method, threads=1, bounds=True)
    planes = {"rgb": frame.rgb, "chambers": frame.chambers, "bounds": frame.bounds, "open": frame.open}
    return {name: plane.tobytes() for name, plane in planes.items()} | frame._counts


OF_MACHINES = ["central", "forward", "five_lights", "fractional_phong", "largest", "least", "tiny", "huge", "near"]
ENCLOSED = {
    "sine": (Scene(field="sine"), exact()),
    "general": (Scene(field="ridges", ku=7.3, model="phong"), exact("general")),
    "central_rings": (Scene(field="rings", shininess=7.5), central(1e-6)),
    "rings": (Scene(field="rings"), exact()),
    **{name: SCENES[name] for name in OF_MACHINES},
}


@pytest.mark.parametrize("name", ENCLOSED)
def test_bounds_have_the_same_bytes_on_every_machine(name, browser):
    """And so have colours, chambers and what is open; what is least and largest is among them."""
    with browser.new_page() as tab:
        found = bytes_of(drawer_in(tab), *ENCLOSED[name])
    assert found == bytes_of(native.drawer, *ENCLOSED[name]) == bytes_of(numpy_rows.drawer, *ENCLOSED[name])


def test_a_browser_that_bounds_otherwise_is_noticed(browser, monkeypatch):
    ours = bytes_of(numpy_rows.drawer, *ENCLOSED["sine"])
    monkeypatch.setattr(enclosing, "ROUNDING", 2.0**-52)
    with browser.new_page() as tab:
        found = bytes_of(drawer_in(tab), *ENCLOSED["sine"])
    assert [name for name in ours if ours[name] != found[name]] == ["bounds"]


def test_the_thresholds_are_where_the_renderers_bytes_change():
    """And no cell of a table has two of them, so that one comparison is enough."""
    tables = simulator_module.data({kernel.__name__: 1 for kernel in simulator_module.OVER_POINTS})["tables"]
    linear, sizes = (np.array(tables[name]["thresholds"]) for name in ("srgb", "sizes"))
    colours = np.array(tables["inferno"], np.uint32).view(np.uint8).reshape(-1, 4)[:, :3]
    for below, (of_linear, of_sizes) in enumerate(((linear, sizes), np.nextafter((linear, sizes), 0))):
        levels = np.arange(1, 256) - below
        np.testing.assert_array_equal(to_bytes(of_linear), levels)
        np.testing.assert_array_equal(difference_logarithmic(of_sizes), colours[levels])
    cells = np.floor(linear * tables["srgb"]["cells"]), sizes.view(np.int64) >> (64 - tables["sizes"]["bits"])
    assert (np.diff(cells) > 0).all()
