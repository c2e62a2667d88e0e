"""Coq accepts proofs/formal/ as its record says, and refuses what is false, assumed or left out."""

import json
import re
import shutil
import subprocess
import sys
from importlib.util import find_spec

import pytest

from proofs.engine.theorem import all_theorems
from renderer.whole_files import write_whole
from verify import formal, survey, vernacular
from verify.sources import ROOT
from verify.test_campaign import draw, edited

needs_coq = pytest.mark.skipif(
    shutil.which("coqc") is None or find_spec("tqdm") is None,
    reason="needs Coq, and tqdm: the record is not re-checked",
)


def test_statements_are_of_theorems_of_the_book():
    named = formal.statements()
    assert named.keys() <= all_theorems().keys()
    assert formal.PARTLY.keys() <= named.keys()
    for id, found in named.items():
        said = {name for name in found.additions if not name.endswith(formal.BESIDE)}
        refuted = all_theorems()[id].expected == "refuted"
        assert refuted or {f"{name}__false" for name in said} <= set(found.additions), id


def test_a_theorem_that_coq_says_is_said_whole_or_by_name_in_part():
    for id, accepted in formal.record().items():
        assert formal.whole(all_theorems()[id], accepted) != (id in formal.PARTLY), id


def test_a_theorem_is_whole_by_all_of_its_claims_and_by_nothing_else():
    for id in ("normal_limits", "gradient_accuracy"):
        theorem = all_theorems()[id]
        claims = [f"{id}__{claim.name}" for claim in (*theorem.claims, *theorem.rounded)]
        assert formal.whole(theorem, {"claims": claims, "statements": {}})
        assert not formal.whole(theorem, {"claims": claims[1:], "statements": {f"{id}__any": "True"}})
        assert not formal.whole(theorem, None)


@needs_coq
def test_coq_accepts_what_the_record_says(request):
    """Where these files were accepted here before, Coq is not asked again; with --long it is, theorem by theorem."""
    alone = request.config.getoption("long")
    if alone or not formal.accepted_here():
        said = json.loads(formal.RECORD.read_text(encoding="utf-8"))["theorems"]
        assert said == formal.compile_files(said=None if alone else said)
        write_whole(formal.KEPT, formal.seen().encode())
    assert formal.record(), "proofs/formal changed since its record was made: run python -m verify.formal"


WRONG = """From Coq Require Import Reals Lra.
Open Scope R_scope.
Theorem left_out__proof : 1 + 1 = 3. Proof. Admitted.
Axiom three : 1 + 1 = 3.
Theorem assumed__three : 1 + 1 = 3. Proof. exact three. Qed.
Unset Guard Checking. Fixpoint never (n : nat) : False := never n. Set Guard Checking.
Theorem unguarded__three : 1 + 1 = 3. Proof. destruct (never 0). Qed.
Unset Positivity Checking. Inductive no : Type := yes : (no -> False) -> no. Set Positivity Checking.
Lemma nonsense (n : no) : False. Proof. destruct n as [f] eqn:E. exact (f n). Qed.
Theorem unpositive__three : 1 + 1 = 3. Proof. destruct (nonsense (yes nonsense)). Qed.
"""
WHY = {"left_out": "rests on left_out__proof", "assumed": "rests on three",
       "unguarded": "never is assumed to be guarded", "unpositive": "no is assumed to be positive"}  # fmt: skip


@needs_coq
def test_what_is_not_proved_is_not_accepted(tmp_path, monkeypatch):
    """Coq is asked once, and of each theorem what it printed of it."""
    monkeypatch.setattr(formal, "FOLDER", tmp_path)
    monkeypatch.setattr(vernacular, "check", lambda text: None)  # which would refuse all of it before Coq reads it
    (tmp_path / "Wrong.v").write_text(WRONG, encoding="utf-8")
    with monkeypatch.context() as patch:
        patch.setattr(survey, "read", lambda *printed: printed)
        found, groups, printed = formal.compile_files()
    *parts, _ = printed.split(survey.SEPARATOR)
    for group, said, rests in zip(groups, parts[:4], parts[4:], strict=True):
        own = {theorem: found[theorem] for theorem in group}
        with pytest.raises(formal.NotAccepted, match=WHY[group[0]]):
            survey.read(own, [group], f"{said}{survey.SEPARATOR}{rests}{survey.SEPARATOR}")
    (tmp_path / "Wrong.v").write_text(WRONG.replace("Admitted", "lra. Qed"), encoding="utf-8")
    with pytest.raises(formal.NotAccepted, match="does not accept Wrong"):
        formal.compile_files()


