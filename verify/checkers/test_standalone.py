"""The stand-alone scripts: bare Python accepts each as it is, and none once a number or a statement is changed."""

import inspect
import json
import re
import subprocess
import sys

import pytest

from proofs import check
from proofs.check import FOLDER, canonical
from proofs.engine import kernel, standalone
from proofs.engine.standalone import main, standalone_script
from proofs.engine.theorem import Theorem, all_theorems

CHECKED = [path.stem for path in sorted(FOLDER.glob("*.json"))]


def run(script, folder):
    """Run a script with the standard library alone; return the finished process."""
    path = folder / "theorem.py"
    path.write_text(script, encoding="utf-8")
    command = [sys.executable, "-I", "-S", "-X", "utf8", str(path)]
    return subprocess.run(command, capture_output=True, text=True, encoding="utf-8", cwd=folder, check=False)


@pytest.mark.parametrize("id", ["tangent_frame", "seed_orientation", "bump_moves_no_boundary"])
def test_the_script_says_its_verdict(id, tmp_path):
    done = run(standalone_script(id), tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert f"{id}: {'REFUTED' if id == 'seed_orientation' else 'PROVED'}." in done.stdout
    assert "accepted" in done.stdout
    assert "REJECTED" not in done.stdout


def test_a_changed_certificate_is_rejected(tmp_path):
    head, data, tail = re.split(r'(?<=\nDATA = r""")(?s:(.*?))(?=""")', standalone_script("tangent_frame"), maxsplit=1)
    changed = json.loads(data)
    proof = changed["claims"][1]["statements"][0]["certificate"]["proofs"][0]
    proof["cofactors"][0][1] = {"": "2"}
    done = run(head + canonical(changed) + tail, tmp_path)
    assert done.returncode == 1
    assert "orthonormal: REJECTED: ('the two sides differ'" in done.stdout


def test_a_changed_statement_is_rejected(tmp_path):
    done = run(standalone_script("tangent_frame").replace('"is": "=",\n', '"is": ">=",\n', 1), tmp_path)
    assert done.returncode == 1
    assert "tangent_frame: REJECTED." in done.stdout


def test_every_certificate_has_a_script_that_holds_the_checker_as_it_stands():
    """Its two files share one set of names there: none means two things."""
    for id in CHECKED:
        if id in all_theorems():
            script = standalone_script(id)
            compile(script, id, "exec")
            assert all(inspect.getsource(part).strip() in script for part in (kernel, check, standalone.run))
    shared = {name for name in vars(kernel).keys() & vars(check).keys() if not name.startswith("__")}
    assert all(vars(kernel)[name] is vars(check)[name] for name in shared)


def test_what_has_no_certificate_has_no_script(monkeypatch, capsys):
    cited = Theorem("elsewhere", "Elsewhere", "", expected="cited", source="Blinn1978")
    monkeypatch.setattr("proofs.engine.standalone.all_theorems", lambda: {"elsewhere": cited})
    with pytest.raises(ValueError, match="elsewhere is cited: it has no certificate"):
        standalone_script("elsewhere")
    with pytest.raises(SystemExit, match="2"):
        main(["nothing"])
    assert "elsewhere" in capsys.readouterr().err
