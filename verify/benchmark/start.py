"""How long it takes from nothing to a picture: a fresh interpreter, its imports, and the code that LLVM compiles."""

import re
import subprocess
import sys
import tempfile
from functools import partial
from pathlib import Path

from verify.benchmark.plan import Case

ROOT = Path(__file__).resolve().parents[2]
VISITS = 3
ONE_PICTURE = "from renderer import Scene, render; render(Scene(), 256, 256)"
TWO_PICTURES = """
from renderer import Scene, central, exact, render
numeric = render(Scene(), 256, 256, gradient=central(eps=1e-3))
symbolic = render(Scene(), 256, 256, gradient=exact())
difference = numeric.rgb - symbolic.rgb
"""  # README's


def python(*arguments: str) -> str:
    """Run a fresh interpreter; return what it wrote to standard error. Raises RuntimeError if it fails."""
    done = subprocess.run([sys.executable, *arguments], cwd=ROOT, capture_output=True, text=True)
    if done.returncode:
        raise RuntimeError(f"{' '.join(arguments)} failed:\n{done.stderr}")
    return done.stderr


def image(*options: str, side: int = 2048) -> str:
    """Run `python -m renderer image`; return what it wrote to standard error."""
    with tempfile.TemporaryDirectory() as folder:
        return python(*options, "-m", "renderer", "image", "--size", str(side), "--out", str(Path(folder) / "a.png"))


def imports_sympy() -> bool:
    """Return whether the command imports SymPy, by the interpreter's own list of imports."""
    return bool(re.search(r"\| +sympy$", image("-X", "importtime", side=64), re.MULTILINE))


CASES = [
    Case("start_two_pictures", lambda: partial(python, "-c", TWO_PICTURES), 1, VISITS),
    Case("start_one_picture", lambda: partial(python, "-c", ONE_PICTURE), 1, VISITS),
    Case("start_image_2048", lambda: image, 1, VISITS),
]
