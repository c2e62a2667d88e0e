"""Coq accepts proofs/formal/ as its record says, and refuses what is false, assumed or left out."""

import json
import shutil

import pytest

from proofs.engine.theorem import all_theorems
from renderer.files import write_whole
from verify import formal
from verify.sources import key

needs_coq = pytest.mark.skipif(
    shutil.which("coqc") is None, reason="Coq is not installed: the record is not re-checked"
)


def test_statements_are_of_theorems_of_the_book():
    named = formal.statements()
    assert named.keys() <= all_theorems().keys()
    assert formal.PARTLY.keys() <= named.keys()
    for id, names in named.items():
        assert all_theorems()[id].expected == "refuted" or any(name.endswith("__false") for name in names), id


@needs_coq
def test_coq_accepts_what_the_record_says(pytestconfig):
    now = key(formal.sources())
    if pytestconfig.getoption("--fresh") or not formal.KEPT.is_file() or formal.KEPT.read_text() != now:
        assert json.loads(formal.RECORD.read_text(encoding="utf-8"))["theorems"] == formal.compile_files()
        write_whole(formal.KEPT, now.encode())
    assert formal.record(), "proofs/formal changed since its record was made: run python -m verify.formal"


FALSE = "Theorem unit_length__length : 1 + 1 = 3. Proof. lra. Qed."
ADMITTED = "Theorem unit_length__length : 1 + 1 = 3. Proof. Admitted."
ASSUMED = "Axiom three : 1 + 1 = 3.\nTheorem unit_length__length : 1 + 1 = 3. Proof. exact three. Qed."


@needs_coq
@pytest.mark.parametrize("text, why", [(FALSE, "does not accept"), (ADMITTED, "rests on"), (ASSUMED, "rests on")])
def test_what_is_not_proved_is_not_accepted(text, why, tmp_path, monkeypatch):
    monkeypatch.setattr(formal, "FOLDER", tmp_path)
    (tmp_path / "Wrong.v").write_text(f"From Coq Require Import Reals Lra.\nOpen Scope R_scope.\n{text}\n")
    with pytest.raises(formal.NotAccepted, match=why):
        formal.compile_files()
