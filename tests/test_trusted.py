"""The page of what is trusted names every module that a grade passes through, and no other."""

import re
from pathlib import Path

import pytest

from verify import conftest
from verify.checkers import theorem_files
from verify.evidence import grade_path
from verify.evidence.records import BENCHMARKS, RECORDS, RESULTS, code_of, read
from verify.evidence.sources import ROOT, is_test

PAGE = ROOT / "book" / "checked" / "trusted.md"
BESIDE = {"proofs/theorems/__init__.py"}  # the list of claims
TOLD_BESIDE = {f"verify/{name}.py" for name in ("coq/formal", "coq/survey", "coq/vernacular", "evidence/sources")}
TOLD_BESIDE |= {f"proofs/printers/{name}.py" for name in ("coq", "coq_statements", "numbers", "python")}


def test_the_page_names_every_module_that_a_grade_passes_through():
    """The engine's and the checkers' modules; packages are left out, and printers, of which the page tells beside."""
    modules = {path for path in grade_path.modules() if path.startswith(("proofs/", "verify/"))} - TOLD_BESIDE
    rows = re.findall(r"^\| \{source-link\}`([^`]+)` \|", PAGE.read_text("utf-8"), re.MULTILINE)
    assert len(rows) == len(set(rows))
    assert set(rows) == {path for path in modules if not path.endswith("__init__.py")} | BESIDE


def test_every_committed_record_is_known_and_reaches_what_it_measures():
    committed = {path for folder in (RESULTS, BENCHMARKS) for path in (ROOT / folder).iterdir()}
    assert committed == {ROOT / record.path for record in RECORDS.values()}
    for name in RECORDS:
        label, code = read(name)["label"], code_of(name).keys()
        assert label["machine"] and label["date"] and label["commit"] not in ("", "unknown")
        assert {"renderer/kernels.py", "renderer/shader/shader.py"} <= code
        assert not any(path.startswith((RESULTS, BENCHMARKS)) or path.endswith(".md") for path in code)
        tests = {path for path in code if is_test(Path(path))}
        assert {"verify/test_theorems.py"} <= tests if name == "edited_formulas" else not tests
    assert {"book/static/simulator/module.js", "book/programs/simulator_module.py"} <= set(code_of("simulator"))
    by_command_line = {name for name in RECORDS if "renderer/command_line/options.py" in code_of(name)}
    assert by_command_line == {"frames"}  # a help text makes no campaign stale


EVIL = {"evil.py": "line 1: names SystemExit", "evil/__init__.py": "stands in a folder"}


@pytest.mark.parametrize("name, why", EVIL.items())
def test_a_program_among_the_theorems_is_never_run(name, why, monkeypatch, tmp_path, pytestconfig):
    (tmp_path / name).parent.mkdir(exist_ok=True)
    (tmp_path / name).write_text("raise SystemExit")
    monkeypatch.setattr(theorem_files, "FOLDER", tmp_path)
    with pytest.raises(pytest.UsageError, match=f"data: {name}, {why}"):
        conftest.pytest_configure(pytestconfig)
