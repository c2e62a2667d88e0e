"""The ledger of claims: it stands as it is, and every kind of false entry is refused by name."""

import re
from collections import Counter
from dataclasses import replace
from types import SimpleNamespace

import pytest
from sphinx.errors import ExtensionError

from book.extension.ledger import require_ledger
from book.ledger import check
from book.ledger.__main__ import main
from book.ledger.check import Run, faults_in
from book.ledger.entries import CONDITIONAL, FINDINGS, OUTSIDE, WORDS, load, relation
from renderer.intervals import Interval
from verify.evidence.sources import ROOT

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
    entries={
        "no_flips": {"grade": "proved", "expected": "proved"},
        "descent": {"grade": "refuted", "expected": "refuted"},
    },
    pages=frozenset({"s3"}),
    sources=frozenset({"Blinn1978"}),
    number=number,
)


@pytest.fixture
def faults(tmp_path):
    """A function: the faults of a small ledger, its text changed as asked."""

    def of_changed(old="", new=""):
        assert old in TRUE
        (tmp_path / "claims").mkdir(exist_ok=True)
        (tmp_path / "claims" / "some.toml").write_text(TRUE.replace(old, new, 1))
        (tmp_path / "places.toml").write_text('[places]\ncell3 = "Cell 3"\n')
        return faults_in(load(tmp_path), RUN)

    return of_changed


def test_a_true_ledger_has_no_faults_and_a_grade_that_fell_is_one(faults, monkeypatch):
    assert faults() == []
    monkeypatch.setitem(RUN.entries["no_flips"], "grade", "failed")
    assert faults() == ["some.toml: flips: evidence no_flips: grade: proved is expected, the run made it failed"]


HOLDS, SOURCE = 'verdict = "holds"', '{ source = "Blinn1978" }'
CONDITION, REASON = (HOLDS.replace("holds", verdict) for verdict in (CONDITIONAL, OUTSIDE))
REFUSED = {
    "an entry that says too little, or what it may not": [
        ('id = "falls"', 'id = "flips"', "flips: id: two claims"),
        ('so = "It falls like the root."', "", "falls: 'so' is a required"),
        (HOLDS, CONDITION, "flips: 'condition' is a required"),
        (HOLDS, REASON, "flips: 'reason' is a required"),
        ('is = "== 0"', 'is = "about 0"', "flips evidence 1 is: 'about 0': allowed is one of =="),
        ('is = "== 0"', 'is = "in [1]"', "flips evidence 1 is: 'in [1]': allowed"),
        ('is = "== 0"', 'is = "< 1 and > 0"', "flips evidence 1 is: '< 1 and > 0': allowed"),
        (SOURCE, '{ hearsay = "x" }', "falls evidence 3: {'hearsay': 'x'} is not valid"),
        ('words = "No', "words = No", "Invalid value"),
        ('"{number}`sweep.flips` flips"', '"some flips"', "flips merit: 'some flips': it has to show a {number}"),
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
        ('verdict = "false"', HOLDS, "falls: verdict: 'holds', but descent, sweep.slope refutes it"),
        (HOLDS, 'verdict = "false"', "flips: verdict: 'false', and none of its evidence refutes it"),
        ('"no_flips" }', '"no_flips", refutes = true }', "flips: verdict: 'holds', but no_flips"),
        (f"{HOLDS}\n{EVIDENCE}", f'{CONDITION}\ncondition = "c"\nevidence = [{{ theorem = "descent" }}]',
         "flips: verdict: 'holds with a condition', but all of its evidence refutes it"),
    ],
    "orphans": [
        # Of its evidence the number refutes the claim by itself, since the claim's own relation fails.
        ('{ theorem = "descent" },', "", "theorem descent: no claim rests on it"),
        ('"F7", ', "", "finding F7: no claim has it"),
        ('"F7", ', '"F7", "F99", ', "finding F99: findings.toml has no name for it"),
        ('where = "seed:cell3"', 'where = "s3"', "place cell3: no claim of the seed stands there"),
    ],
}  # fmt: skip
"""{what is refused: [(old, new, a fault of the ledger with that change)]}"""


@pytest.mark.parametrize("case", REFUSED)
def test_what_is_refused(faults, case):
    for old, new, fault in REFUSED[case]:
        lines = faults(old, new)
        assert any(line.removeprefix("some.toml: ").startswith(fault) for line in lines), lines
        assert case != "orphans" or len(lines) == 1


def test_relations():
    for text, yes, no in (
        ("!= 0", 1e-300, 0),
        ("< 1e-12", 1e-13, 1e-12),
        ("<= 2", 2, 2.1),
        ("in [0.4, 0.6]", Interval(0.5, 0.4, 0.6), Interval(0.5, 0.39, 0.6)),  # certainly, where a number has ends
        ("> 0.3", Interval(0.5, 0.4, 0.6), Interval(0.5, 0.3, 0.6)),
    ):
        assert relation(text).holds(yes) and not relation(text).holds(no), text
    with pytest.raises(ValueError, match="ends before it begins"):
        relation("in [2, 1]")


def test_the_ledger_stands(site):
    """Against the run that built the site."""
    assert main([]) == 0
    used = {piece.name for claim in load().claims for piece in claim.evidence if piece.kind == "number"}
    assert used == WORDS.keys()


def test_a_build_stops_where_the_ledger_does_not_stand(site, monkeypatch):
    ledger = load()
    claims = tuple(replace(claim, verdict="false") if claim.id == "ledger_flips" else claim for claim in ledger.claims)
    monkeypatch.setattr(check, "load", lambda: replace(ledger, claims=claims))
    with pytest.raises(ExtensionError, match="ledger_flips: verdict: 'false', and none of its evidence refutes it"):
        require_ledger(SimpleNamespace(srcdir=ROOT / "book"))


def test_the_pages_have_every_claim_and_every_code(html_of):
    findings, seed = map(html_of, ("findings", "seed"))
    ids = Counter(re.findall(r'id="([^"]+)"', findings))
    for claim in load().claims:
        assert ids[f"claim-{claim.id}"] == 1
        assert f"findings.html#claim-{claim.id}" in seed or not claim.of_seed
    assert all(ids[code] == 1 and f'href="#{code}"' in findings for code in FINDINGS)


def test_a_claim_opens_where_a_link_leads_to_it(visit):
    page = visit("findings", fragment="#F3")
    assert page.is_visible("#F3") and page.is_visible("#claim-frame_aligned_with_n .claim-so")
