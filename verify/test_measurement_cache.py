"""Evidence that is kept: read again while nothing changed, measured anew after an edit, refused if changed."""

import json
import shutil
import subprocess
import sys
from dataclasses import asdict, replace

import pytest

from proofs.engine.theorem import all_theorems
from verify import sources, test_theorems
from verify.checkers import measured, measurement_cache
from verify.checkers.measured import examine

THEOREMS = all_theorems()
QUICK = THEOREMS["crease_products"]


@pytest.fixture
def folder(monkeypatch, tmp_path):
    """An empty folder of kept evidence."""
    monkeypatch.setattr(measurement_cache, "FOLDER", tmp_path / "theorems")
    return tmp_path / "theorems"


def test_what_is_kept_is_what_was_found_and_what_was_changed_or_failed_is_not_read(folder):
    key, found = measurement_cache.key_of(QUICK), examine(QUICK, THEOREMS)
    assert measurement_cache.key_of(replace(QUICK, title="Another")) != key == measurement_cache.key_of(QUICK)
    measurement_cache.keep(replace(found, problems=["it does not hold"]), key)
    assert not folder.exists()
    measurement_cache.keep(found, key)
    assert asdict(measurement_cache.read(QUICK, key)) == asdict(found)
    assert measurement_cache.read(QUICK, "another key") is None
    (path,) = folder.iterdir()
    tampered = json.loads(path.read_text("utf-8"))
    tampered["evidence"]["record"]["measurements"][0]["worst"] = 0.5
    for content in (json.dumps(tampered), "{}", "[]", ""):
        path.write_text(content, "utf-8")
        assert measurement_cache.read(QUICK, key) is None


def test_the_run_says_kept_unless_it_is_to_be_fresh(folder, pytestconfig, monkeypatch):
    """The test of a theorem, as the run calls it, three times; the summary prints what it is told."""
    took, examined = [], []
    monkeypatch.setattr(measured, "examine", lambda *a: examined.append(1) or examine(*a))
    for fresh in (True, False, True):
        monkeypatch.setattr(pytestconfig.option, "fresh", fresh)
        test_theorems.test_theorem(QUICK.id, lambda entry, how: took.append(how), pytestconfig)
    assert took == [None, "kept", None]
    assert len(examined) == 2


EDIT = """
from pathlib import Path
from proofs.engine.theorem import all_theorems
from verify.checkers import measured, measurement_cache
theorems = [all_theorems()[id] for id in ("crease_products", "pole_accuracy")]
before = [measurement_cache.key_of(theorem) for theorem in theorems]
with open("proofs/formulas/seed_hit.py", "a") as formula:
    formula.write("# edited")
print(*(measurement_cache.key_of(theorem) == key for theorem, key in zip(theorems, before)))
"""


def test_a_changed_formula_is_measured_anew(tmp_path):
    """An edit of the seed's hit, which no rounded product reaches, and the error at the pole does."""
    pytest.importorskip("flint", reason="needs python-flint")
    for name in ("proofs", "renderer", "verify"):
        shutil.copytree(sources.ROOT / name, tmp_path / name)
    done = subprocess.run([sys.executable, "-c", EDIT], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.stdout == "True False\n", done.stderr
