"""The reader's own browser checks the certificates: the cards, the page of all claims, the changed statement."""

import gzip
import json
import re
from base64 import b64decode

import pytest
from bs4 import BeautifulSoup

from book.extension.theorems import placements
from proofs.engine.theorem import all_theorems
from tests.tabs import PHONE
from tests.test_browser import PAGES, violations, with_axe
from verify.checkers.breakages import stored
from verify.sources import ROOT

CHECK_HERE, CHANGE, CHECK_ALL = "Check it here", "Read or change the statement", "Check all"
OPEN_EVERYTHING = """() => { for (const place of document.querySelectorAll('.checker[data-theorem]')) {
    for (const button of place.querySelectorAll('.check-buttons button')) button.click();
    for (const line of [...place.querySelectorAll('.check-line')].slice(-1)) line.click();
} }"""
COMPLAINTS = {
    "cos_theta^2 +": "a term is missing",
    "q": "nothing is called q here",
    "1/0": "a division by zero",
    "cos_theta^99": "an exponent is a whole number",
    "(1 - 1)": "cannot be read",
}
STORED = {name: (entry["statement"], entry["certificate"]) for name, entry in stored().items()}
CERTIFIED = {name.partition("/")[0] for name in STORED}
PLACES = placements(ROOT / "book", all_theorems())


def unpacked(text):
    """The data that a page carries, compressed."""
    return json.loads(gzip.decompress(b64decode(text)))


def card(tab, theorem):
    """A theorem's card, unfolded."""
    place = tab.locator(f"#theorem-{theorem}")
    if place.locator("details").first.get_attribute("open") is None:
        place.locator("summary").first.click()
    return place


def press(place, text):
    place.get_by_role("button", name=text, exact=True).click()


def verdict(place):
    place.locator(".check-verdict > p").first.wait_for()
    return place.locator(".check-verdict").first.inner_text()


@pytest.mark.parametrize("scheme", ["http", "file"])
def test_a_card_checks_its_theorem_and_asks_for_nothing(visit, scheme):
    tab, requests = visit("lemmas", scheme), []
    place = card(tab, "unit_length")
    icon = tab.evaluate("document.querySelector('link[rel~=icon]').href")  # a browser asks for it when it likes
    tab.on("request", lambda request: requests.append(request.url))
    press(place, CHECK_HERE)
    said = verdict(place)
    assert re.match(r"✓? ?Accepted, in [\d,]+ ms, by this browser\. 2 statements under 4 hypotheses: ", said)
    assert re.search(
        r"\d+ polynomial identities multiplied out, [\d,]+ products of terms, and nothing is left over", said
    )
    assert "Not checked here: that these polynomials say what the words above say." in said
    assert [url for url in requests if url != icon and not url.startswith("blob:")] == []


def test_check_all_accepts_everything_and_says_so_on_every_line(visit):
    tab = visit("findings")
    place = tab.locator(".checker[data-all]")
    press(place, CHECK_ALL)
    said = verdict(place)
    assert f"the certificates of {len(CERTIFIED)} of {len(CERTIFIED)} theorems, {len(STORED)} in all" in said
    assert place.locator("progress").evaluate("bar => [bar.value, bar.max]") == [len(STORED)] * 2
    marks = tab.evaluate(
        "[...document.querySelectorAll('[data-claim]:has(.check-accepted)')].map(e => e.dataset.claim)"
    )
    assert set(marks) == CERTIFIED
    assert tab.locator(".check-mark.check-rejected").count() == 0
    for id, words in {"attached_shadow": "✓ refutation accepted here", "angle_of_the_bump": "✓ accepted here"}.items():
        assert tab.locator(f"[data-claim={id}] .check-mark").inner_text().strip() == words


