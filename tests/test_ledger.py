"""The ledger of claims: it stands as it is, and every kind of false entry is refused by name."""

import re
import shutil
import textwrap
from collections import Counter
from dataclasses import replace
from types import SimpleNamespace

import pytest
from sphinx.errors import ExtensionError

import book.ledger
from book.extension.ledger import require_ledger
from book.ledger import BadLedger, load
from book.ledger.check import Run, faults_in, last_run, node_exists
from book.ledger.entries import FINDINGS, FOLDER, WORDS, relation
from renderer.picture.differences import Interval
from tests.processes import python
from verify.sources import ROOT

NUMBERS = {"sweep.flips": 0, "sweep.slope": 0.55, "scene.field": "ridges"}
EVIDENCE = 'evidence = [{ theorem = "no_flips" }, { number = "sweep.flips", is = "== 0" }]'
TRUE = """
[[claim]]
id = "flips"
words = "No pixel changes its chamber."
where = "s3"
findings = [FINDINGS]
verdict = "holds"
EVIDENCE
merit = "{number}`sweep.flips` flips"
so = "None of them does."

[[claim]]
id = "falls"
words = "The table descends the truncation slope."
where = "seed:cell3"
verdict = "false"
evidence = [
  { theorem = "descent" },
  { number = "sweep.slope", is = "in [0.5, 0.6]", claimed = "in [1.9, 2.1]" },
  { test = "tests/test_ledger.py::test_relations" },
  { source = "Blinn1978" },
]
merit = "slope {number}`sweep.slope|.2f`"
so = "It falls like the root."
""".replace("FINDINGS", ", ".join(f'"{code}"' for code in FINDINGS)).replace("EVIDENCE", EVIDENCE)


def number(name):
    """A number of the small run below."""
    if name not in NUMBERS:
        raise ValueError(f"{name}: no such number")
    return NUMBERS[name]


RUN = Run(
    grades={"no_flips": "proved", "descent": "refuted"},
    expected={"no_flips": "proved", "descent": "refuted"},
    pages=frozenset({"s3"}),
    sources=frozenset({"Blinn1978"}),
    number=number,
    test=lambda node: node_exists(ROOT, node),
)


@pytest.fixture
def faults(tmp_path):
    """A function: the faults of a small ledger, its text changed as asked."""

    def of_changed(old="", new=""):
        assert old in TRUE
        (tmp_path / "claims").mkdir(exist_ok=True)
        (tmp_path / "claims" / "some.toml").write_text(TRUE.replace(old, new, 1))
        (tmp_path / "places.toml").write_text('[places]\ncell3 = "Cell 3"\n')
        try:
            return faults_in(load(tmp_path), RUN)
        except BadLedger as error:
            return error.faults

    return of_changed


def test_a_grade_that_fell_is_a_fault_of_every_claim_that_rests_on_it(faults, monkeypatch):
    monkeypatch.setitem(RUN.grades, "no_flips", "failed")
    assert faults() == ["flips: evidence no_flips: grade: proved is expected, the run made it failed"]


def test_a_true_ledger_has_no_faults(faults):
    assert faults() == []


