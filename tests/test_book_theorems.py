"""Theorems in the book: the card is the checked object's, and what did not reach its grade does not build."""

import html
import re
from itertools import count

import pytest
from sympy import evaluate, pi, symbols

from book.assembly import report
from book.assembly.contents import page_files
from book.editions.pages import parsed
from book.extension.cards import OPEN
from book.extension.evidence import evidence_line
from book.extension.printed_claims import rows
from book.extension.theorems import certificate, load, placements
from proofs.engine.claim import Claim, equation, greater
from proofs.engine.half_turns import sinpi
from proofs.engine.theorem import all_theorems
from tests import one_page
from tests.processes import python
from verify.coq import formal
from verify.evidence.sources import ROOT

THEOREMS = all_theorems()
CARD = re.compile(r'<section class="theorem [^>]*id="theorem-(\w+)".*?</section>', re.DOTALL)


@pytest.fixture(scope="module")
def proofs(site):
    """The proofs that the site was built from."""
    return load(ROOT / "book")


@pytest.fixture(scope="module")
def cards(html_of):
    """Theorem → its card, in the order of the pages."""
    pages = map(html_of, page_files(ROOT / "book"))
    return {match[1]: parsed(match[0]) for page in pages for match in CARD.finditer(page)}


# The cards of the site


def test_each_statement_of_coqs_leads_to_its_proof_and_goals(cards, html_of):
    links = [tuple(link["href"].split(".html#")) for card in cards.values() for link in card.select(".site-only a")]
    steps = ((page, step) for page in dict(links) for step in parsed(html_of(page)).select("details[id]"))
    assert len(links) > len(THEOREMS) and {*links} <= {(page, step["id"]) for page, step in steps if step.pre.text}


def test_every_card_says_what_its_checked_object_says(cards, proofs):
    assert cards.keys() == THEOREMS.keys()
    chapter, lemmas = count(1), count(1)
    for id, card in cards.items():
        theorem, title = THEOREMS[id], card.select_one(".theorem-title").extract()
        number = f"A.{next(lemmas)}" if proofs.places[id] == "lemmas" else next(chapter)
        assert title.strong.get_text() == f"{'Claim' if theorem.refuted_at else proofs.label(id).split()[0]} {number}"
        for formula in card.select("math"):
            formula.replace_with(f"${formula['data-tex']}$")
        is_formal = proofs.entries[id]["shown"] == "formal"
        words = [word.extract().get_text() for word in card.select(".grade-word")]
        assert [word for word in words if "Coq" in word] == [f"Coq, {formal.when()}:"] * is_formal
        (statement,) = card.select(".statement")
        brief = [text.get_text().strip().replace("’", "'") for text in card.select(".brief")]
        assert brief == [" ".join(clause.text for clause in theorem.short)] * bool(theorem.short)
        pinned = [text.get_text().removeprefix("Theorem ") for text in card.select("details.coq[open] pre")]
        assert [text.split(" :", 1)[0] for text in pinned] == [pin.name for pin in theorem.pinned]
        assert statement.get_text().strip().replace("’", "'") == theorem.words.replace("*", "")  # which stress a word
        assert len(card.select(".given dd")) == sum(len(claim.given) for claim in theorem.rounded)
        claims = *(c for clause in theorem.clauses for c in clause.claims if c in theorem.claims), *theorem.rounded
        printed = card.select(":is(details, noscript) > .claim")
        for shown, claim in zip(printed, claims, strict=True):
            assert shown.dl["aria-label"] == f"Claim {claim.name}" and len(shown.dl.select("dd")) <= OPEN
            assert sorted(row.get_text() for row in shown.select("dd")) == sorted(f"${row.tex}$" for row in rows(claim))
        assert f"pytest verify --theorem {id}" in card.get_text()


def test_findings_list_every_theorem_with_its_evidence(html_of, cards, proofs):
    page = html.unescape(html_of("findings"))
    for id, entry in proofs.entries.items():
        assert f'#theorem-{id}"' in page and evidence_line(entry) in page


