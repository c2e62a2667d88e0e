"""The machines that run the shader: LLVM's vectors where llvmlite is installed, NumPy's arrays elsewhere; same bits.

What is drawn on, a job, is a dict of arrays: `scene` and `lights`, the numbers of these; `x`, image points as many as a
plane's row is long, NaN beyond the raster's last column, and `y`, one of each row; `columns`, (rows, 2) int64, which
columns of each row are looked at; the frame's planes by name, (rows, columns of x), float64, the chamber code `code`
uint8. Where bounds are wanted, `x_bound`, `y_bound` and `scene_bounds` are those of the errors of x, y and scene.
"""

import os
from functools import cache
from threading import RLock
from types import ModuleType

import numpy as np

Job = dict[str, np.ndarray]
compiling = RLock()
if hasattr(os, "register_at_fork"):  # else a child that began while another thread compiles, or imports what does so,
    release = compiling.release  # would find LLVM half-way, or wait for the import for ever
    os.register_at_fork(before=compiling.acquire, after_in_parent=release, after_in_child=release)


@cache
def machine() -> ModuleType:
    """Return the module that draws in this process: its NAME, and `drawer(want, job)`."""
    with compiling:
        try:
            from renderer.machines import native
        except ImportError:  # no llvmlite, or one that is too old
            from renderer.machines import numpy_rows

            return numpy_rows
        return native
