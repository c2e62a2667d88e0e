"""Theorems in the book: the card is the checked object's, and what did not reach its grade does not build."""

import html
import json
import re
from functools import partial

import pytest
from docutils import nodes
from sympy import evaluate, pi, symbols

from book.assembly import report
from book.editions.pages import parsed
from book.extension import theorems as book_theorems
from book.extension.cards import OPEN, coq
from book.extension.dependencies import rows
from book.extension.elements import typeset
from book.extension.evidence import evidence_line, findings
from book.extension.printed_claims import rows as rows_of
from book.extension.printed_claims import tex_point, tex_value
from book.extension.theorems import Proofs, placements
from proofs.engine.claim import Claim, equation, greater
from proofs.engine.theorem import all_theorems
from proofs.formulas.half_turns import sinpi
from tests import one_page
from tests.processes import python
from verify.sources import ROOT

THEOREMS = all_theorems()
ENTRY = {
    "id": "kink_loci",
    "expected": "proved",
    "grade": "proved",
    "statements": 4,
    "uses": [],
    "mutants": [
        {"mutant": "a sign", "refused": True, "counterexample": {"exact": True, "at": {"x": "1"}}},
        {"mutant": "a factor", "refused": True, "counterexample": None},
    ],
    "witness": [{"claim": "a", "points": 1000, "digits": 50}, {"claim": "b", "points": 0}],
    "side_conditions": [{"condition": "x > 0", "edges": [{"at": {"x": "0"}, "outcome": "fails"}]}],
}


ASKED = {"the second checker": True, "Coq": True}


@pytest.fixture
def fresh_report(stamped, monkeypatch):
    """A report of every theorem as its author expects it, with a stamp that says it is fresh."""
    entries = [ENTRY | {"id": id, "expected": t.expected, "grade": t.expected} for id, t in THEOREMS.items()]
    path = stamped / "proofs.json"
    path.write_text(json.dumps({"version": 1, "theorems": entries, "asked": ASKED}))
    monkeypatch.setattr(report, "REPORT", path)
    monkeypatch.setattr(report, "reported_hashes", lambda: {"proofs/x.py": "1"})
    report.remember(report.reported_hashes())
    return path


@pytest.fixture
def build_page(fresh_report, tmp_path):
    """Build a book of one page with the extension; the page's HTML and the warnings."""
    book = tmp_path / "book"
    book.mkdir()
    (book / "findings.md").write_text("---\norphan: true\n---\n# Findings\n")
    return partial(one_page.build, book)


# The card


def statement_in(page):
    """The text of the only statement of a page, its formulas between dollars."""
    shown = parsed(page).select_one(".statement")
    for title in shown.select(".theorem-title"):
        title.decompose()
    for formula in shown.select("math"):
        formula.replace_with(f"${formula.annotation.get_text()}$")
    return shown.get_text().strip()


def test_statement_on_the_page_is_the_checked_objects(build_page):
    page, warnings = build_page(":::{theorem} kink_loci\n:::\n\nSee {theorem-ref}`kink_loci`.")
    assert warnings == ""
    assert statement_in(page) == THEOREMS["kink_loci"].words
    assert 'href="#theorem-kink_loci">Theorem 1 (The creases are rays and circles)</a>' in page
    assert "pytest verify --theorem kink_loci" in re.sub(r"<[^>]+>", "", page)


def test_claims_stand_below_their_clauses_as_mathematics(build_page):
    page, _ = build_page(":::{theorem} kink_loci\n:::")
    shown = parsed(page).select("details > .claim > dl")
    claims = [claim for clause in THEOREMS["kink_loci"].clauses for claim in clause.claims]
    assert [table["aria-label"] for table in shown] == [f"Claim {claim.name}" for claim in claims]
    for table, claim in zip(shown, claims, strict=True):
        printed = [
            row.annotation.get_text() for row in table.parent.select("dd")
        ]  # what it shows, and folded, from what
        assert sorted(printed) == sorted(row.tex for row in rows_of(claim))
        assert [row.get_text() for row in table.select("dt")] == ["shows"] and len(table.select("dd")) <= OPEN


