"""Coq accepts proofs/formal/ as its record says, and refuses what is false, assumed or left out."""

import json
import re
import shutil
from fractions import Fraction
from functools import cache
from importlib.util import find_spec
from inspect import getsource, signature
from types import SimpleNamespace

import pytest
from sympy import Derivative, sign

from proofs.engine.claim import Claim, Induction, Separation, equation
from proofs.engine.theorem import Pinned, Theorem, all_theorems
from proofs.engine.vectors import real
from proofs.printers.coq_statements import proposition, statements, statements_of
from renderer.whole_files import write_whole
from verify import conftest
from verify.checkers import proof_checker
from verify.checkers.measurements import measurements
from verify.coq import formal, goals, recorded, survey, vernacular
from verify.evidence.sources import ROOT

needs_coq = pytest.mark.skipif(
    shutil.which("coqc") is None or find_spec("tqdm") is None,
    reason="needs Coq, and tqdm: the record is not re-checked",
)


@pytest.fixture
def written(tmp_path, monkeypatch):
    """Return a function that writes the texts of files, which then are all that Coq reads."""
    monkeypatch.setattr(formal, "FOLDER", tmp_path)

    def write(**texts):
        for name, text in texts.items():
            (tmp_path / f"{name}.v").write_text(text, "utf-8")

    return write


def test_what_coq_is_told_of_a_theorem_is_all_of_it_but_what_is_about_names():
    """Each addition has a false variant that is refuted; but not what a refuted theorem adds."""
    theorems, named = all_theorems(), formal.statements()
    for id, by_hand in named.items():
        names = {name for name in by_hand.additions if not name.endswith(survey.BESIDE)}
        assert theorems[id].expected == "refuted" or {f"{name}__false" for name in names} <= {*by_hand.additions}, id
    for id, accepted in formal.record().items():
        of_names = all(isinstance(claim, Separation) for claim in (*theorems[id].claims, *theorems[id].rounded))
        assert formal.is_formal(theorems[id], accepted) or (of_names and not theorems[id].pinned), id


def test_coq_is_not_asked_about_statements_that_nobody_printed(written):
    texts = {name: (ROOT / "proofs" / "formal" / f"{name}.v").read_text("utf-8") for name in formal.PRINTED}
    written(**texts | {"Statements": texts["Statements"].replace(" >= ", " > ", 1)})
    assert formal.printed_otherwise() == ["Statements.v"]


@needs_coq
def test_coq_accepts_what_the_record_says(request, record_property):
    """Ask Coq only about files that it has not accepted here before; with --long always, theorem by theorem."""
    alone = request.config.getoption("long")
    if alone or not formal.accepted_here():
        accepted = json.loads(formal.RECORD.read_text("utf-8"))["theorems"]
        assert accepted == formal.compile_files(before=None if alone else accepted)
        write_whole(formal.KEPT, formal.accepted_key().encode())
        record_property("agreed", "Coq")
    assert formal.record(), "proofs/formal changed since its record was made: run python -m verify.coq"


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
THEOREMS = "left_out", "assumed", "unguarded", "unpositive"
WHY = "never is assumed to be guarded.*no is assumed to be positive.*three; left_out__proof"


@needs_coq
def test_what_is_not_proved_is_not_accepted(written, monkeypatch):
    """Coq is asked once, for all that these theorems rest on."""
    monkeypatch.setattr(vernacular, "check", lambda text: None)  # which would refuse all of it before Coq reads it
    written(Wrong=WRONG)
    with pytest.raises(formal.NotAccepted, match=WHY):
        formal.compile_files(before={theorem: {"axioms": []} for theorem in THEOREMS})


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


@pytest.mark.parametrize("texts, why", REFUSED)
def test_files_that_cannot_be_ordered_or_could_hide_an_axiom_are_refused(texts, why, written):
    written(**texts)
    with pytest.raises(formal.NotAccepted, match=why):
        formal.statements()


