"""Without python-flint: what cannot be re-checked is named, certificates are checked by the kernel alone and say so."""

import subprocess
import sys

from verify import sources
from verify.optional import lacking


def test_a_run_without_balls_says_what_it_left_out(tmp_path):
    (tmp_path / "flint.py").write_text("raise ModuleNotFoundError(\"No module named 'flint'\", name='flint')\n")
    options = ["-q", "-p", "no:cacheprovider", "--theorem", "unit_length", "--theorem", "gradient_accuracy"]
    hidden = f"import sys; sys.path.insert(0, {str(tmp_path)!r}); import pytest; sys.exit(pytest.main(sys.argv[1:]))"
    command = [sys.executable, "-c", hidden, "verify", *options]
    done = subprocess.run(command, cwd=sources.ROOT, capture_output=True, text=True, encoding="utf-8", check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    lines = [" ".join(line.split()) for line in done.stdout.splitlines()]
    assert "certificates: the second checker was not run; it needs python-flint" in lines
    assert "verify/test_theorems.py::test_theorem[gradient_accuracy]: needs python-flint" in lines
    assert any(line.startswith("unit_length proved, second checker not run") for line in lines)
    assert any(line.startswith("gradient_accuracy not re-checked –") for line in lines)


def test_only_a_library_that_may_be_absent_is_forgiven():
    assert lacking(ModuleNotFoundError("No module named 'flint'")) == "python-flint"
    assert lacking(ModuleNotFoundError("No module named 'proofs.formulas.gone'")) is None
    assert lacking(ImportError("cannot import name 'Reference' from 'verify.evaluate'")) is None