REFUSED = {
    "an entry that says too little": [
        ('id = "falls"', 'id = "flips"', "flips: id: two claims"),
        ('id = "falls"', 'id = "De scends"', "De scends id: 'De scends' does not match"),
        ('words = "No pixel changes its chamber."', "", "flips: 'words' is a required"),
        ('where = "s3"', 'where = "s3"\nmood = "grim"', "flips: Additional properties are not allowed ('mood'"),
        ('verdict = "false"', 'verdict = "wrong"', "falls verdict: 'wrong' is not one of ['false', 'corrected'"),
        ('"F22"', '"G22"', "flips findings 21: 'G22' does not match"),
        ('so = "It falls like the root."', "", "falls: 'so' is a required"),
        ('verdict = "holds"', 'verdict = "holds with a condition"', "flips: 'condition' is a required"),
        ('verdict = "holds"', 'verdict = "outside this chapter: not checked"', "flips: 'reason' is a required"),
        ('verdict = "holds"', 'verdict = "outside this chapter: not checked"', "flips evidence: [{'theorem'"),
        ('where = "s3"', 'where = "s3"\ncondition = "c"', "flips condition: 'c' should not be"),
        ('merit = "{number}`sweep.flips` flips"', "", "flips: 'merit' is a required"),
        ('merit = "{number}`sweep.flips` flips"', 'merit = "0 flips"', "flips merit: '0 flips' does not match"),
        ('is = "== 0"', 'is = "about 0"', "flips evidence 1 is: 'about 0' is not a 'relation': allowed is one of =="),
        ('{ source = "Blinn1978" }', '{ hearsay = "x" }', "falls evidence 3: {'hearsay': 'x'} is not valid"),
        ('{ source = "Blinn1978" }', '{ source = "Blinn1978", page = 1 }', "falls evidence 3: Additional properties"),
        ('{ source = "Blinn1978" }', '{ source = "x", test = "y" }', "falls evidence 3: Additional properties"),
        ('[[claim]]', '[[clam]]', "some.toml: Additional properties are not allowed ('clam'"),
        ('words = "No', "words = No", "some.toml:"),
        (EVIDENCE, "", "flips: 'evidence' is a required"),
    ],
    "evidence that the run does not bear out": [
        ('"no_flips"', '"no_flip"', "flips: evidence no_flip: theorem: no theorem has this id"),
        ('is = "== 0"', 'is = "> 0"', "flips: evidence sweep.flips: is: > 0 is expected, the run has 0"),
        ('number = "sweep.flips"', 'number = "sweep.flops"', "flips: evidence sweep.flops: number: sweep.flops"),
        ('number = "sweep.flips"', 'number = "scene.field"', "flips: evidence scene.field: number: it is the text"),
        ("::test_relations", "::test_nothing", "falls: evidence tests/test_ledger.py::test_nothing: test: there is no"),
        ("Blinn1978", "Blinn1979", "falls: evidence Blinn1979: source: the bibliography has no such key"),
        ('where = "s3"', 'where = "s33"', "flips: where: 's33' is no page"),
        ("seed:cell3", "seed:cell9", "falls: where: 'cell9' is no place of the seed"),
    ],
    "a verdict that its evidence contradicts": [
        ('verdict = "false"', 'verdict = "holds"', "falls: verdict: 'holds', but descent, sweep.slope refutes it"),
        ('verdict = "holds"', 'verdict = "false"', "flips: verdict: 'false', and none of its evidence refutes it"),
        ('verdict = "holds"', 'verdict = "corrected"', "flips: verdict: 'corrected', and none"),
        ('is = "== 0" }', 'is = "== 0", claimed = "> 0" }', "flips: verdict: 'holds', but sweep.flips refutes it"),
        ('"no_flips" }', '"no_flips", refutes = true }', "flips: verdict: 'holds', but no_flips"),
        (f'verdict = "holds"\n{EVIDENCE}', 'verdict = "holds with a condition"\ncondition = "c"\n'
         'evidence = [{ theorem = "descent" }]',
         "flips: verdict: 'holds with a condition', but all of its evidence refutes it"),
    ],
    "orphans": [
        ('{ theorem = "descent" },', "", "theorem descent: no claim rests on it"),
        ('"F7", ', "", "finding F7: no claim has it"),
        ('"F7", ', '"F7", "F99", ', "finding F99: findings.toml has no name for it"),
        ('where = "seed:cell3"', 'where = "s3"', "place cell3: no claim of the seed stands there"),
    ],
}  # fmt: skip
"""{what is refused: [(old, new, a fault of the ledger with that change)]}"""


@pytest.mark.parametrize(("old", "new", "fault"), [row for rows in REFUSED.values() for row in rows])
def test_what_is_refused(faults, old, new, fault):
    assert any(line.startswith(fault) for line in faults(old, new)), faults(old, new)


def test_a_number_refutes_only_where_the_claims_own_relation_fails(faults):
    without = faults('  { theorem = "descent" },\n', "")
    assert without == ["theorem descent: no claim rests on it"]  # the number alone refutes it
    kept = faults('claimed = "in [1.9, 2.1]"', 'claimed = "in [0.5, 0.6]"')
    assert kept == []  # the theorem still does


@pytest.mark.parametrize(
    ("text", "yes", "no"),
    [
        ("== 0", 0, 1e-300),
        ("!= 0", 1, 0),
        ("< 1e-12", 1e-13, 1e-12),
        ("<= 2", 2, 2.1),
        ("> -1", 0, -1),
        (">= 3", 3, 2),
        ("in [0.45, 0.65]", 0.65, 0.66),
    ],
)
def test_relations(text, yes, no):
    assert relation(text).holds(yes)
    assert not relation(text).holds(no)


