"""The module for browsers: its bytes are those of the other machines. The simulator's own is compared on its page."""

import base64

import pytest

from renderer import render
from renderer.machines import enclosing, native, numpy_rows
from renderer.machines.webassembly import compiled_module
from tests.drawing_memory import drawer_over_memory
from tests.test_machines import SCENES, SIZE, drawn_by

# Draws by a module on a memory that begins with `drawing_memory.ARGUMENTS`: what it is afterwards, as text.
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
        return base64.b64decode(tab.evaluate(DRAW, [base64.b64encode(part).decode() for part in (module, memory)]))

    return drawer_over_memory(run)


def bytes_of(drawer, scene, method):
    """Return the bytes of all that a machine's frame with bounds holds, by name, and what it counted."""
    with drawn_by(drawer):
        frame = render(scene, *SIZE, method, threads=1, bounds=True)
    return {name: getattr(frame, name).tobytes() for name in ("rgb", "chambers", "bounds", "open")} | frame._counts


@pytest.mark.parametrize("name", SCENES)
def test_bounds_have_the_same_bytes_on_every_machine(name, browser):
    """And so have colours, chambers and what is open, to the sign of a 0; what is least and largest is among them."""
    with browser.new_page() as tab:
        found = bytes_of(drawer_in(tab), *SCENES[name])
    assert found == bytes_of(native.drawer, *SCENES[name]) == bytes_of(numpy_rows.drawer, *SCENES[name])


def assert_noticed(drawer):
    """Hold a drawer to this: where it bounds otherwise, its bounds have other bytes, and nothing else has."""
    ours = bytes_of(numpy_rows.drawer, *SCENES["sine"])
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(enclosing, "ROUNDING", 2.0**-52)
        found = bytes_of(drawer, *SCENES["sine"])
    assert [name for name in ours if ours[name] != found[name]] == ["bounds"]


def test_a_browser_that_bounds_otherwise_is_noticed(browser):
    with browser.new_page() as tab:
        assert_noticed(drawer_in(tab))