@needs_coq
def test_coqs_own_checker_refuses_a_file_that_coq_did_not_compile_so(tmp_path):
    (tmp_path / "One.v").write_text("Theorem one : 1 = 1. Proof. reflexivity. Qed.", encoding="utf-8")
    subprocess.run([*formal.COQC, "One.v"], cwd=tmp_path, check=True)
    formal.check_again(tmp_path, ["One"])
    compiled = bytearray((tmp_path / "One.vo").read_bytes())
    compiled[len(compiled) // 2] ^= 1
    (tmp_path / "One.vo").write_bytes(compiled)
    with pytest.raises(formal.NotAccepted, match="coqchk does not accept"):
        formal.check_again(tmp_path, ["One"])


AXIOM = "Axiom three : 1 + 1 = 3."
ONE, TWO = (f"From Formal Require Import {other}.\n" for other in ("Two", "One"))
REFUSED = [
    ({"One": ONE}, "there is no Two"),
    ({"One": ONE, "Two": TWO}, "require each other"),
    ({"Uint63": AXIOM}, "Uint63: a module of Coq's own"),
    ({"Statements": TWO, "One": ""}, "Statements requires One, which is written by hand"),
    ({"Preliminaries": "Definition power (base exponent : R) : R := 0."}, "is not the text that is trusted"),
    ({"One": "Definition one := 1.", "Two": "Lemma one : 1 = 1."}, "given twice: one"),
    ({"One": "Theorem unit_length__x : Statements.unit_length__y.\nProof."}, "has to have its name"),
]


@pytest.mark.parametrize(("texts", "why"), REFUSED)
def test_files_that_cannot_be_ordered_or_could_hide_an_axiom_are_refused(texts, why, tmp_path, monkeypatch):
    monkeypatch.setattr(formal, "FOLDER", tmp_path)
    for name, text in texts.items():
        (tmp_path / f"{name}.v").write_text(text)
    with pytest.raises(formal.NotAccepted, match=why):
        formal.statements()


HIDING = [
    f"Module PrimFloat. {AXIOM} End PrimFloat.",
    f"Module (* . *) Uint63. {AXIOM} End Uint63.",
    "Declare Module Uint63 : T.",
    "Module Import Uint63.",
    "Module hit_of_a. Definition t_a := 0. End hit_of_a.",
    'Notation "( x , y )" := ltac:(exact I) : core_scope.',  # of the survey's (statement, I)
    'Infix "+" := Rmult.',
    "Coercion f : A >-> B.",
    "Variable c :> R -> R.",
    "Arguments f {x}.",
    "Definition f {x : R} : R := x.",
    "Theorem f { x y : R} : x = y.",
    "Canonical Structure c := d.",
    "Global Instance precision : Prec_gt_0 53.",
    "#[global] Hint Resolve sin_0.",
    "Set Implicit Arguments.",
    "Inductive no : Type := yes {f : R}.",
    "CoInductive no : Type := yes.",
    "Record pair := { first :> R }.",
    "Fixpoint f (n : nat) := 0 with sin (n : nat) := 0.",
    "From Elsewhere Require Import Sines.",
    "Proof. abstract trivial using PI. Qed.",
    f"Proof. {{ {AXIOM} }} Qed.",
    f"(* (* *) *) - {AXIOM}",
    f'(* " *) {AXIOM} (* " *)',
    "(* Lemma a : True.",
]


@pytest.mark.parametrize("text", HIDING)
def test_what_could_change_how_a_statement_is_read_is_refused(text):
    plain = "(* A {comment}. *) Lemma a (x y : R) : {x = y} + {x <> y}.\nProof. { exact (Req_EM_T x y). }\nQed.\n"
    vernacular.check(plain)
    with pytest.raises(vernacular.Unreadable):
        vernacular.check(plain + text)


CLAIMS = """From Coq Require Import Reals.
Open Scope R_scope.
Definition unit_length__true : Prop := forall x : R, sin x = sin x + 0.
Definition unit_length__false : Prop := forall x : R, sin x = 0.
"""
MUTANTS = """From Coq Require Import Reals.
Open Scope R_scope.
Definition unit_length__1__false : Prop := ~ forall x : R, x = 0.
"""
BY_HAND = """From Coq Require Import Reals Lra.
From Formal Require Statements.
From Formal Require Mutants.
Open Scope R_scope.
Theorem unit_length__true : Statements.unit_length__true.
Proof. intro x. lra. Qed.
"""
MUTANT = "Mutants.unit_length__1__false."
FALSE = "Theorem unit_length__false : Statements.unit_length__false.\nProof."
NOT_PROVED = [
    (f"{FALSE} intro x. reflexivity. Qed.", "does not accept One"),
    (f"Definition sin (x : R) := 0.\n{FALSE} intro x. unfold sin. reflexivity. Qed.", "does not accept One"),
    ("Definition sin (x : R) : R := 0.", "does not accept Names"),
    ("Lemma PI : R.\nProof. exact 3. Qed.", "does not accept Names"),
    ("Inductive odd : Prop := | PI : odd.", "does not accept Names"),
    ("Section s.\nVariable R : Set.\nEnd s.", "does not accept Names"),
    (
        "Theorem unit_length__1__false : Mutants.unit_length__1__false.\nProof. intro x. lra. Qed.",
        "does not accept One",
    ),
    (
        "Theorem unit_length__2__false : Mutants.unit_length__1__false.\nProof. intro x. lra. Qed.",
        "has to have its name",
    ),
]


@needs_coq
@pytest.mark.parametrize(("text", "why"), NOT_PROVED)
def test_what_is_proved_is_what_is_printed(text, why, tmp_path, monkeypatch):
    monkeypatch.setattr(formal, "FOLDER", tmp_path)
    (tmp_path / "Statements.v").write_text(CLAIMS)
    (tmp_path / "Mutants.v").write_text(MUTANTS)
    (tmp_path / "One.v").write_text(BY_HAND + text)
    with pytest.raises(formal.NotAccepted, match=why):
        formal.compile_files()


@needs_coq
def test_a_claim_counts_where_its_printed_form_is_proved_and_no_words_count(tmp_path, monkeypatch):
    monkeypatch.setattr(formal, "FOLDER", tmp_path)
    (tmp_path / "Statements.v").write_text(CLAIMS)
    (tmp_path / "Mutants.v").write_text(MUTANTS)
    said = "Theorem unit_length__false : True.\nProof. trivial. Qed.\n"
    said += (
        "Theorem unit_length__1__false : Mutants.unit_length__1__false.\nProof. intro f. generalize (f 1). lra. Qed.\n"
    )
    (tmp_path / "One.v").write_text(BY_HAND + said)
    accepted = formal.compile_files()["unit_length"]
    assert accepted["claims"] == ["unit_length__true"] and accepted["mutants"] == ["unit_length__1__false"]
    assert accepted["statements"] == {"unit_length__false": "True"}


def test_what_coq_accepted_here_is_kept_with_what_the_record_says(tmp_path, monkeypatch):
    monkeypatch.setattr(formal, "RECORD", tmp_path / "record.json")
    formal.RECORD.write_text("{}")
    before = formal.seen()
    formal.RECORD.write_text('{"theorems": {}}')
    assert formal.seen() != before


def test_a_record_that_coq_did_not_write_here_proves_nothing(tmp_path, monkeypatch):
    """Neither without what Coq said here, nor with what it said of another record; `record` itself is no witness."""
    theorems, kept = all_theorems().values(), tmp_path / "formal"
    monkeypatch.setattr(formal, "KEPT", kept)
    assert formal.record() and not formal.accepted_here() and not formal.proved_here(theorems)
    kept.write_text("another key")
    assert not formal.accepted_here() and not formal.proved_here(theorems)
    kept.write_text(formal.seen())
    assert formal.accepted_here()
    assert len(proved := formal.proved_here(theorems)) > 40 and not proved & formal.PARTLY.keys()
    monkeypatch.setattr(formal, "RECORD", tmp_path / "record.json")
    assert not formal.accepted_here()


TRUE = survey.SEPARATOR
SAID, CLOSED = f"unit_length__length\n     : 1 = 1\n{TRUE}", f"{survey.CLOSED}{TRUE}"


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
    found = {"unit_length": survey.Said({}, {"unit_length__length": []})}
    groups = survey.groups(found, {})
    assert survey.read(found, groups, SAID + CLOSED)["unit_length"]["axioms"] == []
    axioms = "Axioms:\nClassical_Prop.classic : forall P : Prop, P \\/ ~ P\n" + TRUE
    assert survey.read(found, groups, SAID + axioms)["unit_length"]["axioms"] == ["Classical_Prop.classic"]
    with pytest.raises(formal.NotAccepted, match=why):
        survey.read(found, groups, printed)


def test_theorems_said_to_rest_on_the_same_axioms_have_all_that_coq_lists_for_them():
    found = {name: survey.Said({}, {f"{name}__said": []}) for name in ("one", "two", "three")}
    said = {"one": {"axioms": []}, "two": {"axioms": []}, "three": {"axioms": ["Classical_Prop.classic"]}}
    groups = survey.groups(found, said)
    assert groups == [["one", "two"], ["three"]]
    statements = "".join(f"{name}__said\n     : 1 = 1\n{TRUE}" for name in found)
    rests = "Axioms:\nClassical_Prop.classic : forall P : Prop, P \\/ ~ P\n" + TRUE
    table = survey.read(found, groups, statements + rests + rests)
    assert [entry["axioms"] for entry in table.values()] == [["Classical_Prop.classic"]] * 3


PRINT = """import json
from renderer.generate.coq import float64_source, formulas_source
print(json.dumps({"Formulas.v": formulas_source(), "Float64.v": float64_source()}))"""
MODULE = re.compile(r"^Module (\w+)\.\n(.*?)^End \1\.", re.MULTILINE | re.DOTALL)


@needs_coq
@pytest.mark.long
def test_no_broken_formula_is_accepted(tmp_path, monkeypatch):
    """One operator of proofs/formulas/ at a time: Coq refuses it, or no statement is about what is printed of it."""
    for name in ("proofs", "renderer"):
        shutil.copytree(ROOT / name, tmp_path / name)
    folder = tmp_path / "proofs" / "formal"
    monkeypatch.setattr(formal, "FOLDER", folder)
    accepted, texts = [], {file.name: file.read_text(encoding="utf-8") for file in formal.files()}
    before = {name: texts.pop(name) for name in ("Formulas.v", "Float64.v")}
    for place in draw(seed=20, number=20):
        with edited(tmp_path, *place) as what:
            done = subprocess.run([sys.executable, "-c", PRINT], cwd=tmp_path, capture_output=True, text=True)
        verdict = "cannot be printed"
        if done.returncode == 0:
            after, modules = json.loads(done.stdout), set()
            for file, text in after.items():
                (folder / file).write_text(text, encoding="utf-8")
                modules |= {name for name, _ in set(MODULE.findall(text)) ^ set(MODULE.findall(before[file]))}
            about = [file for file, text in texts.items() if any(re.search(rf"\b{name}\.", text) for name in modules)]
            verdict = "no statement is about it"
            try:
                if about:
                    formal.compile_files(*(file.removesuffix(".v") for file in about))
                    verdict = "accepted"
            except formal.NotAccepted as error:
                verdict = f"refused: {re.search(r'File .*line [0-9]+|$', str(error))[0]}"
        accepted += [what] if verdict == "accepted" else []
        print(f"{what}: {verdict}", flush=True)
    assert accepted == []
