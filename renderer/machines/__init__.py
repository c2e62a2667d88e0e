"""The machines that run the shader: LLVM's vectors where llvmlite is installed, NumPy's rows elsewhere; same bits."""

from functools import cache
from types import ModuleType
from typing import NamedTuple

import numpy as np


class Job(NamedTuple):
    """What is drawn on: the numbers of a scene and of its lights, a raster's image points, and a frame's planes.

    x: as long as a plane's row, NaN beyond the raster's last column. y: (rows,). columns: (rows, 2) int64, which
    columns of each row are looked at. planes: {name: (rows, columns of x)}, float64, the chamber code uint8.
    bounds: of the errors of x, of y, and of the scene's numbers (as long as these), where they are wanted.
    """

    scene: np.ndarray
    lights: np.ndarray
    x: np.ndarray
    y: np.ndarray
    columns: np.ndarray
    planes: dict
    bounds: tuple[np.ndarray, np.ndarray, np.ndarray] | None = None


@cache
def machine() -> ModuleType:
    """Return the module that draws in this process: its NAME, and `drawer(want, job)`."""
    try:
        from renderer.machines import native
    except ImportError:  # no llvmlite, or one that is too old
        from renderer.machines import numpy_rows

        return numpy_rows
    return native
