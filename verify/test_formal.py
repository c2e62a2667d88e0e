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
UNGUARDED = """Unset Guard Checking. Fixpoint never (n : nat) : False := never n. Set Guard Checking.
Theorem unit_length__length : 1 + 1 = 3. Proof. destruct (never 0). Qed."""
UNPOSITIVE = """Unset Positivity Checking. Inductive no : Type := yes : (no -> False) -> no. Set Positivity Checking.
Lemma false (n : no) : False. Proof. destruct n as [f] eqn:E. exact (f n). Qed.
Theorem unit_length__length : 1 + 1 = 3. Proof. destruct (false (yes false)). Qed."""


@needs_coq
@pytest.mark.parametrize(
    "text, why",
    [
        (FALSE, "does not accept"),
        (ADMITTED, "rests on"),
        (ASSUMED, "rests on"),
        (UNGUARDED, "never is assumed to be guarded"),
        (UNPOSITIVE, "no is assumed to be positive"),
    ],
)
def test_what_is_not_proved_is_not_accepted(text, why, tmp_path, monkeypatch):
    monkeypatch.setattr(formal, "FOLDER", tmp_path)
    (tmp_path / "Wrong.v").write_text(f"From Coq Require Import Reals Lra.\nOpen Scope R_scope.\n{text}\n")
    with pytest.raises(formal.NotAccepted, match=why):
        formal.compile_files()


def test_files_that_require_what_is_not_there_or_each_other_are_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(formal, "FOLDER", tmp_path)
    (tmp_path / "One.v").write_text("From Formal Require Import Two.\n")
    with pytest.raises(formal.NotAccepted, match="there is no Two"):
        formal.files()
    (tmp_path / "Two.v").write_text("From Formal Require Import One.\n")
    with pytest.raises(formal.NotAccepted, match="require each other"):
        formal.files()


TRUE = "I\n     : True\n"
SAID, CLOSED = f"unit_length__length\n     : 1 = 1\n{TRUE}", f"Closed under the global context\n{TRUE}"


@pytest.mark.parametrize(
    "printed, why",
    [
        (SAID, "1 parts, not the 2"),
        (SAID + CLOSED[:9], "1 parts, not the 2"),
        (SAID + CLOSED + "more", "2 parts"),
        (CLOSED + SAID, "was not printed"),
        (f"{SAID}Axioms:\n{TRUE}", "rests on"),
        (f"{SAID}{TRUE}", "rests on"),
        (f"{SAID}Section Variables:\nx : R\n{TRUE}", "rests on"),
        (f"{SAID}Axioms:\nClassical_Prop.classic relies on an unsafe hierarchy.\n{TRUE}", "unsafe hierarchy"),
    ],
)
def test_a_survey_that_is_cut_short_or_says_more_than_axioms_is_refused(printed, why):
    found = {"unit_length": ["unit_length__length"]}
    assert formal._read(found, SAID + CLOSED)["unit_length"]["axioms"] == []
    axioms = "Axioms:\nClassical_Prop.classic : forall P : Prop, P \\/ ~ P\n" + TRUE
    assert formal._read(found, SAID + axioms)["unit_length"]["axioms"] == ["Classical_Prop.classic"]
    with pytest.raises(formal.NotAccepted, match=why):
        formal._read(found, printed)
