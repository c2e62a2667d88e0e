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


@pytest.fixture
def written(folder):
    """The key and the evidence that were kept of a theorem."""
    key, found = measurement_cache.key_of(QUICK), examine(QUICK, THEOREMS)
    measurement_cache.keep(found, key)
    return key, found


def test_what_is_kept_is_what_was_found(written):
    key, found = written
    assert asdict(measurement_cache.read(QUICK, key)) == asdict(found)
    assert measurement_cache.key_of(QUICK) == key


def test_what_was_changed_is_not_read(written, folder):
    key, _ = written
    (path,) = folder.iterdir()
    good = json.loads(path.read_text(encoding="utf-8"))
    tampered = json.loads(json.dumps(good))
    tampered["evidence"]["record"]["measurements"][0]["worst"] = 0.5
    for content in (json.dumps(tampered), json.dumps(good | {"hash": ""}), "{}", "[]", ""):
        path.write_text(content, encoding="utf-8")
        assert measurement_cache.read(QUICK, key) is None
    assert measurement_cache.read(QUICK, "another key") is None


def test_what_failed_is_not_kept(folder):
    failed = examine(QUICK, THEOREMS)
    failed.problems.append("it does not hold")
    measurement_cache.keep(failed, measurement_cache.key_of(QUICK))
    assert not folder.exists()


def test_the_key_knows_the_theorem():
    assert measurement_cache.key_of(QUICK) != measurement_cache.key_of(replace(QUICK, title="Another"))


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