HIDING = [
    f"Module PrimFloat. {AXIOM} End PrimFloat.",
    f"Module (* . *) Uint63. {AXIOM} End Uint63.",
    "Module hit_of_a. Definition t_a := 0. End hit_of_a.",
    'Notation "( x , y )" := ltac:(exact I) : core_scope.',  # of the survey's (statement, I)
    'Infix "+" := Rmult.',
    "Coercion f : A >-> B.",
    "Variable c :> R -> R.",
    "Arguments f {x}.",
    "Definition f {x : R} : R := x.",
    "Definition f [x] (y : R) : R := y.",
    "Definition f@{u v | u < v} := 0.",
    "From Coq Require Export Utf8.",
    "From Coq Require Import -(notations) Reals.",
    f"Proof. 2 : {{ {AXIOM} }} Qed.",
    "Canonical Structure c := d.",
    "#[global] Hint Resolve sin_0.",
    "Set Implicit Arguments.",
    "Inductive no : Type := yes {f : R}.",
    "CoInductive no : Type := yes.",
    "Record pair := { first :> R }.",
    "Fixpoint f (n : nat) := 0 with sin (n : nat) := 0.",
    "From Elsewhere Require Import Sines.",
    "Proof. abstract trivial using PI. Qed.",
    f"(* (* *) *) - {AXIOM}",
    f'(* " *) {AXIOM} (* " *)',
    "(* Lemma a : True.",
    f"Proof. (*) {AXIOM} *) Qed.",
    "Inductive odd : Prop := A : (forall mat(**)ch : nat, True) -> odd with is_derive : Prop := always.",
    "Inductive box : Type := Box { PI (u : unit) : R }.",
    "Definition near := fun (x y : R) {z : unit} => True.",
    "Definition s\u0456n (x : R) := 0.",  # its second letter is Cyrillic
]


@pytest.mark.parametrize("text", HIDING)
def test_what_could_change_how_a_statement_is_read_is_refused(text):
    plain = "(* A {comment}. *) Lemma a (x y : R) : {x = y} + {x <> y}.\nProof. 1: { exact (Req_EM_T x y). }\nQed.\n"
    plain += "From Coq Require Import Reals Lra. Lemma b (l : list R) : l = [1; 2].\nProof. all: intros [x y]. Qed.\n"
    vernacular.check(plain)
    with pytest.raises(vernacular.Unreadable):
        vernacular.check(plain + text)


CLAIMS = """From Coq Require Import Reals.
Open Scope R_scope.
Definition unit_length__true : Prop := forall x : R, sin x = sin x + 0.
Definition unit_length__false : Prop := forall x : R, sin x = 0.
"""
BY_HAND = """From Coq Require Import Reals Lra.
From Formal Require Statements.
Open Scope R_scope.
Theorem unit_length__true : Statements.unit_length__true.
Proof. intro x. lra. Qed.
"""
WORDS = """Theorem unit_length__words : True.
Proof. trivial. Qed.
"""
IN_WORDS = """Theorem unit_length__false : True.
Proof. trivial. Qed.
"""
OF_ANOTHER_SINE = """Definition sin (x : R) : R := 0.
Theorem unit_length__false : Statements.unit_length__false.
Proof. intro x. unfold sin. reflexivity. Qed.
"""


@needs_coq
def test_a_claim_counts_where_its_printed_form_is_proved_and_no_words_count(written):
    written(Statements=CLAIMS, One=BY_HAND + WORDS)
    accepted = formal.compile_files()["unit_length"]
    assert accepted["claims"] == ["unit_length__true"]
    assert accepted["statements"] == {"unit_length__words": "True"}
    assert accepted["axioms"] and {*accepted["axioms"]} <= survey.AXIOMS.keys()
    sine, _ = OF_ANOTHER_SINE.split("\n", 1)
    for false, file in ((OF_ANOTHER_SINE, "One"), (sine, "Names"), (IN_WORDS, "Names")):
        written(One=BY_HAND + false)
        with pytest.raises(formal.NotAccepted, match=f"does not accept {file}"):
            formal.compile_files()


