"""Every page in a real browser: nothing leaves it, nothing complains or overflows, axe-core finds no serious violation.

axe-core is an npm package and used here alone: `npm ci --prefix tests/npm` installs it. Without it the rest is asked.
"""

import pytest

from book.assembly.contents import page_files
from tests.tabs import CERTAIN, PHONE, WATCH, next_frame
from verify.evidence.sources import ROOT

AXE = ROOT / "tests" / "npm" / "node_modules" / "axe-core" / "axe.min.js"

# Sphinx's own pages, and the listing of a source: all listings are made alike.
OTHERS = ["genindex", "search", "source/proofs/formulas/bump.py"]
every_page = pytest.mark.parametrize("page", [*page_files(ROOT / "book"), *OTHERS])
COLOUR = ["color-contrast", "link-in-text-block"]
# Rules of axe-core: dark is the same document in other colours, a phone has the light ones in another shape.
LOOKS_FOR = {
    "light": {},
    "dark": {"runOnly": COLOUR},
    "phone": {"rules": {rule: {"enabled": False} for rule in COLOUR}},
}
MODES = {"light": {}, "dark": {"color_scheme": "dark"}, "phone": PHONE | {"device_scale_factor": 2}}
RUN = """async ([place, options]) => (await axe.run(place, options)).violations
    .filter(v => ['serious', 'critical'].includes(v.impact))
    .map(v => `${v.id}: ${v.nodes.map(n => n.html).slice(0, 5).join(', ')}`)"""
# Of formulas in one kind of place, and of a listing's words of one kind, two stay: the first, and the first with more
# than single letters, of which axe-core decides nothing. The others are made alike, and would take longest.
ALIKE = """() => {
    const seen = new Set();
    for (const part of document.querySelectorAll('math, .highlight span:not(:has(*))')) {
        const place = part.parentElement, words = [part, ...part.querySelectorAll('mi, mn')];
        const more = words.some(word => !word.children.length && word.textContent.length > 1);
        const kind = [part.className, place.localName, place.closest('[class]').className, more].join();
        if (seen.has(kind)) part.replaceWith(part.matches('math') ? 'formula' : part.textContent);
        seen.add(kind);
    } }"""
WIDTHS = [320, 360, 400, 600, 768, 1000, 1100, 1210, 1440, 2560, 1280]  # the last is DESKTOP's
# True if the page stays wider than its window: the simulator may be drawn anew, and the sidebar slides.
OVERFLOWS = """async () => {
    for (const end = performance.now() + 15000; document.documentElement.scrollWidth > innerWidth; ) {
        if (performance.now() > end) return true;
        await new Promise(requestAnimationFrame);
    }
    return false; }"""
# Elements that the keyboard reaches without visible focus. After a key, the browser takes any focus for the keyboard's.
UNSEEN = """() => [...document.querySelectorAll('a[href], button, input, select, summary, [tabindex="0"]')].filter(e =>
{
    e.focus({ preventScroll: true });
    const ring = getComputedStyle(e), field = e.closest('form.bd-search');
    const shown = ring.outlineStyle !== 'none' && parseFloat(ring.outlineWidth) >= 2;
    return document.activeElement === e && !shown && !(field && getComputedStyle(field).boxShadow !== 'none');
}).map(e => e.outerHTML.slice(0, 120))"""
SEEN = """async () => {
    await document.fonts.ready;
    const all = selector => [...document.querySelectorAll(selector)];
    const scrolls = e => ['auto', 'scroll'].includes(getComputedStyle(e).overflowX);
    const held = e => { for (let p = e; p; p = p.parentElement) if (scrolls(p)) return true; };
    const shown = all('img').filter(e => e.offsetWidth);
    const renders = all('img.render, img.exact').filter(i => i.offsetWidth);
    for (const image of shown) image.loading = 'eager';
    await Promise.allSettled(shown.map(image => image.decode()));
    // Asked last: a script may have taken the place of a table meanwhile.
    const formulas = all('.bd-article math').filter(e => e.checkVisibility());
    return {
        plots: all('img.plot').filter(i => i.offsetWidth).map(i => i.src),
        blurred: renders.filter(i => getComputedStyle(i).filter !== 'none'
            || !(getComputedStyle(i).imageRendering === 'pixelated' || i.src.endsWith('.svg'))).map(i => i.src),
        scaled: renders.filter(i => i.getBoundingClientRect().width % i.naturalWidth).map(i => i.src),
        unloaded: shown.filter(i => !(i.complete && i.naturalWidth)).map(i => i.currentSrc),
        stretched: shown.filter(i => i.matches('.plot') && i.getBoundingClientRect().width > innerWidth).length,
        unset: formulas.filter(e => !e.getBoundingClientRect().width).length,
        fonts: !formulas.length || document.fonts.check('1em "Book Formulas"'),
        wide: document.documentElement.scrollWidth,
        cut: all('.bd-article *').filter(e => e.getBoundingClientRect().right > innerWidth + 1
            && e.getBoundingClientRect().width > 1 && !held(e))
            .map(e => e.outerHTML.slice(0, 120)),
    };
}"""


