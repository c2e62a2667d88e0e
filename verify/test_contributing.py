"""The worked example of CONTRIBUTING.md, in a copy of the tree: searched for, proved, and its mutants refuted."""

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SECTION = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8").partition("\n## A theorem\n")[2].partition("\n## ")[0]
EXAMPLE = re.search(r"```python\n(.*?)```", SECTION, re.DOTALL)[1]
EXAMINE = """
import json
from proofs.theorem import all_theorems
from verify.proof_checker import examine
theorems = all_theorems()
found = examine(theorems["{id}"], theorems)
print(json.dumps([found.grade, found.mutants, found.mutants_killed, found.problems]))
"""


def run(folder, *arguments):
    """Run Python in the folder; return what it prints."""
    command = [sys.executable, *arguments]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, encoding="utf-8", check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_the_example_is_proved(tmp_path):
    for name in ("proofs", "renderer", "verify"):
        shutil.copytree(ROOT / name, tmp_path / name, ignore=shutil.ignore_patterns("__pycache__", "benchmark"))
    (tmp_path / "book").mkdir()
    shutil.copy(ROOT / "book" / "references.bib", tmp_path / "book")
    (tmp_path / "proofs" / "theorems" / "worked_example.py").write_text(EXAMPLE, encoding="utf-8")
    id = re.search(r'id="(\w+)"', EXAMPLE)[1]
    assert run(tmp_path, "-m", "proofs.certificate", id).startswith(f"{id}: ")
    grade, mutants, killed, problems = json.loads(run(tmp_path, "-c", EXAMINE.format(id=id)))
    assert (grade, mutants, killed, problems) == ("proved", 2, 2, [])
    script = run(tmp_path, "-m", "proofs.standalone", id)
    (tmp_path / "theorem.py").write_text(script, encoding="utf-8")
    assert f"{id}: PROVED, given unit_length/length." in run(tmp_path, "-I", "-S", "-X", "utf8", "theorem.py")


def test_the_example_is_short():
    assert len(EXAMPLE.splitlines()) <= 25
    assert all(id in EXAMPLE for id in re.findall(r"python -m proofs\.certificate (\w+)", SECTION))
