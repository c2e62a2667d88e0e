"""The command that counts what a grade passes through finds what decides one, and nothing that decides none."""

import pytest

from verify import conftest, grade_path
from verify.checkers import theorem_files
from verify.sources import ROOT


def test_what_decides_a_grade_is_counted():
    found = grade_path.modules(ROOT)
    deciding = ("engine/kernel", "engine/statement", "engine/names", "engine/theorem")
    assert {f"proofs/{name}.py" for name in deciding} | {"verify/survey.py", grade_path.PRINTS_CLAIMS} <= found.keys()
    assert 150 < found["proofs/engine/kernel.py"] < 250  # prose is not counted
    assert not {"proofs/engine/search.py", "verify/checkers/measured.py", "renderer/kernels.py"} & found.keys()
    assert "renderer/generate/rules.py" in grade_path.modules(ROOT, grade_path.PRINTS_FLOAT64)


def test_a_program_among_the_theorems_is_never_run(monkeypatch, tmp_path, pytestconfig):
    (tmp_path / "evil.py").write_text("raise SystemExit")
    monkeypatch.setattr(theorem_files, "FOLDER", tmp_path)
    with pytest.raises(pytest.UsageError, match=r"data: evil.py, line 1: names SystemExit"):
        conftest.pytest_configure(pytestconfig)