def test_every_theorem_is_listed_below_what_it_rests_on_with_links_to_the_cards(html_of):
    aims = {
        row["id"].removeprefix("node-"): [link["href"].partition("#theorem-")[2] for link in row.select("a")]
        for row in parsed(html_of("dependencies")).select(".claim-list > li")
    }
    order = [*aims]
    assert sorted(order) == sorted(THEOREMS)
    assert all(order.index(other) < order.index(id) for id in order for other in THEOREMS[id].uses)
    assert all(first == id and {*others} == {*THEOREMS[id].uses} for id, (first, *others) in aims.items())


def test_certificates_are_downloads_and_scripts_run_with_nothing_but_python(site, tmp_path):
    folder = site / "_downloads/theorems"
    certified = {id: path for id in THEOREMS if (path := certificate(id))}
    assert {path.stem for path in folder.glob("*.py")} == certified.keys()
    for id, path in certified.items():
        assert (folder / f"{id}.json").read_bytes() == path.read_bytes()
        python("-I", "-S", folder / f"{id}.py", cwd=tmp_path, timeout=60)


# Builds that fail


def test_what_is_unknown_or_did_not_reach_its_grade_fails_the_build(site, tmp_path, monkeypatch):
    entries, asked = report.load(), report.asked()
    entries["unit_length"]["grade"] = "failed"
    monkeypatch.setattr(report, "load", lambda: entries)
    monkeypatch.setattr(report, "asked", lambda: dict.fromkeys(asked, False))
    failed = "'unit_length' is expected to be proved; its last run made it failed"
    (tmp_path / "index.md").write_text(2 * ":::{theorem} one\n:::\n")
    with pytest.raises(ValueError, match="'one' is placed twice, on index and on index"):
        placements(tmp_path, ())
    mistakes = {
        ":::{theorem} kink_locus\n:::": "unknown theorem 'kink_locus'; there are: .*kink_loci",
        "{theorem-ref}`kink_locus`": "unknown theorem 'kink_locus'",
        ":::{theorem} unit_length\n:::": failed,
        "{theorem-ref}`unit_length`": failed,
    }
    page = one_page.refused(tmp_path, mistakes, ":::{grades}\n:asked:\n:::")
    assert "accepted on another day is recorded, not re-checked here" in page and "second checker did not" in page


def test_a_report_that_is_stale_or_edited_by_hand_is_refused(stamped, monkeypatch):
    sources, path, text = report.reported_hashes(), stamped / "proofs.json", '{"theorems": [{"id": "refuted"}]}'
    path.write_text(text)
    monkeypatch.setattr(report, "REPORT", path)
    monkeypatch.setattr(report, "reported_hashes", lambda: sources)
    report.remember(sources)
    assert report.load() == {"refuted": {"id": "refuted"}}
    for written, edit in (("proved", {}), ("refuted", {"a.py": "0"})):
        path.write_text(text.replace("refuted", written))
        sources |= edit
        with pytest.raises(report.NoReport, match=r"stale.*python -m book"):
            report.load()


# Words, claims, points


def test_a_printed_claim_is_the_object_as_written():
    """A number after a factor has a dot, a product of sines has parentheses, and nothing is put in order."""
    x, cos_theta = symbols("x cos_theta", real=True)
    with evaluate(False):
        claim = Claim("c", equation(pi * 2 * sinpi(x) * cos_theta**2, 0 + x), greater(x, 1))
    line, hypothesis = r"\pi \cdot 2 \sin(\pi x) (\cos\theta)^{2} = 0 + x", ("given", "x > 1")
    assert rows(claim) == [hypothesis, ("shows", line)]
    assert rows(claim, refuted=True)[-1].role == "false"


def test_evidence_in_words():
    entry = {
        "grade": "proved",
        "statements": 4,
        "witness": [{"points": 1000, "digits": 50}],
        "mutants": [{"refused": True, "counterexample": exact} for exact in ({"exact": True}, None)],
        "shown": "formal",
        "formal": {"claims": ["a"], "statements": {}},
        "when": "recorded on 2026-11-27",
        "side_conditions": [{"edges": ["x = 0"]}],
    }
    assert evidence_line(entry) == (
        "Formal: 1 statement in Coq, recorded on 2026-11-27; proved: 4 certificates, checked by two kernels; "
        "1 of 2 false variants refuted; 1,000 samples at 50 digits; 1 edge test"
    )
