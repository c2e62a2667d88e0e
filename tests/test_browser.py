"""The site in a real browser: nothing leaves the page, nothing complains, nothing overflows."""

from itertools import pairwise
from pathlib import Path
from urllib.parse import urlparse

import pytest

from book.build.contents import page_files

ROOT = Path(__file__).resolve().parent.parent

pytestmark = pytest.mark.browser
PAGES = list(page_files(ROOT / "book"))
PHONE = {"width": 400, "height": 850}
DESKTOP = {"width": 1280, "height": 900}


def address(site, server, scheme: str, page: str) -> str:
    return f"{server}/{page}.html" if scheme == "http" else (site / f"{page}.html").as_uri()


def settled(tab, url: str) -> None:
    """Go there and wait until scripts have run and every formula is typeset."""
    tab.goto(url, wait_until="load")
    tab.wait_for_function("() => !window.MathJax || !MathJax.startup || !!MathJax.startup.promise")
    tab.evaluate("() => window.MathJax && MathJax.startup && MathJax.startup.promise")


def is_local(url: str, server: str) -> bool:
    parts = urlparse(url)
    return parts.scheme in ("data", "blob", "file") or url.startswith(server)


@pytest.fixture
def tab(browser):
    """A page in a fresh context, desktop size."""
    context = browser.new_context(viewport=DESKTOP, color_scheme="light")
    yield context.new_page()
    context.close()


@pytest.mark.parametrize("scheme", ["http", "file"])
@pytest.mark.parametrize("page", PAGES)
def test_page_asks_for_nothing_else_and_reports_no_error(tab, site, server, page, scheme):
    requests, complaints = [], []
    tab.on("request", lambda request: requests.append(request.url))
    tab.on("requestfailed", lambda request: complaints.append(f"failed: {request.url}"))
    tab.on("console", lambda message: complaints.append(message.text) if message.type == "error" else None)
    tab.on("pageerror", lambda error: complaints.append(str(error)))
    settled(tab, address(site, server, scheme, page))
    assert requests
    assert [url for url in requests if not is_local(url, server)] == []
    assert complaints == []
    loaded = tab.evaluate("[...document.images].map(i => [i.currentSrc, i.complete && i.naturalWidth > 0])")
    assert [source for source, fine in loaded if not fine] == []


@pytest.mark.parametrize("page", PAGES)
def test_page_fits_a_phone(browser, site, server, page):
    context = browser.new_context(viewport=PHONE, device_scale_factor=2, is_mobile=True, has_touch=True)
    tab = context.new_page()
    settled(tab, address(site, server, "http", page))
    assert tab.evaluate("document.documentElement.scrollWidth") <= PHONE["width"]
    # Nothing that a reader needs may be cut off: what is too wide stands in something that scrolls.
    cut = tab.evaluate(
        """() => {
            const scrolls = e => ['auto', 'scroll'].includes(getComputedStyle(e).overflowX);
            const held = e => { for (let p = e; p; p = p.parentElement) if (scrolls(p)) return true; };
            return [...document.querySelectorAll('.bd-article *')]
                .filter(e => e.getBoundingClientRect().right > innerWidth + 1
                    && e.getBoundingClientRect().width > 1 && !held(e)
                    && !e.closest('mjx-assistive-mml'))  // for screen readers alone: clipped to nothing
                .map(e => e.outerHTML.slice(0, 120));
        }"""
    )
    context.close()
    assert cut == []


@pytest.mark.parametrize("scheme", ["http", "file"])
def test_phone_menu_opens_and_leads_on(browser, site, server, scheme):
    context = browser.new_context(viewport=PHONE, is_mobile=True, has_touch=True)
    tab = context.new_page()
    settled(tab, address(site, server, scheme, "index"))
    link = tab.locator("nav.bd-docs-nav a[href^='s1.html']:visible")
    assert link.count() == 0
    tab.locator("button.primary-toggle").click()
    link.first.click()
    tab.wait_for_url("**/s1.html*")
    context.close()


def test_dark_mode_follows_the_system_and_the_button(browser, site, server):
    context = browser.new_context(viewport=DESKTOP, color_scheme="dark")
    tab = context.new_page()
    settled(tab, f"{server}/s1.html")
    paper = "getComputedStyle(document.body).backgroundColor"
    dark = tab.evaluate(paper)
    assert tab.evaluate("document.documentElement.dataset.theme") == "dark"
    seen = {dark}
    for _ in range(3):  # the button goes round: light, dark, as the system says
        tab.locator(".theme-switch-button:visible").first.click()
        seen.add(tab.evaluate(paper))
    context.close()
    assert len(seen) == 2


@pytest.mark.parametrize("mode", ["light", "dark"])
def test_plots_have_the_colours_of_the_page_and_renders_their_own_pixels(browser, site, server, mode):
    context = browser.new_context(viewport=DESKTOP, color_scheme=mode)
    tab = context.new_page()
    plots, renders = [], []
    for page in PAGES:
        settled(tab, address(site, server, "http", page))
        plots += tab.evaluate("[...document.querySelectorAll('img.plot')].filter(i => i.offsetWidth).map(i => i.src)")
        renders += tab.evaluate(
            """[...document.querySelectorAll('img.render, img.exact')].filter(i => i.offsetWidth)
                .map(i => [i.src, i.getBoundingClientRect().width / i.naturalWidth,
                getComputedStyle(i).imageRendering, getComputedStyle(i).filter])"""
        )
    context.close()
    assert plots and renders, "no page shows a plot and a render"
    assert all(source.endswith(".dark.svg") == (mode == "dark") for source in plots)
    for source, enlarged, rendering, filtered in renders:
        assert enlarged == round(enlarged) >= 1, source
        assert filtered == "none", source
        assert rendering == "pixelated" or source.endswith(".svg"), source


@pytest.mark.parametrize("scheme", ["http", "file"])
def test_mathematics_is_typeset(tab, site, server, scheme):
    settled(tab, address(site, server, scheme, "s3"))
    formulas = tab.evaluate("document.querySelectorAll('.bd-article .math').length")
    assert formulas > 0
    assert tab.evaluate("document.querySelectorAll('.bd-article .math mjx-container').length") >= formulas
    assert tab.evaluate("document.querySelectorAll('mjx-merror, [data-mjx-error]').length") == 0
    tab.evaluate("document.fonts.ready")
    assert tab.evaluate("[...document.fonts].some(f => f.family.includes('MJX') && f.status == 'loaded')")


def test_page_without_network_access_can_be_searched(tab, server):
    settled(tab, f"{server}/search.html?q=sphere")
    tab.wait_for_selector("#search-results li")


def test_on_a_phone_panels_stand_below_each_other_and_what_goes_on_fades(browser, site, server):
    context = browser.new_context(viewport=PHONE, is_mobile=True, has_touch=True)
    tab = context.new_page()
    settled(tab, address(site, server, "http", "s1"))
    panels = tab.locator("#fig-three_pictures .panel:visible")
    boxes = [panels.nth(number).bounding_box() for number in range(panels.count())]
    assert len(boxes) == 3 and all(box["x"] >= 0 and box["x"] + box["width"] <= PHONE["width"] for box in boxes)
    assert all(above["y"] + above["height"] <= below["y"] for above, below in pairwise(boxes))
    settled(tab, address(site, server, "http", "s2"))
    wide = tab.locator(".bd-article mjx-container.more").first
    wide.evaluate("element => { element.id = 'wide'; element.scrollLeft = element.scrollWidth; }")
    tab.wait_for_function("!document.getElementById('wide').classList.contains('more')")
    context.close()
