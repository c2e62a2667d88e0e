"""Bare Python accepts no stand-alone script once a number or a statement is changed."""

import inspect
import subprocess
import sys

import pytest

from proofs import check
from proofs.engine import kernel, standalone
from proofs.engine.standalone import standalone_script


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
    head, certificate, tail = standalone_script(id).partition('"certificate"')
    assert all(inspect.getsource(part).strip() in head + certificate + tail for part in (kernel, check, standalone.run))
    path = tmp_path / "theorem.py"
    path.write_text(head + certificate + tail.replace(was, changed, 1), "utf-8")
    status, printed, errors = bare(str(path))
    assert (status, errors) == (1, "") and says in printed