@pytest.mark.parametrize("ends", [(0.4, 0.6), (0.4, 0.5), (0.5, 0.6)])
def test_a_number_with_ends_has_to_satisfy_a_relation_certainly(ends):
    value = Interval(0.5, *ends)
    assert relation("in [0.4, 0.6]").holds(value)
    assert not relation("in [0.41, 0.59]").holds(value)
    assert not relation("== 0.5").holds(value)


@pytest.mark.parametrize("text", ["", "0", "= 0", "== zero", "in [2, 1]", "in [1]", "< 1 and > 0", 3])
def test_what_is_no_relation(text):
    with pytest.raises(ValueError, match="is not a relation; allowed is"):
        relation(text)


def test_node_ids_are_looked_up():
    assert node_exists(ROOT, "tests/test_ledger.py::test_relations")
    assert node_exists(ROOT, "tests/test_ledger.py::test_relations[== 0-0-1e-300]")
    nodes = "tests/test_ledger.py", "tests/test_ledger.py::number", "tests/test_gone.py::test_relations"
    assert not any(node_exists(ROOT, node) for node in nodes)


def test_all_findings_and_all_places_of_the_seed_are_there():
    ledger = load()
    codes = [f"F{number}" for number in range(1, len(FINDINGS) + 1)]
    assert {code for claim in ledger.claims for code in claim.findings} == set(codes) and list(FINDINGS) == codes
    cells = {f"cell{number}{part}" for number in range(1, 9) for part in ("", ".expect")}
    tries, pitfalls = {f"s4.try{number}" for number in range(1, 5)}, {f"s7.{number}" for number in range(1, 7)}
    assert cells | tries | pitfalls <= ledger.places.keys()


def test_the_ledger_stands(site):
    """Against the run that built the site."""
    assert faults_in(load(), last_run()) == []
    said, _ = python("-m", "book.ledger")
    assert f"{len(load().claims)} claims" in said


def test_one_more_entry_is_one_more_claim(site, tmp_path):
    """The example of the docstring, put into a file of its own beside the others."""
    folder = tmp_path / "ledger"
    shutil.copytree(FOLDER, folder)
    example = re.search(r"^    \[\[claim\]\]\n(?:    .*\n)+", book.ledger.__doc__, re.MULTILINE)[0]
    (folder / "claims" / "newcomer.toml").write_text(textwrap.dedent(example))
    assert len(load(folder).claims) == len(load().claims) + 1
    assert faults_in(load(folder), last_run()) == []


def test_a_build_stops_where_the_ledger_does_not_stand(site, monkeypatch):
    whole = load()
    claims = tuple(replace(claim, verdict="false") if claim.id == "ledger_flips" else claim for claim in whole.claims)
    monkeypatch.setattr(book.ledger, "load", lambda: replace(whole, claims=claims))
    with pytest.raises(ExtensionError, match="ledger_flips: verdict: 'false', and none of its evidence refutes it"):
        require_ledger(SimpleNamespace(srcdir=ROOT / "book"))


def test_the_pages_have_every_claim_and_every_code(site):
    findings, ledger, pitfalls = ((site / f"{name}.html").read_text("utf-8") for name in ("findings", "s6", "s7"))
    ids = Counter(re.findall(r'id="([^"]+)"', findings))
    for claim in load().claims:
        link = f"findings.html#claim-{claim.id}"
        assert ids[f"claim-{claim.id}"] == 1
        assert link in ledger or not claim.where.startswith("seed:s6")
        assert link in pitfalls or not claim.id.startswith("pitfall_")
    assert all(ids[code] == 1 and f'href="#{code}"' in findings for code in FINDINGS)


def test_every_number_that_is_evidence_has_words():
    used = {piece.name for claim in load().claims for piece in claim.evidence if piece.kind == "number"}
    assert used == WORDS.keys()


def test_a_claim_opens_where_a_link_leads_to_it_and_needs_no_script_to_open(visit):
    for script in (True, False):
        page = visit("findings", fragment="#F3", java_script_enabled=script)
        claim = page.locator("#claim-frame_aligned_with_n")
        assert page.locator("#F3").is_visible() and claim.locator(".claim-so").is_visible() == script
        if not script:
            claim.locator("summary").click()
            assert claim.locator(".claim-so").is_visible()