def test_every_theorem_has_its_button_and_its_stored_data_or_says_why_not(site):
    data, notes = {}, []
    for name in PAGES:
        text = (site / f"{name}.html").read_text(encoding="utf-8")
        if 'class="check' not in text:
            continue
        page = BeautifulSoup(text, "html.parser")
        for place in page.select(".checker[data-theorem]"):
            data[place["data-theorem"]] = unpacked(place.find("script", type="application/gzip").string)
        notes += [place["id"] for place in page.select(".theorem:has(.check-nothing)")]
    assert data.keys() == CERTIFIED
    assert sorted(notes) == sorted(f"theorem-{id}" for id in all_theorems().keys() - CERTIFIED)
    shown = [(pair["statement"], pair["certificate"]) for each in data.values() for claim in each["claims"]
             for pair in claim["statements"]]  # fmt: skip
    assert sorted(map(json.dumps, shown)) == sorted(map(json.dumps, STORED.values()))


def test_a_statement_that_is_changed_from_the_keyboard_is_rejected_and_can_be_put_back(visit):
    tab = visit("lemmas")
    place = card(tab, "unit_length")
    place.get_by_role("button", name=CHANGE).focus()
    tab.keyboard.press("Enter")
    assert "as it was" in verdict(place.locator(".check-editor"))
    line = place.locator(".check-line").first
    line.focus()
    tab.keyboard.press("Enter")
    tab.keyboard.press("Tab")
    tab.keyboard.press("Tab")
    tab.keyboard.press("Space")  # the second term's sign
    place.locator(".check-editor .check-rejected").wait_for()
    said = verdict(place.locator(".check-editor"))
    assert "Rejected" in said and "at line 15: the two sides differ" in said
    assert place.locator(".check-residual sup, .check-residual sub").count() > 0
    assert "It should be 0" in said
    assert place.locator(".check-changed").count() == 1
    tab.keyboard.press("Space")  # and back: the focus has stayed
    place.get_by_text("as it was").wait_for()
    assert place.locator(".check-changed").count() == 0


def test_what_is_typed_is_read_or_refused_in_words(visit):
    place = card(visit("lemmas"), "unit_length")
    press(place, CHANGE)
    place.locator(".check-line").first.click()
    box, error = place.locator(".check-panel input"), place.locator(".check-error")
    for typed, complaint in COMPLAINTS.items():
        box.fill(typed)
        assert complaint in error.inner_text()
        assert box.get_attribute("aria-invalid") == "true"
    box.fill("3/2 cos_theta^2 + sin_theta^2 - 1")
    assert error.inner_text() == ""
    place.locator(".check-editor .check-rejected").wait_for()
    assert "1/2" in place.locator(".check-residual").inner_text()
    press(place, "Put everything back")
    place.get_by_text("as it was").wait_for()


@with_axe
def test_an_open_card_has_no_serious_violation(visit):
    tab = visit("lemmas")
    place = card(tab, "unit_length")
    for button in (CHECK_HERE, CHANGE):
        press(place, button)
    place.locator(".check-line").first.click()
    place.locator(".check-chips button").first.click()
    place.locator(".check-editor .check-rejected").wait_for()
    place.locator(".check-panel input").fill("nonsense")
    assert violations(tab, place="#theorem-unit_length") == []


def test_a_change_that_leaves_it_true_is_accepted_and_said_to_be(visit):
    """That sin² + cos² = 1 is what the oddness of a sine does not need."""
    name = "clamped_difference_of_odd"
    place = card(visit(PLACES[name]), name)
    press(place, CHANGE)
    line = place.locator(".check-line").nth(1)
    circle = line.inner_text()
    line.click()
    place.locator(".check-chips button").first.click()
    place.locator(".check-editor .check-accepted").wait_for()
    assert line.inner_text() == f"−{circle}"
    assert "Accepted all the same" in verdict(place.locator(".check-editor"))
    box = place.locator(".check-panel input")
    box.fill("2 cos(pi*k_v*v)^2 - cos(pi*k_v*v)^2 + sin(pi*k_v*v)^2 - 1")  # what it was
    place.get_by_text("as it was").wait_for()


def tampered_data(tab, selector):
    """Return the data of a place, with one sign turned in what the first claim of unit_length shows."""
    data = unpacked(tab.locator(f"{selector} script[type='application/gzip']").text_content())
    theorem = data if isinstance(data, dict) else next(each for each in data if each["theorem"] == "unit_length")
    of = theorem["claims"][0]["statements"][0]["statement"]["steps"][-1]["of"]
    assert of["h_u^2"] == "-1"
    of["h_u^2"] = "1"
    return data