def violations(tab, mode="light", place="html"):
    """Return the faults that axe-core finds, if it is installed, where all that is folded is open."""
    if not AXE.is_file():
        return []
    tab.evaluate("unfold(document); document.querySelectorAll('details').forEach(fold => fold.open = true)")
    tab.evaluate(ALIKE)
    next_frame(tab)
    tab.add_script_tag(path=AXE)
    asked = {"resultTypes": ["violations"], "preload": False, "selectors": False}
    return tab.evaluate(RUN, [place, asked | LOOKS_FOR[mode]])


def look(tab, page, mode):
    """Hold the page to what its reader has to see."""
    state = tab.evaluate(SEEN)
    assert state["unloaded"] == state["blurred"] == [] and state["unset"] == 0 and state["fonts"]
    assert all(source.endswith(".dark.svg") == (mode == "dark") for source in state["plots"])
    if mode == "phone":  # wide parts stand in boxes that scroll
        assert state["wide"] <= PHONE["viewport"]["width"] and (page in OTHERS or state["cut"] == [])
        assert state["stretched"] == 0
    else:  # a pixel is so many of the screen's
        assert state["scaled"] == []


def change_colours(tab, mode):
    """Change what the system says, and wait until the page has followed; transitions are not waited for."""
    tab.emulate_media(color_scheme=mode)
    tab.wait_for_function("mode => document.documentElement.dataset.theme === mode", arg=mode)
    tab.evaluate("document.getAnimations().forEach(change => change.cancel())")
    next_frame(tab)


def too_narrow(tab):
    """Return the widths at which the page is wider than its window."""
    widths_cut = []
    for width in WIDTHS:
        tab.set_viewport_size({"width": width, "height": 900})
        next_frame(tab)
        widths_cut += [width] * tab.evaluate(OVERFLOWS)
    return widths_cut


@every_page
def test_page_is_whole_on_a_desktop(visit, page):
    """From the disk, in the dark and in the light; it keeps still, shows its focus and is as wide as any window.

    `visit` sees that it asks for nothing elsewhere and reports no error.
    """
    tab = visit(page, "file", prepare=WATCH, **MODES["dark"])
    tab.evaluate("document.fonts.ready")
    next_frame(tab)
    assert tab.evaluate("seen.shift") <= 0.05
    tab.evaluate("document.documentElement.classList.remove('begun')")  # so that all of it is laid out
    tab.keyboard.press("Tab")
    assert tab.evaluate(UNSEEN) == []
    look(tab, page, "dark")
    change_colours(tab, "light")
    look(tab, page, "light")
    assert too_narrow(tab) == []
    assert violations(tab) == []
    change_colours(tab, "dark")
    assert violations(tab, "dark") == []


@every_page
def test_page_is_whole_on_a_phone(visit, page):
    tab = visit(page, prepare=WATCH, **MODES["phone"])
    next_frame(tab)
    assert tab.evaluate("seen.shift") <= 0.05
    look(tab, page, "phone")
    assert violations(tab, "phone") == []


