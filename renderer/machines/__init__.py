"""The machines that run the shader: LLVM's vectors where llvmlite is installed, NumPy's arrays elsewhere; same bits.

A job, the memory that a machine reads and draws on, is a dict of arrays: `scene` and `lights`, the numbers of these;
`x`, image points as many as a plane's row is long, NaN beyond the raster's last column, and `y`, one of each row;
`columns`, (rows, 2) int64, where the drawn columns of each row begin and end; the frame's planes by name,
(rows, columns of x), float64, the chamber code `code` uint8. Where bounds are wanted, `x_bound`, `y_bound` and
`scene_bounds` bound the errors of x, y and scene.
"""

import os
from collections.abc import Callable
from functools import cache
from threading import RLock
from types import ModuleType
from typing import Any

import numpy as np

Job = dict[str, np.ndarray]
FEW_POINTS = 2**12
compiling = RLock()
if hasattr(os, "register_at_fork"):
    # A child forked while another thread compiles, or imports the compiler, would inherit LLVM in an unfinished state,
    # or wait for that import for ever: a fork waits for the lock.
    release = compiling.release
    os.register_at_fork(before=compiling.acquire, after_in_parent=release, after_in_child=release)


@cache
def machine() -> ModuleType:
    """Return the module that draws in this process: its NAME, `drawer(want, job)`, `over_points(kernel, *inputs)`."""
    with compiling:
        try:
            from renderer.machines import native
        except ImportError:  # no llvmlite, or one that is too old
            from renderer.machines import numpy_rows

            return numpy_rows
        return native


def at_points(kernel: Callable, *inputs: Any) -> list[np.ndarray]:
    """Return what a kernel gives at each of some points, an array for each output: the same bits by any machine.

    inputs: arrays (points,) of float64, or one number for all. NumPy takes few points, as compiling would take longer.
    """
    if np.broadcast(*inputs).size >= FEW_POINTS:
        return machine().over_points(kernel, *inputs)
    from renderer.machines.numpy_rows import over_points

    return over_points(kernel, *inputs)