def test_a_false_certificate_is_rejected_by_the_card_and_by_check_all(visit):
    tab = visit("lemmas")
    wrong = tampered_data(tab, "#theorem-unit_length")
    card(tab, "unit_length").locator(".check-body").wait_for()
    tab.evaluate(
        "data => checker_card(document.querySelector('#theorem-unit_length .checker'), data, checking_clerk())", wrong
    )
    press(card(tab, "unit_length"), CHECK_HERE)
    said = verdict(card(tab, "unit_length"))
    assert "Rejected" in said and "g is tangent" in said and "Left over" in said
    tab = visit("findings")
    wrong = tampered_data(tab, ".checker[data-all]")
    tab.evaluate(
        "data => check_all(document.querySelector('.checker[data-all]'), async () => data, checking_clerk())", wrong
    )
    press(tab.locator(".checker[data-all]"), CHECK_ALL)
    said = verdict(tab.locator(".checker[data-all]"))
    assert "Rejected" in said and said.endswith("Rejected: unit_length.")
    assert tab.locator("[data-claim=unit_length] .check-mark.check-rejected").count() == 1


BROKEN_KERNEL = "certificate_kernel = function certificate_kernel() { throw new Error('broken') }"


@pytest.mark.parametrize(
    ("name", "button", "breakage", "words"),
    [
        ("lemmas", CHECK_HERE, "window.Worker = class { constructor() { throw new Error('forbidden') } }", "forbidden"),
        ("findings", CHECK_ALL, BROKEN_KERNEL, "the worker failed"),
    ],
)
def test_a_worker_that_does_not_start_says_so(visit, name, button, breakage, words):
    tab = visit(name)
    tab.evaluate(f"() => {{ {breakage} }}")
    place = tab.locator(".checker[data-all]") if name == "findings" else card(tab, "unit_length")
    press(place, button)
    said = verdict(place)
    assert "No verdict" in said and words in said
    assert "Accepted" not in said


def test_a_worker_that_never_answers_is_given_up(visit):
    tab = visit("lemmas")
    tab.clock.install()
    tab.evaluate("() => { window.Worker = class { postMessage() {} terminate() {} } }")
    press(card(tab, "unit_length"), CHECK_HERE)
    tab.clock.run_for(21000)
    assert "no answer within 20 seconds" in verdict(card(tab, "unit_length"))


def test_a_refuted_claim_has_its_counterexample_put_in(visit):
    assert all_theorems()["seed_clamp"].expected == "refuted"
    seed_clamp = card(visit(PLACES["seed_clamp"]), "seed_clamp")
    press(seed_clamp, CHECK_HERE)
    said = verdict(seed_clamp)
    assert "1 counterexample put in, in exact fractions: the claim is false there, and 7 other conditions hold" in said


def test_without_scripts_the_card_says_what_there_is(visit):
    place = card(visit("lemmas", java_script_enabled=False), "unit_length")
    assert place.get_by_role("button").count() == 0
    assert "takes JavaScript" in place.inner_text()
    assert "steps" not in place.inner_text()  # the data are not text


def test_the_editor_fits_a_phone_and_a_finger(visit):
    tab = visit("s3", **PHONE)
    tab.evaluate("document.querySelectorAll('.theorem > details').forEach(fold => fold.open = true)")
    for place in tab.locator(".checker[data-theorem]").all():  # which has its buttons when it is near
        place.scroll_into_view_if_needed()
        place.locator(".check-body").wait_for()
    tab.evaluate(OPEN_EVERYTHING)
    tab.wait_for_function("[...document.querySelectorAll('.check-body > .check-verdict')].every(e => e.innerText)")
    tab.evaluate("document.querySelectorAll('.checker details').forEach(fold => fold.open = true)")
    assert tab.evaluate("document.documentElement.scrollWidth") <= PHONE["viewport"]["width"]
    small = tab.evaluate("""[...document.querySelectorAll('.checker :is(button, input, select, summary)')]
        .filter(e => e.offsetWidth).map(e => [e.outerHTML.slice(0, 80), e.getBoundingClientRect()])
        .filter(([_, box]) => box.height < 44 || box.width < 44).map(([html]) => html)""")
    assert small == []