def test_a_printed_claim_is_the_object_as_written():
    """A number after a factor has a dot, a product of sines has parentheses, and nothing is put in order."""
    x, cos_theta = symbols("x cos_theta", real=True)
    with evaluate(False):
        claim = Claim("c", (equation(pi * 2 * sinpi(x) * cos_theta**2, 0 + x),), (greater(x, 1),))
    said, given = r"\pi \cdot 2 \sin(\pi x) (\cos\theta)^{2} = 0 + x", ("given", "x > 1")
    assert rows_of(claim) == [given, ("shows", said)]
    assert rows_of(claim, by_definition=(str(claim.shows[0]),)) == [given, ("by definition", said)]
    assert rows_of(claim, refuted=True)[-1].role == "false"


def test_words_stand_for_a_statement_which_is_folded_away(build_page):
    page, warnings = build_page(":::{theorem} kink_loci\nRays, and *circles*.\n:::")
    assert warnings == "" and statement_in(page) == THEOREMS["kink_loci"].words
    card = parsed(page).select_one("#theorem-kink_loci")
    assert [part.name for part in card.find_all(recursive=False)] == ["p", "details"]
    assert card.p.get_text().endswith("Rays, and circles.") and card.p.em.get_text() == "circles"
    assert card.details.select(".statement") and not card.details.has_attr("open")


def test_every_clause_without_a_claim_is_listed(build_page):
    page, warnings = build_page(":::{argued-clauses}\n:::")
    assert warnings == ""
    listed = {id: len(theorem.argued) for id, theorem in THEOREMS.items()}
    assert {id: page.count(f'findings.html#theorem-{id}"') for id in THEOREMS} == listed
    assert page.count("(argued: ") == sum(listed.values()) > 0


def test_a_statement_of_coq_has_coloured_keywords_and_no_tag_of_its_own():
    assert coq("a__b", "forall x : R, x < 2") == (
        '<span class="k">Theorem</span> a__b :\n  <span class="k">forall</span> x : R, x &lt; 2.'
    )


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (":::{theorem} kink_locus\n:::", r"index\.md:3.*unknown theorem 'kink_locus'; there are: .*kink_loci"),
        ("{theorem-ref}`kink_locus`", r"index\.md:3.*unknown theorem 'kink_locus'"),
        (":::{theorem} kink_loci\n:::\n\n:::{theorem} kink_loci\n:::", r"'kink_loci' is placed twice"),
    ],
)
def test_what_is_unknown_or_not_expected_fails_the_build(build_page, text, message):
    assert re.search(message, build_page(text)[1])


def test_a_grade_that_was_not_reached_fails_the_build(build_page, monkeypatch):
    entries = report.load()
    entries["kink_loci"]["grade"] = "failed"
    monkeypatch.setattr(report, "load", lambda: entries)
    for text in (":::{theorem} kink_loci\n:::", "{theorem-ref}`kink_loci`"):
        assert re.search(r"'kink_loci' is expected to be proved; its last run made it failed", build_page(text)[1])


def test_a_report_that_is_stale_edited_by_hand_or_missing_is_refused(fresh_report, monkeypatch):
    assert report.load().keys() == THEOREMS.keys()
    with monkeypatch.context() as changed:
        changed.setattr(report, "reported_hashes", lambda: {"proofs/x.py": "2"})
        with pytest.raises(report.NoReport, match=r"stale.*python -m book"):
            report.load()
    fresh_report.write_text(fresh_report.read_text().replace("refuted", "proved"))
    with pytest.raises(report.NoReport, match="stale"):
        report.load()
    fresh_report.unlink()
    with pytest.raises(report.NoReport, match="no report"):
        report.load()


def test_report_depends_on_proofs_and_checkers():
    names = report.reported_hashes().keys()
    assert {"proofs/engine/kernel.py", "proofs/certificates/kink_loci.json", "verify/checkers/witness.py"} <= names


# Numbers, words, points


def test_numbers_follow_the_pages_and_then_the_rest(tmp_path):
    (tmp_path / "_toc.yml").write_text("root: index\nchapters: [{file: b}, {file: a}]\n")
    (tmp_path / "index.md").write_text("# Front\n")
    (tmp_path / "a.md").write_text(":::{theorem} one\n:::\n")
    (tmp_path / "b.md").write_text("1. point\n\n   ::::{theorem} two\n   ::::\n\n```{theorem} three\n```\n")
    found = placements(tmp_path, ["zero", "one", "two", "three"])
    assert list(found.items()) == [("two", "b"), ("three", "b"), ("one", "a"), ("zero", "findings")]


