"""Which kernels draw: those that Numba compiles, or the same definitions as NumPy does them, a whole row at once.

To the last bit the same pictures. NumPy takes about a microsecond a pixel, compiled code a fiftieth of that; but to
load a compiler takes half a second, and to compile what a picture needs, once for every version of the sources, ten
or more. So a command that draws a picture of no more than SMALL pixels leaves Numba out. The environment's
RENDERER_KERNELS, numba or numpy, has the last word; where Numba is not installed, it is numpy.
"""

import argparse
import math
import os
import sys
from importlib.util import find_spec

NUMBA, NUMPY = "numba", "numpy"
VARIABLE = "RENDERER_KERNELS"
SMALL = 2**20
DEFAULT_SIZE = 256
SINGLE = ("image", "views")


def draws_little(command):
    """Return whether `python -m renderer`'s arguments ask for single pictures, and these small.

    command: `sys.argv` while the package is imported: "-m", and what follows the module's name.
    """
    script, verb, *options = [*command, "", ""]
    if script != "-m" or verb not in SINGLE:
        return False
    parser = argparse.ArgumentParser(add_help=False, exit_on_error=False)
    for side in ("--size", "--width", "--height"):
        parser.add_argument(side, type=int)
    parser.add_argument("--crop", type=lambda text: [int(number) for number in text.split(",")][2:])
    try:
        asked, _ = parser.parse_known_args(options)
    except argparse.ArgumentError:  # the real parser says what is wrong
        return True
    size = DEFAULT_SIZE if asked.size is None else asked.size
    whole = [size if side is None else side for side in (asked.width, asked.height)]
    return math.prod(asked.crop or whole) <= SMALL


def choose():
    """Return NUMBA or NUMPY for this process. Raises ValueError if the environment asks for anything else."""
    asked = os.environ.get(VARIABLE)
    if asked not in (None, NUMBA, NUMPY):
        raise ValueError(f"{VARIABLE} = {asked!r} is not allowed: {NUMBA} or {NUMPY}")
    return asked or (NUMPY if find_spec("numba") is None or draws_little(sys.argv) else NUMBA)


def use_numpy():
    """Put NumPy's kernels and loops in the place of the compiled ones: before the renderer's modules are imported."""
    from renderer import array_kernels

    sys.modules["renderer.kernels"] = array_kernels
    from renderer import arrays

    arrays.take_over()
