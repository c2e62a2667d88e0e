"""A drawing's arrays as one block of memory, for code that runs elsewhere: in a browser, or on another processor."""

import numpy as np

from renderer.machines.drawing_code import arguments
from renderer.shader.shader import PLANES, WORK

WORD = 8
ARGUMENTS = arguments(PLANES)


def drawer_over_memory(run, base=0):
    """Return a machine's `drawer` that draws by run(want, memory): the block as it is afterwards, both as bytes.

    The block begins with ARGUMENTS and stands at the address `base` where the code runs.
    """

    def drawer(want, job):
        def draw(rows):
            arrays = job | {"counts": np.zeros(len(WORK), np.int64)}
            sizes = [WORD * len(ARGUMENTS), *(-(-array.nbytes // WORD) * WORD for array in arrays.values())]
            places = dict(zip(arrays, np.cumsum(sizes).tolist(), strict=False))
            given = {name: base + place for name, place in places.items()}
            given |= {"first_row": rows.start, "last_row": rows.stop, "pitch": len(job["x"])}
            given["light_count"] = len(job["lights"])
            parts = [np.array([given.get(name, 0) for name in ARGUMENTS]), *arrays.values()]
            memory = run(want, b"".join(p.tobytes().ljust(size, b"\0") for p, size in zip(parts, sizes, strict=True)))
            for name, array in arrays.items():
                if array.flags.writeable:
                    array[...] = np.frombuffer(memory, array.dtype, array.size, places[name]).reshape(array.shape)
            return arrays["counts"].tolist()

        return draw

    return drawer
