"""How long the command line takes from nothing to a picture, with an empty cache of compiled kernels and a full one.

As it is, and with the compiled kernels, which a picture so small is not given (renderer/back_end.py).
"""

import functools
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from renderer.back_end import NUMBA, VARIABLE
from verify.benchmark.plan import Case

ROOT = Path(__file__).resolve().parents[2]
VISITS = 3
COMPILED = {VARIABLE: NUMBA}


def draw(cache, *options, **environment):
    """Run `python -m renderer image` with the kernels' cache in a folder; return what it wrote to standard error."""
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, *options, "-m", "renderer", "image", "--out", str(Path(folder) / "a.png")]
        asked = {name: value for name, value in os.environ.items() if name != VARIABLE}
        environment = asked | {"NUMBA_CACHE_DIR": str(cache)} | environment
        done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True)
        if done.returncode:
            raise RuntimeError(f"python -m renderer image failed:\n{done.stderr}")
        return done.stderr


def cold(**environment):
    """Draw with an empty cache."""
    with tempfile.TemporaryDirectory() as cache:
        draw(cache, **environment)


@functools.cache
def full_cache():
    """Return a temporary folder, kept until the process ends, that one drawing with compiled kernels has filled."""
    folder = tempfile.TemporaryDirectory()
    draw(folder.name, **COMPILED)
    return folder


def warm(*options, **environment):
    """Draw with a full cache; return what was written to standard error."""
    return draw(full_cache().name, *options, **environment)


def prepare_warm(**environment):
    """Return the function that draws with a full cache, the cache filled."""
    full_cache()
    return functools.partial(warm, **environment)


def imports_sympy():
    """Return whether the command imports SymPy, by the interpreter's own list of imports."""
    return bool(re.search(r"\| +sympy$", warm("-X", "importtime"), re.MULTILINE))


CASES = [
    Case("start_cold", lambda: cold, 1, VISITS),
    Case("start_warm", prepare_warm, 1, VISITS),
    Case("start_cold_compiled", lambda: functools.partial(cold, **COMPILED), 1, VISITS),
    Case("start_warm_compiled", functools.partial(prepare_warm, **COMPILED), 1, VISITS),
]