def test_simulator_moves_nothing_when_it_starts(visit):
    """Not even what it says of itself, which is there a moment later than its pictures."""
    tab = visit("s4", prepare=WATCH, folded=True)
    tab.wait_for_selector(".sim-curve .least")
    next_frame(tab)
    assert tab.evaluate("seen.shift") < 1e-3


@pytest.mark.parametrize("mode", MODES)
def test_simulator_has_no_violation_when_it_runs_is_looked_at_closely_and_complains(visit, mode):
    tab = visit("s4", **MODES[mode])
    tab.click("#sim-sweep")  # with its bar
    tab.click("[data-pause]")
    tab.select_option("#sim-view", "bounds")
    tab.locator("#loupe").scroll_into_view_if_needed()
    for place in (".sim-bits tbody tr", CERTAIN):
        tab.wait_for_selector(place)
    tab.fill("[data-parameter=eps] input[type=text]", "nonsense")
    tab.keyboard.press("Tab")
    assert violations(tab, mode, "#simulator") == []
    assert tab.evaluate("document.documentElement.scrollWidth <= innerWidth")  # the ruler scrolls in its own box


def test_search_field_and_phone_menu_have_no_violation_when_they_are_open(visit):
    for mode, button, shown in (
        ("light", ".search-button-field:visible", "#pst-search-dialog[open]"),
        ("phone", "button.primary-toggle", "#pst-primary-sidebar-modal[open]"),
    ):
        tab = visit("s1", **MODES[mode])
        tab.locator(button).first.click()
        tab.wait_for_selector(shown)
        assert violations(tab, mode) == []


@pytest.mark.skipif(not AXE.is_file(), reason="axe-core is not installed: npm ci --prefix tests/npm")
@pytest.mark.parametrize(
    "mode, place, spoil, rule",
    [
        ("light", ".bd-article", "part => part.append(document.createElement('button'))", "button-name"),
        ("dark", "math:has(:is(mi, mn):text-matches('..'))", "part => { part.style.color = '#333' }", "color-contrast"),
        ("phone", "div.math[data-in-reach]", "part => { part.tabIndex = -1 }", "scrollable-region-focusable"),
    ],
)
def test_a_violation_is_seen(visit, mode, place, spoil, rule):
    tab = visit("s2", **MODES[mode])  # on a phone it has a formula that scrolls,
    tab.locator(place).first.evaluate(spoil)  # which a script puts into reach a frame after the page is loaded
    assert any(entry.startswith(rule) for entry in violations(tab, mode, ".bd-article"))


def test_on_a_phone_what_is_too_wide_is_moved_by_keys(visit):
    tab, scrolling = visit("s2", **PHONE), "div.math[data-in-reach]"
    assert tab.get_attribute(scrolling, "aria-label").startswith("Formula")
    tab.press(scrolling, "ArrowRight")
    tab.wait_for_function("selector => document.querySelector(selector).scrollLeft > 0", arg=scrolling)


def test_back_leads_where_one_was(visit):
    tab, link = visit("s3", "file"), ".bd-article a.reference[href^='lemmas.html#']"
    tab.evaluate("document.fonts.ready")
    tab.evaluate("scrollTo(0, 3000)")
    next_frame(tab)
    tops = "[...document.querySelectorAll('figure[id]')].map(figure => [figure.id, figure.getBoundingClientRect().top])"
    first = f"{tops}.find(([, top]) => top > 0)"
    id, top = tab.locator(link).first.evaluate(f"link => {{ const figure = {first}; link.click(); return figure; }}")
    tab.wait_for_url(lambda url: "s3.html" not in url)
    tab.go_back()
    place = f"document.getElementById('{id}').getBoundingClientRect().top"
    tab.wait_for_function(f"location.pathname.endsWith('s3.html') && scrollY > 2000 && Math.abs({place} - {top}) < 2")
