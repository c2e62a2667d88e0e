"""The checkers: what the kernels must refuse, in statements, in certificates and in files; and what they accept."""

import inspect
import json
import subprocess
import sys
from functools import partial
from pathlib import Path

import pytest

from proofs import check
from proofs.check import canonical
from proofs.engine import kernel, project, standalone, stored
from proofs.engine.stored import FOLDER
from proofs.engine.theorem import all_theorems
from verify.checkers.known_bad import reasons_of, wrong_verdicts
from verify.evidence.sources import ROOT

HIDDEN = """import sys; sys.modules["playwright"] = None; sys.path.insert(0, sys.argv[1])
import pytest; sys.exit(pytest.main(sys.argv[2:]))"""


def test_a_run_without_node_and_balls_says_what_it_left_out(tmp_path):
    (tmp_path / "flint.py").write_text("raise ModuleNotFoundError(\"No module named 'flint'\", name='flint')\n")
    asked = ["verify", "-p", "no:cacheprovider", "--theorem", "unit_length", "--theorem", "pole_accuracy"]
    command = [sys.executable, "-c", HIDDEN, tmp_path, *asked]
    done = subprocess.run(command, cwd=ROOT, env={"PATH": ""}, capture_output=True, encoding="utf-8", check=True)
    lines = [" ".join(line.split()) for line in done.stdout.splitlines()]
    for start in (
        "verify/test_theorems.py::test_the_second_checker_agrees: the second checker was not run: it needs Node",
        "verify/test_theorems.py::test_theorem[pole_accuracy]: needs python-flint",
        "pole_accuracy not re-checked –",
        "unit_length proved",
    ):
        assert any(line.startswith(start) for line in lines), start


WEAKENED = [
    (" and exact(coefficient) >= 0", ""),
    ("closed and ", ""),
    ('require(all(r in (">", "!=") for _, r in strict), "a fact is not strict")', "pass"),
    ("""require(facts[index][1] == "=", f"fact {index} is not an equation")""", "pass"),
    ("require(add(*(multiply(1, p, p) for p in pair)) == multiply(1), ", "(True, "),
    ("""require(statement["steps"][-1]["step"] == "show", "there is no last goal")""", "pass"),
]


def test_a_run_tells_a_weakened_kernel():
    """The present kernel gives no wrong verdict on known-bad certificates, with which each run begins."""
    text = Path(kernel.__file__).read_text("utf-8")
    for strong, weaker in WEAKENED:
        assert text.count(strong) == 1
        names = {"__name__": "weak"}
        exec(text.replace(strong, weaker), names)
        assert wrong_verdicts(partial(reasons_of, check=names["check"])), strong


GOOD_FILE = (FOLDER / "unit_length.json").read_bytes()
DATA = json.loads(GOOD_FILE)
FIRST = DATA["claims"][0]
REFUSED_FILES = [
    *(GOOD_FILE.replace(b"\n", b""), GOOD_FILE + b"\xff", GOOD_FILE[:-9], b"[" * 10**5),
    GOOD_FILE.replace(b'"version": 1,', b'"version": 1,\n "version": 1,', 1),
    *(
        canonical(DATA | changed).encode()
        for changed in (
            {"more": 1},
            {"theorem": "another"},
            {"claims": []},
            {"claims": [FIRST, FIRST | {"claim": "empty", "statements": []}]},
            {"claims": [FIRST, FIRST]},
        )
    ),
]


def test_bytes_that_another_writer_would_write_are_no_certificates(tmp_path, monkeypatch, capsys):
    """The grade and `proofs.check` accept a file in its canonical form alone."""
    theorems, path = all_theorems(), tmp_path / "unit_length.json"
    monkeypatch.setattr(project, "PROJECT", project.PROJECT._replace(certificates=tmp_path))
    monkeypatch.setattr(stored, "FOLDER", tmp_path)
    path.write_bytes(GOOD_FILE.replace(b'256": "', b'256": "0', 1))
    assert check.main([]) == 1 and "is another statement's" in capsys.readouterr().out
    for bad in REFUSED_FILES:
        path.write_bytes(bad)
        assert check.main([]) == 1 and "the file: " in capsys.readouterr().out
        with pytest.raises(stored.Stale, match="of its stored certificates"):
            stored.stored(theorems["unit_length"])
    assert check.main(["nothing"]) == 2 and "nothing" in capsys.readouterr().err


def bare(*command):
    """Run Python with the standard library alone; return its status, what it printed and its errors."""
    done = subprocess.run([sys.executable, "-I", "-S", "-X", "utf8", *command], capture_output=True, encoding="utf-8")
    return done.returncode, done.stdout, done.stderr


SCRIPTS = [  # changes behind the first certificate's beginning
    ("unit_length", '"1"', '"2"', "REJECTED: ('the two sides differ'"),
    ("tangent_frame", '"is": "="', '"is": ">="', "tangent_frame: REJECTED."),
]


@pytest.mark.parametrize(("id", "was", "changed", "says"), SCRIPTS)
def test_a_changed_script_is_rejected(id, was, changed, says, tmp_path):
    """The script's own kernel rejects it. `tests/test_book_theorems.py` runs the scripts that the book offers."""
    head, certificate, tail = standalone.standalone_script(id).partition('"certificate"')
    assert all(inspect.getsource(part).strip() in head + certificate + tail for part in (kernel, check, standalone.run))
    path = tmp_path / "theorem.py"
    path.write_text(head + certificate + tail.replace(was, changed, 1), "utf-8")
    status, printed, errors = bare(str(path))
    assert (status, errors) == (1, "") and says in printed
