"""The check of stored certificates in bare Python."""

import subprocess
import sys
from pathlib import Path

from proofs import check

ROOT = Path(__file__).parents[2]


def test_all_stored_certificates_are_accepted(capsys):
    assert check.main([]) == 0
    last = capsys.readouterr().out.splitlines()[-1]
    assert "certificates accepted" in last and not last.startswith("0 ")


def test_needs_the_standard_library_alone():
    code = (
        "import sys; sys.path.insert(0, sys.argv[1]); from proofs.check import main; status = main(['unit_length']);"
        "assert 'sympy' not in sys.modules; sys.exit(status)"
    )
    run = subprocess.run(
        [sys.executable, "-I", "-S", "-c", code, str(ROOT)], capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stderr


def test_an_unknown_theorem_is_named(capsys):
    assert check.main(["no_such_theorem"]) == 2
    assert "no_such_theorem" in capsys.readouterr().err
