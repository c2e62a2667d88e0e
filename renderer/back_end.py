"""Which kernels draw: those that Numba compiles, or the same definitions as NumPy does them, a whole row at once.

To the last bit the same pictures. NumPy takes about a microsecond a pixel, compiled code a fiftieth of that; but to
load a compiler takes half a second, and to compile what a picture needs, once for every version of the sources, ten
or more. So a command that draws no more than SMALL pixels leaves Numba out. The environment's RENDERER_KERNELS, numba
or numpy, has the last word; where Numba is not installed, it is numpy.
"""

import argparse
import importlib
import os
import sys
from importlib.util import find_spec

NUMBA, NUMPY = "numba", "numpy"
VARIABLE = "RENDERER_KERNELS"
SMALL = 2**20
DEFAULT_SIZE = 256
SINGLE = ("image", "views")


def draws_little(command):
    """Return whether a process's command line is `-m renderer` with a verb for single pictures, and these small."""
    module, verb, *options = [*command[command.index("-m") + 1 :], "", ""] if "-m" in command else ["", ""]
    if module != "renderer" or verb not in SINGLE:
        return False
    parser = argparse.ArgumentParser(add_help=False, exit_on_error=False)
    for side in ("--size", "--width", "--height"):
        parser.add_argument(side, type=int)
    try:
        asked, _ = parser.parse_known_args(options)
    except argparse.ArgumentError:  # the real parser says what is wrong
        return True
    size = DEFAULT_SIZE if asked.size is None else asked.size
    return (size if asked.width is None else asked.width) * (size if asked.height is None else asked.height) <= SMALL


def choose():
    """Return NUMBA or NUMPY for this process. Raises ValueError if the environment asks for anything else."""
    asked = os.environ.get(VARIABLE)
    if asked not in (None, NUMBA, NUMPY):
        raise ValueError(f"{VARIABLE} = {asked!r} is not allowed: {NUMBA} or {NUMPY}")
    return asked or (NUMPY if find_spec("numba") is None or draws_little(sys.orig_argv) else NUMBA)


def use_numpy():
    """Put NumPy's kernels and loops in the place of the compiled ones: before the renderer's modules are imported."""
    sys.modules["renderer.kernels"] = importlib.import_module("renderer.array_kernels")
    from renderer import arrays

    arrays.take_over()
