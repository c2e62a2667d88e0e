"""The reader's own browser checks the certificates: the cards, the page of all claims.

`verify/test_theorems.py` compares its kernel with Python's.
"""

import re

import pytest

from book.extension.theorems import placements
from proofs.engine.theorem import all_theorems
from tests.test_browser import violations
from verify.checkers.second_checker import stored
from verify.evidence.sources import ROOT

CHECK_HERE, CHECK_ALL = "Check it here", "Check all"
# One sign is turned in what the first claim of unit_length shows.
FALSIFY = """async place => {
    const data = await data_of(place), { claims } = [data].flat().find(({ theorem }) => theorem === 'unit_length');
    const { of } = claims[0].statements[0].statement.steps.at(-1);
    if (of['h_u^2'] !== '-1') throw new Error('it has changed');
    of['h_u^2'] = '1';
    if ('all' in place.dataset) check_all(place, async () => data, checking_clerk());
    else checker_card(place, data, checking_clerk()); }"""
STORED = stored()
CERTIFIED = {name.partition("/")[0] for name in STORED}
PLACES = placements(ROOT / "book", all_theorems())


def card(tab, theorem="unit_length"):
    """A theorem's card, unfolded and in sight."""
    place = tab.locator(f"#theorem-{theorem}")
    place.locator("details").first.evaluate("fold => { fold.open = true }")
    place.scroll_into_view_if_needed()
    return place


def verdict(place, button=None):
    """Return the text of a place, after a button of it was pressed."""
    if button:
        place.get_by_role("button", name=button, exact=True).click()
    place.locator(".check-verdict > p").first.wait_for()
    return place.locator(".check-verdict").first.inner_text()


def test_a_card_checks_its_theorem(visit, scheme):
    place = card(visit("lemmas", scheme))
    assert re.match(
        r"✓? ?Accepted, in [\d,]+ ms, by this browser\. 2 statements under 4 hypotheses: \d+ polynomial identities "
        r"multiplied out, [\d,]+ products of terms, and nothing is left over\.\s+"
        r"Not checked here: that these polynomials say what the words above say\.",
        verdict(place, CHECK_HERE),
    )


def test_check_all_accepts_everything_and_says_so_on_every_line(visit):
    tab = visit("findings")
    place = tab.locator(".checker[data-all]")
    words = verdict(place, CHECK_ALL)
    assert f"the certificates of {len(CERTIFIED)} of {len(CERTIFIED)} theorems, {len(STORED)} in all" in words
    marked = tab.locator("[data-claim]:has(.check-mark)")
    marks = dict(
        marked.evaluate_all("all => all.map(e => [e.dataset.claim, e.querySelector('.check-mark').innerText])")
    )
    refuted = {id for id in CERTIFIED if all_theorems()[id].expected == "refuted"}
    assert marks == {id: f" ✓ {'refutation ' * (id in refuted)}accepted here" for id in CERTIFIED}


@pytest.mark.parametrize("name, at, button, words", [
    ("lemmas", "#theorem-unit_length .checker", CHECK_HERE, "Rejected(?s:.*)g is tangent(?s:.*)Left over"),
    ("findings", ".checker[data-all]", CHECK_ALL, r"Rejected(?s:.*)Rejected: unit_length\.$"),
])  # fmt: skip
def test_a_false_certificate_is_rejected(visit, name, at, button, words):
    tab = visit(name)
    tab.evaluate("document.querySelectorAll('details').forEach(fold => { fold.open = true })")
    place = tab.locator(at)
    place.scroll_into_view_if_needed()
    place.locator(".check-body").wait_for()
    place.evaluate(FALSIFY)
    assert re.search(words, verdict(place, button))
    assert violations(tab, place=at) == []


SILENT = "window.Worker = class { postMessage() {} terminate() {} }"
FORBIDDEN = "window.Worker = class { constructor() { throw new Error('forbidden') } }"
BROKEN = "certificate_kernel = function certificate_kernel() { throw new Error('broken') }"


@pytest.mark.parametrize("name, button, breakage, words", [
    ("lemmas", CHECK_HERE, FORBIDDEN, "forbidden"),
    ("lemmas", CHECK_HERE, SILENT, "no answer within 20 seconds"),
    ("findings", CHECK_ALL, BROKEN, "the worker failed"),
])  # fmt: skip
def test_a_worker_that_does_not_start_or_answer_says_so(visit, name, button, breakage, words):
    tab = visit(name)
    tab.clock.install()
    tab.evaluate(f"() => {{ {breakage} }}")
    place = card(tab) if name == "lemmas" else tab.locator(".checker[data-all]")
    place.get_by_role("button", name=button, exact=True).click()
    if breakage == SILENT:
        tab.clock.run_for(21000)
    text = verdict(place)
    assert "No verdict" in text and words in text and "Accepted" not in text


def test_a_refuted_claim_has_its_counterexample_put_in(visit):
    assert all_theorems()["seed_clamp"].expected == "refuted"
    text = verdict(card(visit(PLACES["seed_clamp"]), "seed_clamp"), CHECK_HERE)
    assert "1 counterexample put in, in exact fractions: the claim is false there, and 7 other conditions hold" in text


def test_without_scripts_the_card_says_what_there_is(visit):
    place = card(visit("lemmas", java_script_enabled=False))
    assert place.get_by_role("button").count() == 0
    text = place.inner_text()
    assert "takes JavaScript" in text and "steps" not in text  # the data are not text