def test_people_can_read_the_files_and_open_them_as_the_command_does():
    texts = [re.sub(r"\d{100,}", "", path.read_text("utf-8")) for path in formal.FOLDER.glob("*.v")]
    assert max(len(line) for text in texts for line in text.splitlines()) <= 160
    assert not [text for text in texts if re.search(r"\bH\d+\b", text)]  # a name that an edit of a claim moves
    project = (formal.FOLDER / "_CoqProject").read_text("utf-8").replace("-arg ", "")
    assert project.split() == [*formal.COQC[1:]]


def test_every_name_that_is_given_by_hand_is_asked_for():
    for text in (
        "Definition sin (x : R) : R := 0.",
        "Lemma sin : R.\nProof. exact 3. Qed.",
        "Inductive odd : Prop := | sin : odd.",
        "Section s.\nVariable sin : Set.\nEnd s.",
    ):
        assert "Fail Check sin." in survey.names_asked(vernacular.named(text), ())


def test_a_record_that_coq_did_not_write_here_is_told_by_its_day_and_raises_no_grade(tmp_path, monkeypatch):
    """Nor does the note kept on this machine, which anybody can write: the run asks whether Coq agreed in it."""
    theorems, here, record = all_theorems().values(), tmp_path / "formal", tmp_path / "record.json"
    record.write_bytes(formal.RECORD.read_bytes())
    monkeypatch.setattr(formal, "KEPT", here)
    monkeypatch.setattr(formal, "RECORD", record)
    day = json.loads(record.read_text("utf-8"))["date"]
    assert formal.record() and formal.when() == f"recorded on {day}, not re-checked here"
    here.write_text(formal.accepted_key())
    assert formal.when() == "accepted here"
    assert len(proved := formal.proved(theorems)) > 50 and "binades" in proved
    cited = {"id": "truncation_bound", "grade": "proved", "uses": [], "cited_lemmas": [{"source": "DLMF"}]}
    monkeypatch.setattr(conftest, "EVIDENCE", [cited])
    for agreed, line in ((set(), "proved, given DLMF"), ({"Coq"}, "proved")):
        monkeypatch.setattr(conftest, "AGREED", agreed)
        assert [entry["grade_line"] for entry in conftest._results()] == [line]
    record.write_bytes(record.read_bytes() + b" ")
    assert formal.record() and not formal.accepted_here()


TRUE = survey.SEPARATOR
SAID, CLOSED = f"unit_length__length\n     : 1 = 1\n{TRUE}", f"{survey.CLOSED}{TRUE}"


@pytest.mark.parametrize(
    "printed, why",
    [
        (SAID + CLOSED, "2 parts, not the 3"),
        (SAID + CLOSED + CLOSED[:9], "2 parts, not the 3"),
        (SAID + CLOSED + CLOSED + "more", "3 parts"),
        (CLOSED + SAID + CLOSED, "was not printed"),
        (SAID.replace("= 1", "= ...") + CLOSED + CLOSED, "in part"),
        (f"{SAID}Axioms:\n{TRUE}{CLOSED}", "rests on"),
        (f"{SAID}{TRUE}{CLOSED}", "rests on"),
        (f"{SAID}{CLOSED}Section Variables:\nx : R\n{TRUE}", "false variant rests on"),
        (f"{SAID}Axioms:\nClassical_Prop.classic relies on an unsafe hierarchy.\n{TRUE}{CLOSED}", "unsafe hierarchy"),
    ],
)
def test_a_survey_that_is_cut_short_or_says_more_than_axioms_is_refused(printed, why):
    named = {"unit_length": survey.Formalization({}, {"unit_length__length": []})}
    with pytest.raises(formal.NotAccepted, match=why):
        survey.read(named, [], survey.groups(named, {}), printed)


x = real("x")


def test_a_second_derivative_of_corners_has_no_proposition():
    """Coq has the number 0 for a sign's derivative, at 0 too."""
    with pytest.raises(ValueError, match="second one of corners"):
        proposition(Claim("one", equation(Derivative(sign(x), x, 2), 0)))


