"""How long the command line takes from nothing to a picture, with an empty cache of compiled kernels and a full one."""

import functools
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from verify.benchmark.plan import Case

ROOT = Path(__file__).resolve().parents[2]
VISITS = 3


def draw(cache, *options):
    """Run `python -m renderer image` with the kernels' cache in a folder; return what it wrote to standard error."""
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, *options, "-m", "renderer", "image", "--out", str(Path(folder) / "a.png")]
        environment = os.environ | {"NUMBA_CACHE_DIR": str(cache)}
        done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True)
        if done.returncode:
            raise RuntimeError(f"python -m renderer image failed:\n{done.stderr}")
        return done.stderr


def cold():
    """Draw with an empty cache."""
    with tempfile.TemporaryDirectory() as cache:
        draw(cache)


@functools.cache
def full_cache():
    """Return a temporary folder, kept until the process ends, that one drawing has filled."""
    folder = tempfile.TemporaryDirectory()
    draw(folder.name)
    return folder


def warm(*options):
    """Draw with a full cache; return what was written to standard error."""
    return draw(full_cache().name, *options)


def prepare_warm():
    """Return the function that draws with a full cache, the cache filled."""
    full_cache()
    return warm


def imports_sympy():
    """Return whether the command imports SymPy, by the interpreter's own list of imports."""
    return bool(re.search(r"\| +sympy$", warm("-X", "importtime"), re.MULTILINE))


CASES = [Case("start_cold", lambda: cold, 1, VISITS), Case("start_warm", prepare_warm, 1, VISITS)]
