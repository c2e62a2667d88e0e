"""Every page against axe-core, no serious or critical violation; and the keyboard reaches what scrolls.

axe-core is an npm package and used here alone: `npm ci --prefix tests/axe` installs it. Without it these are skipped.
"""

from pathlib import Path

import pytest

from tests.test_browser import DESKTOP, PAGES, PHONE, settled

AXE = Path(__file__).parent / "axe" / "node_modules" / "axe-core" / "axe.min.js"

pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(not AXE.is_file(), reason="axe-core is not installed: npm ci --prefix tests/axe"),
]
# Sphinx's own pages, and the listing of a source: all listings are made alike.
OTHERS = ["genindex", "search", "source/proofs/formulas/bump.py"]
RUN = """async (options) => (await axe.run(document, { resultTypes: ['violations'], ...options })).violations
    .filter(v => ['serious', 'critical'].includes(v.impact))
    .map(v => `${v.id}: ${v.nodes.map(n => n.target.join(' ')).slice(0, 5).join(', ')}`)"""
COLOUR = ["color-contrast", "link-in-text-block"]
# Dark is the same document in other colours; a phone has the light colours in another shape.
MODES = {
    "light": ({"viewport": DESKTOP, "color_scheme": "light"}, {}),
    "dark": ({"viewport": DESKTOP, "color_scheme": "dark"}, {"runOnly": COLOUR}),
    "phone": (
        {"viewport": PHONE, "is_mobile": True, "has_touch": True},
        {"rules": {rule: {"enabled": False} for rule in COLOUR}},
    ),
}


@pytest.fixture
def visit(browser, server):
    """Go to a page in a mode, with all that is folded open and typeset, and axe-core beside it."""
    contexts = []

    def go(page: str, mode: str = "light"):
        contexts.append(browser.new_context(**MODES[mode][0]))
        tab = contexts[-1].new_page()
        settled(tab, f"{server}/{page}.html")
        tab.evaluate("document.querySelectorAll('details').forEach(fold => fold.open = true)")
        after_next_frame(tab)
        tab.add_script_tag(path=AXE)
        return tab

    yield go
    for context in contexts:
        context.close()


def after_next_frame(tab) -> None:
    """Wait until the page has been laid out and what watches its size has been told."""
    tab.evaluate("() => new Promise(done => requestAnimationFrame(() => setTimeout(done, 400)))")


def violations(tab, mode: str = "light") -> list[str]:
    return tab.evaluate(RUN, MODES[mode][1])


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("page", [*PAGES, *OTHERS])
def test_page_has_no_serious_violation(visit, page, mode):
    assert violations(visit(page, mode), mode) == []


@pytest.mark.parametrize("mode", MODES)
def test_simulator_has_none_when_it_runs_and_when_it_complains(visit, mode):
    tab = visit("s4", mode)
    tab.wait_for_function("window.Simulator && Simulator.running && Simulator.running.frames.length > 0")
    box = tab.locator("[data-parameter=eps] input[type=text]")
    box.fill("nonsense")
    box.press("Tab")
    assert violations(tab, mode) == []


def test_search_field_and_phone_menu_have_none_when_they_are_open(visit):
    tab = visit("s1")
    tab.locator(".search-button-field:visible").first.click()
    tab.locator("#pst-search-dialog[open]").wait_for()
    assert violations(tab) == []
    tab = visit("s1", "phone")
    tab.locator("button.primary-toggle").click()
    tab.locator("#pst-primary-sidebar-modal[open]").wait_for()
    assert violations(tab, "phone") == []


@pytest.mark.parametrize(
    ("mode", "spoil", "rule"),
    [
        ("light", "document.querySelector('.bd-article').append(document.createElement('button'))", "button-name"),
        ("dark", "document.querySelector('.bd-article p').style.color = '#333'", "color-contrast"),
        (
            "phone",
            "document.querySelector('[data-in-reach]').removeAttribute('tabindex')",
            "scrollable-region-focusable",
        ),
    ],
)
def test_a_violation_is_seen(visit, mode, spoil, rule):
    tab = visit("s2", mode)  # on a phone it has a figure that scrolls
    tab.evaluate(spoil)
    assert any(entry.startswith(rule) for entry in violations(tab, mode))


def test_keyboard_moves_a_figure_that_is_too_wide_and_stops_at_no_other(visit):
    scrolling = "figure .pixels[data-in-reach]"
    tab = visit("s2", "phone")
    figure = tab.locator(scrolling).first
    assert figure.get_attribute("aria-label").startswith("Figure ")
    figure.focus()
    tab.keyboard.press("ArrowRight")
    tab.wait_for_function("selector => document.querySelector(selector).scrollLeft > 0", arg=scrolling)
    tab.set_viewport_size({"width": 2000, "height": 900})
    after_next_frame(tab)
    assert figure.count() == 0
    assert tab.locator("[data-in-reach]").count() == 0


def test_light_and_dark_are_changed_by_a_button_with_a_name(visit):
    tab = visit("s1")
    before = tab.evaluate("document.documentElement.dataset.mode")
    button = tab.get_by_role("button", name="Light or dark")
    button.focus()
    tab.keyboard.press("Enter")
    assert tab.evaluate("document.documentElement.dataset.mode") != before