ONE_NAME = [("a", "b__c"), ("a", "b__c")], [("a__b", "c")], [("a", "c : Prop := True. Definition d")]


@pytest.mark.parametrize("named", ONE_NAME)
def test_a_printed_name_is_a_name_and_one_claims(named):
    of = {"rounded": (), "expected": "proved"}
    claims = [SimpleNamespace(id=id, claims=[Claim(name, x + 1 > x)], **of) for id, name in named]
    with pytest.raises(ValueError, match="no name in Coq"):
        statements_of(claims)


SAYS = dict(
    line.split()
    for line in r"""
        \\sin\b                             \bsin
        \\cos\b                             \bcos
        \\max\b                             Rmax
        \\min\b                             Rmin
        \\arctan                            \batan
        \bwhole\b|any\snumber|any\sorder    \b(nat|Z|INR)\b
        exactly\s(if|on)\b                  <->
        no\sderivative                      ~\s*ex_derive
        float64|mathrm\{fl                  float64
        \btends?\sto\b                      \b(filterlim|is_lim)\b
        \bRMS\b                             \bis_RInt\b
    """.strip().splitlines()
)
"""{a function, a quantifier or a limit in words: in a statement}; of the last three the other way, too."""
NUMBER, QUOTIENT = re.compile(r"(?<![\w'.])(\d+(?:\.\d+)?)(?:\s?\^\s?\{?-?(\d+))?"), r"(\d+) / (\d+)"
SPELLED = {
    r"(?<=\d)\{?,\}?(?=\d{3})|_(\w|\{[^}]*\})|float64": "",
    r"(?<=\d)e(?=-?\d)": "*10^",
    r"frac(\d)": r" \1 ",
    r"\\cdot": " ",
    "²": "^2",
}
WORDED = {id: theorem for id, theorem in all_theorems().items() if theorem.expected != "refuted"}
OTHERWISE = {"silhouette_of_a", "visible_iff", "normalising_is_lipschitz", "specular_lipschitz"}
"""Of cos φ = R/e, of a minimum, of p = 1, 2, … and of "exactly if" these have two claims, or another form."""
UNSAID = {
    "binades": {2, 52},
    "enclosing_rules": {2**28},
    "forward_and_fourth_order": {5},
    "seed_covers_the_view": {Fraction("2.0876"), 3},
    "third_derivative_at_eight": {2000},
}
"""{theorem: numbers in a clause that name a symbol or a limit, or are an expression's value, or the seed's}"""


@cache
def clause_texts(id):
    """Return the text of what says each clause of a theorem; of one that claims nothing, of how it is measured."""
    theorem, record = WORDED[id], formal.record()
    texts = statements(theorem) | {pin.name: recorded.in_full(pin.name, record) for pin in theorem.pinned}
    if not texts:
        functions = [(function, function()) for function, _ in measurements()[id]]
        texts = {f: f"{signature(f)} {getsource(f)} {float(e.bound)} {vars(e)}" for f, e in functions}
    if isinstance(theorem.statement, str):
        return ["\n".join(texts.values())]
    names = [[c.name if isinstance(c, Pinned) else f"{id}__{c.name}" for c in each.claims] for each in theorem.clauses]
    return ["\n".join(texts.get(name, "") for name in each) for each in names]


def beyond(id, *clauses):
    """Return the numbers of a theorem's clauses, or of some in their place, that nothing says of each."""
    more = set()
    for says, words in zip(clause_texts(id), clauses or [clause.text for clause in WORDED[id].clauses], strict=True):
        quotients = {Fraction(int(a), int(b)) for a, b in re.findall(QUOTIENT, says) if int(b)}
        more |= _numbers(words) - _with_exponents(says) - quotients
    return more - UNSAID.get(id, set()) - {0, 1}


