"""The renderer without a compiler: the kernels' definitions printed for NumPy, and every loop over pixels done at once.

A compiled kernel loops over the pixels of a row; here the index is a slice, and the loop is gone through once.
"""

import re
from pathlib import Path

from renderer.generate.files import RENDERER
from renderer.generate.printers import NumPyPrinter
from renderer.generate.source import kernels_source

LOOP = re.compile(r"for i in range\((?:np\.uint64\((?P<start>\w+)\), )?np\.uint64\((?P<stop>[\w.]+(?:\[0\])?)\)\):")
COMPILER = {
    "from numba import njit\n\nimport renderer.compiled_code  # noqa: F401  (where the compiled code is kept)\n": "",
    'inlined = njit(inline="always", error_model="numpy")\n': "\ndef inlined(function):\n    return function\n\n\n",
    'compiled = njit(cache=True, nogil=True, error_model="numpy")\n': 'compiled = np.errstate(all="ignore")\n',
    " Compiled without fast-math.": "\nNothing is compiled: `i` is a slice, and NumPy does the whole row at once.",
}
"""What is said to the compiler, and what stands there instead. A selection in NumPy computes both of its sides."""
LOOPING = ("powers.py", "shading.py")
"""The renderer's modules whose loops over pixels say for each what NumPy can say for all."""


def at_once(source):
    """Return a source with its loops over pixels as slices. Raises ValueError if one of them has another form."""

    def sliced(loop):
        return f"for i in (slice({loop['start'] or 0}, {loop['stop']}),):"

    text = LOOP.sub(sliced, source)
    if "np.uint64" in text:
        raise ValueError(f"{text[text.index('np.uint64') :].splitlines()[0]!r} is not allowed: a loop over pixels `i`")
    return text


def array_kernels():
    """Return the text of `renderer/kernels.py` for NumPy. Raises ValueError if what is replaced is not there once."""
    text = kernels_source(NumPyPrinter())
    for said, instead in COMPILER.items():
        if text.count(said) != 1:
            raise ValueError(f"{said!r} is not allowed to stand {text.count(said)} times in the kernels' text: once")
        text = text.replace(said, instead)
    return at_once(text)


def without_compiler():
    """Return {path from the project's root: text}: what the renderer's own files are replaced by without Numba."""
    sources = {f"renderer/{name}": at_once((RENDERER / name).read_text(encoding="utf-8")) for name in LOOPING}
    arrays = Path(__file__).with_name("arrays.py").read_text(encoding="utf-8")
    return {"renderer/kernels.py": array_kernels(), "renderer/arrays.py": arrays, **sources}
