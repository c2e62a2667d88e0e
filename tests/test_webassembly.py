"""The module for browsers: its bytes are those of the other machines. The simulator's own is compared on its page."""

import base64

import numpy as np
import pytest

from renderer import render
from renderer.machines import native, numpy_rows
from renderer.machines.drawing_code import arguments
from renderer.machines.webassembly import compiled_module
from tests.test_machines import SCENES, SIZE, drawn_by

WORD = 8
# Draws by a module on a memory that begins with `drawing_code.arguments`: what it is afterwards, as text.
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
    """Return a machine's `drawer` that draws in a browser's tab, in one block of memory."""

    def drawer(want, job):
        module, _ = compiled_module({"draw": want}, {}, {})
        names = arguments(want.shader.planes)

        def draw(rows):
            arrays = job | {"counts": np.zeros(len(want.shader.counted), np.int64)}
            sizes = [WORD * len(names), *(-(-array.nbytes // WORD) * WORD for array in arrays.values())]
            places = dict(zip(arrays, np.cumsum(sizes).tolist(), strict=False))
            numbers = places | {"first_row": rows.start, "last_row": rows.stop, "pitch": len(job["x"])}
            numbers["light_count"] = len(job["lights"])
            parts = [np.array([numbers.get(name, 0) for name in names]), *arrays.values()]
            block = b"".join(p.tobytes().ljust(size, b"\0") for p, size in zip(parts, sizes, strict=True))
            memory = base64.b64decode(tab.evaluate(DRAW, [base64.b64encode(part).decode() for part in (module, block)]))
            for name, array in arrays.items():
                if array.flags.writeable:
                    array[...] = np.frombuffer(memory, array.dtype, array.size, places[name]).reshape(array.shape)
            return arrays["counts"].tolist()

        return draw

    return drawer


def bytes_of(drawer, scene, method):
    """Return the bytes of all that a machine's frame with bounds holds, by name, and what it counted."""
    with drawn_by(drawer):
        frame = render(scene, *SIZE, method, threads=1, bounds=True)
    return {name: getattr(frame, name).tobytes() for name in ("rgb", "chambers", "bounds", "open")} | frame._counts


@pytest.mark.parametrize("name", SCENES)
def test_bounds_have_the_same_bytes_on_every_machine(name, browser):
    """And so have colours, chambers and what is open, to the sign of a 0; what is least and largest is among them."""
    with browser.new_page() as tab:
        by_tab = bytes_of(drawer_in(tab), *SCENES[name])
    assert by_tab == bytes_of(native.drawer, *SCENES[name]) == bytes_of(numpy_rows.drawer, *SCENES[name])
