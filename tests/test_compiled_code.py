"""An edited kernel is compiled anew, wherever it is called from: no stale code is drawn with."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
DRAW = "from renderer import Scene, render; print(render(Scene(), 8, 8, threads=1).rgb.sum())"


def drawn(folder):
    """Return what a process started in `folder` prints of its picture."""
    environment = {name: value for name, value in os.environ.items() if name not in ("NUMBA_CACHE_DIR", "PYTHONPATH")}
    run = subprocess.run(
        [sys.executable, "-c", DRAW], cwd=folder, env=environment, capture_output=True, text=True, check=True
    )
    return run.stdout


def test_an_edited_kernel_is_compiled_anew(tmp_path):
    shutil.copytree(ROOT / "renderer", tmp_path / "renderer", ignore=shutil.ignore_patterns("__pycache__"))
    before = drawn(tmp_path)
    assert drawn(tmp_path) == before
    kernels = tmp_path / "renderer" / "kernels.py"
    text = kernels.read_text(encoding="utf-8")
    assert "shine = ks * specular" in text
    kernels.write_text(text.replace("shine = ks * specular", "shine = 2.0 * ks * specular"), encoding="utf-8")
    assert drawn(tmp_path) != before