def test_evidence_in_words():
    assert evidence_line(ENTRY) == (
        "Proved: 4 certificates, checked by two kernels; 1 of 2 false variants refuted; "
        "1,000 samples at 50 digits; 1 edge test"
    )
    spared = {"variant": "v", "accepted": True, "spared": True}
    refuted = {"grade": "refuted", "statements": 1, "mutants": [spared]}
    assert findings(refuted) == ["1 exact counterexample, checked by two kernels", "1 of 1 true variants proved"]
    assert evidence_line({"grade": "cited", "grade_line": "cited: Blinn1978"}) == "Cited: Blinn1978"
    for here, told in ((True, ""), (False, ", recorded, not re-checked here")):
        formal = {"printed": {"a": "x = x"}, "statements": {}, "here": here}
        said = evidence_line({"grade": "proved", "shown": "formal", "formal": formal})
        assert said == f"Formal: 1 statement in Coq{told}; proved"


def test_the_legend_says_which_checkers_were_asked(build_page, monkeypatch):
    page, warnings = build_page(":::{grades}\n:asked:\n:::")
    assert not warnings and "Coq has accepted its files, as they are, on the same machine" in page
    monkeypatch.setattr(report, "asked", lambda: dict.fromkeys(ASKED, False))
    page, _ = build_page(":::{grades}\n:asked:\n:::")
    assert "accepted on another day is recorded, not re-checked here" in page and "second checker did not" in page


def test_points_are_set_as_mathematics():
    at = {"normal_x": "0", "normal_y": "0", "normal_z": "1", "beta": "3/4", "eye": "1." + "3" * 40}
    assert tex_point(at) == ["N = (0, 0, 1)", r"\beta = 3/4", r"e = 1.33333\ldots"]
    assert tex_point({"g_x": "1", "g_y": "0", "g_z": "2"}) == ["g = (1, 0, 2)"]
    assert tex_value("pi/2") == r"\frac{\pi}{2}" and tex_value("x") == r"\texttt{x}"
    assert tex_value("1/" + "5" + "0" * 150) == r"2\cdot 10^{-151}"


def test_text_is_set_with_its_mathematics():
    parts = typeset("so $a_b$ and k_u, not cos_phi")
    assert [type(part) for part in parts] == [nodes.Text, nodes.math, nodes.Text, nodes.subscript, nodes.Text]
    for text in ("$x", "$x$: $$y$ is"):
        with pytest.raises(ValueError, match="a formula does not end"):
            typeset(text)


# The graph


def test_rows_put_everything_below_what_it_rests_on():
    uses = {"a": (), "lone": (), "b": ("a",), "c": ("a", "b"), "x": (), "y": ("x",)}
    assert rows(uses) == ["a", "b", "c", "x", "y", "lone"]


def test_a_refuted_claim_is_not_called_a_theorem():
    assert Proofs({}, {"a": {"shown": "refuted"}}, {"b": "s3", "a": "s3"}).label("a") == "Claim 2"


# The site


def test_every_theorem_of_the_report_is_on_the_page_of_findings(site):
    page = (site / "findings.html").read_text(encoding="utf-8")
    for id, entry in book_theorems.load(ROOT / "book").entries.items():
        target = re.search(rf'href="(\w+\.html)?#theorem-{id}"', page)
        assert target, id
        assert f'id="theorem-{id}"' in (site / (target[1] or "findings.html")).read_text(encoding="utf-8")
        assert evidence_line(entry) in html.unescape(page)


def test_every_theorem_is_a_node_of_the_graph_with_two_links(site):
    page = (site / "dependencies.html").read_text(encoding="utf-8")
    drawn = re.search(r'<div class="graph">.*?</svg>', page, re.DOTALL)[0]
    nodes_drawn = re.findall(r'<g id="node-(\w+)"', drawn)
    assert set(nodes_drawn) == THEOREMS.keys()
    assert drawn.count('class="edge') == sum(len({*theorem.uses}) for theorem in THEOREMS.values())
    assert all(theorem.title in html.unescape(drawn) for theorem in THEOREMS.values())
    assert drawn.count("<a href=") == 2 * len(nodes_drawn)  # to what is there: the mailed file follows every link


def test_certificates_are_downloads_and_scripts_run_with_nothing_but_python(site, tmp_path):
    folder = site / "_downloads" / "theorems"
    certified = {id: path for id in THEOREMS if (path := book_theorems.certificate(id))}
    assert {path.stem for path in folder.glob("*.py")} == certified.keys()
    for id, path in certified.items():
        assert (folder / f"{id}.json").read_bytes() == path.read_bytes()
        python("-I", "-S", folder / f"{id}.py", cwd=tmp_path, timeout=60)