def lacking(id, cut=""):
    """Return what a theorem's words, without some of them, lack of what it pins, and of claims of float64: numbers, the
    names of these, and that nothing overflows. A hypothesis that names some of the claims is one of these alone.
    """
    theorem, record, claims = WORDED[id], formal.record(), statements(WORDED[id])
    words, *hypotheses = [text.replace(cut, "").lower() for text in (theorem.words, *theorem.hypotheses)]
    names = [claim.name.partition("_")[0] for claim in theorem.rounded]
    missing = {name for name in [*names, *["overflows"] * bool(names)] if name not in " ".join([words, *hypotheses])}
    stated_by = [(recorded.in_full(pin.name, record), hypotheses) for pin in theorem.pinned]
    for name, claim in zip(names, theorem.rounded, strict=True):
        stated = [text for text in hypotheses if name in text or not any(map(text.count, names))]
        stated_by.append((claims[f"{id}__{claim.name}"], stated))
    for text, stated in stated_by:
        given = " ".join([words, *stated])
        exact = _with_exponents(given)
        other = re.sub(QUOTIENT, lambda q, of=exact: "" if Fraction(int(q[1]), int(q[2])) in of else q[0], text)
        missing |= _numbers(other) - exact - {0, 1, 2}
        for wording, statement in [*SAYS.items()][-3:]:
            missing |= set() if re.search(wording, given, re.I) else {*re.findall(statement, text)}
    return missing


@pytest.mark.parametrize("id", WORDED)
def test_words_have_the_numbers_functions_and_quantifiers_of_what_is_pinned_and_claimed(id):
    theorem, says = WORDED[id], "\n".join(clause_texts(id))
    if theorem.expected == "proved" and id not in OTHERWISE:
        assert any(isinstance(claim, Induction) for claim in theorem.claims) <= bool(re.search("whole", theorem.words))
        for words, statement in SAYS.items():
            assert not re.search(words, theorem.words) or re.search(statement, says), words
    assert not beyond(id) and not lacking(id)


CUTS = {
    "colour_accuracy": [("light and albedo are at most $2^{20}$", {2**20}), ("nothing overflows", {"overflows"})],
    "gradient_accuracy": [
        ("exact gradient of sine, ridges and rings", {"sine", "ridges"}),
        ("at least $10^{-285}$", {10**285}),
    ],
    "enclosing_rules": [("a count of at most $2^{52} x$", {2**52})],
}


@pytest.mark.parametrize("id", CUTS)
def test_words_that_are_left_out_are_found(id):
    for cut, missing in CUTS[id]:
        assert lacking(id, cut) == missing


OTHERS = [
    ("crease_products", "1,756", "1,765"),
    ("sine_of_half_turns", "2^{-53}", "2^{-52}"),
    ("pole_accuracy", "10^{-12}", "10^{-13}"),
    ("gradient_accuracy", "2^{20}", "2^{30}"),
    ("truncation_bound", "6", "7"),
    ("unit_length", r"\ge 1", r"\ge 3"),
    ("difference_slopes", "p = 2", "p = 4"),  # which another clause says
]


@pytest.mark.parametrize("id, number, other", OTHERS)
def test_another_number_in_words_is_found(id, number, other):
    clauses = [clause.text for clause in WORDED[id].clauses]
    assert number in "".join(clauses) and beyond(id, *(text.replace(number, other) for text in clauses))


def test_a_theorem_whose_pin_or_claim_of_float64_is_not_what_coq_proved_fails_and_is_not_formal(monkeypatch):
    accepted = json.loads(formal.RECORD.read_text("utf-8"))["theorems"]
    text = recorded.in_full("binades__tie", accepted)
    added = dict.fromkeys((f"binades__{name}" for name in ("bare", "idle", "empty", "half", "void")), text)
    added |= {"binades__idle__false": "~ False", "binades__empty__false": text, "binades__half__false": f"~ ({text})"}
    added |= {"binades__void__false": f"~ ({text})", "binades__void__point": "True"}
    accepted["binades"]["statements"] |= added
    monkeypatch.setattr(recorded, "record", lambda: accepted)
    for pin, why in (
        (Pinned("binades__tie", recorded.digest(text)), ""),
        (Pinned("binades__tie", recorded.digest(text.replace("2 ^ 52", "2 ^ 51"))), "Coq proves another binades__tie"),
        (Pinned("binades__none", recorded.digest(text)), "binades__none is not in Coq's record"),
        (Pinned("binades__bare", recorded.digest(text)), "binades__bare has no false variant"),
        (Pinned("binades__idle", recorded.digest(text)), "binades__idle has no false variant"),
        (Pinned("binades__empty", recorded.digest(text)), "binades__empty has no false variant"),
        (Pinned("binades__half", recorded.digest(text)), "binades__half has no point"),
        (Pinned("binades__void", recorded.digest(text)), "binades__void has no point"),
    ):
        theorem = Theorem("binades", "", {"At a tie.": pin})
        examination = proof_checker.examine(theorem)
        assert examination.grade == ("failed" if why else "proved")
        assert all(problem.startswith(why) for problem in examination.problems)
        assert formal.is_formal(theorem, None) == (not why)
    of_float64 = all_theorems()["colour_accuracy"]
    for claims, grade in ((accepted[of_float64.id]["claims"], "proved"), ([], "failed")):
        accepted[of_float64.id] = {"claims": claims}
        assert proof_checker.examine(of_float64).grade == grade
    with pytest.raises(ValueError, match="pins what is another theorem's: binades__tie"):
        Theorem("pole", "", {"At a tie.": Pinned("binades__tie", "")})


def _numbers(text):
    """Return the numbers in a text, in TeX's fractions each by itself, of powers their size; none of a subscript."""
    for form, plain in SPELLED.items():
        text = re.sub(form, plain, text)
    return {Fraction(base) ** int(power or 1) for base, power in NUMBER.findall(text)}


def _with_exponents(text):
    return _numbers(text) | {*map(Fraction, re.findall(r"(?<![\w.])\d+", text))}


def test_the_roundings_that_steps_name_are_those_of_the_proof():
    proof = (formal.FOLDER / "RoundedGradient.v").read_text("utf-8")
    words = " ".join(step.what for step in all_theorems()["gradient_accuracy"].steps)
    named = re.findall(r"(\d+)\.(\d+)\\mu", words)
    assert len(named) == 2
    assert all(f" <= {int(integer + digits)}/{10 ** len(digits)} / 2 ^ 53" in proof for integer, digits in named)


SMALL = "Lemma small : forall n, n = 0 + n.\nProof.\n  intros. (* A comment. *) reflexivity.\nQed.\n"


@needs_coq
def test_each_sentence_has_the_goals_that_it_leaves(written, tmp_path, monkeypatch):
    written(Small=SMALL)
    monkeypatch.setattr(goals, "RECORD", tmp_path / "goals")
    monkeypatch.setattr(goals, "record", goals.record.__wrapped__)
    goals.write(tmp_path, ["Small"], ())
    left = {SMALL[start:end]: text for start, end, text in goals.steps_of(tmp_path / "Small.v")}
    assert [*left] == ["Lemma small : forall n, n = 0 + n.", "Proof.", "intros.", "reflexivity.", "Qed."]
    assert left["intros."].split("=====")[0].split() == ["1", "goal", "n", ":", "nat"]
    assert [*left.values()][3:] == ["No more goals.", ""]
    written(Small=SMALL.replace("intros", "intro"))
    assert goals.steps_of(tmp_path / "Small.v") == []


def test_goals_are_recorded_of_every_proof_as_it_is():
    """Goals are recorded to the end of each file, and no sentence was an error."""
    for path in (path for path in formal.FOLDER.glob("*.v") if path.stem not in formal.GIVEN):
        steps = goals.steps_of(path)
        assert steps, f"{path.name}: python -m verify.coq records its goals"
        assert not re.sub(rb"\(\*.*?\*\)", b"", path.read_bytes()[steps[-1][1] :], flags=re.DOTALL).strip(), path.name
        assert not any(re.search("^(Error|Toplevel input)", left, re.MULTILINE) for *_, left in steps), path.name
