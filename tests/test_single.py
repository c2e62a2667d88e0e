"""The chapter as one file: opened from the disk without a network, it has what the site has and asks for nothing."""

import re
import shutil
from base64 import b64decode
from collections import Counter
from io import BytesIO
from pathlib import Path
from urllib.parse import unquote

import pytest
from PIL import Image
from playwright.sync_api import expect

from book.editions import files as edition
from book.editions.document import document
from book.editions.inlined import svg_address, svg_parts
from book.editions.names import REFERRING
from book.editions.pages import parsed
from proofs.engine.stored import FOLDER
from tests.tabs import CERTAIN, PHONE, RUNNING, opened, wait_for


@pytest.fixture(scope="module")
def mailed(single):
    return parsed(single.read_text("utf-8"))


@pytest.fixture(scope="module")
def alone(single, tmp_path_factory):
    """The file's address in a folder that holds nothing else."""
    return Path(shutil.copy(single, tmp_path_factory.mktemp("mailed"))).as_uri()


@pytest.fixture(scope="module")
def tab(browser, alone):
    """The file in a browser without a network, when its simulator runs; it asks for nothing but itself."""
    with opened(browser, alone, home=alone, offline=True) as page:
        page.set_default_timeout(120_000)
        wait_for(page, RUNNING)
        yield page


def go(tab, id):
    """Follow an address inside the file."""
    tab.evaluate("id => { location.hash = '#' + id }", id)
    wait_for(tab, f"Chapter.shown().contains(document.getElementById('{id}'))")


def test_file_can_be_mailed_and_a_larger_one_is_not_written(single, monkeypatch):
    assert 1_000_000 < single.stat().st_size < edition.LARGEST == 12_000_000
    monkeypatch.setattr(edition, "LARGEST", 1_000_000)
    monkeypatch.setattr("book.editions.document.document", lambda site: " " * 1_000_001)
    with pytest.raises(edition.TooLarge, match="at most 1,000,000"):
        edition.single_file()


def test_edition_is_made_when_the_site_changed_or_it_is_not_there(stamped, capsys):
    made, place = [], stamped / "chapter.html"

    def times(site):
        edition.stamps.write("site", {"a": site})
        edition.make("single", place, lambda: made.append(site) or b"<html>")
        assert place.read_bytes() == b"<html>"
        return len(made)

    assert [times(site) for site in "1122"] == [1, 1, 2, 2] and "skipped" in capsys.readouterr().out
    place.unlink()
    assert times("2") == 3
    place.write_bytes(b"<ht")
    assert times("2") == 4


def test_every_id_occurs_once_and_every_name_and_link_leads_somewhere_and_nothing_would_be_loaded(mailed):
    ids = Counter(element["id"] for element in mailed.find_all(id=True))
    assert len(ids) > 500 and [id for id, count in ids.items() if count > 1] == []
    referred = [tag[name] for name in REFERRING for tag in mailed.select(f".chapter-page [{name}]")]
    words = {word for value in referred for word in value.split()}
    assert words and words <= ids.keys()
    links = [link["href"] for link in mailed.select("a[href]")]
    inside = [unquote(link[1:]) for link in links if link.startswith("#")]
    assert len(inside) > 500 and [link for link in inside if link not in ids] == []
    elsewhere = re.compile(r"#|data:application/(?:gzip|x-ipynb)|https?://|mailto:")
    assert [link for link in links if not elsewhere.match(link)] == []
    for name in ("src", "srcset", "poster", "data"):
        assert mailed.select(f"[{name}]:not([{name}^='data:'], [{name}=''])") == []
    assert mailed.select("link:not([href^='data:'])") == []


@pytest.mark.long
def test_same_site_gives_the_same_bytes(single, site):
    assert document(site).encode() == single.read_bytes()


def test_a_render_has_the_pixels_that_it_has_in_the_site(mailed, site):
    def pixels(data):
        return Image.open(BytesIO(data)).convert("RGBA").tobytes()

    there = {pixels(path.read_bytes()) for path in (site / "_images").glob("*.png")}
    here = mailed.select("img[src^='data:image/webp']")
    assert {pixels(b64decode(image["src"].partition(",")[2])) for image in here} == there


def test_every_page_is_whole(tab):
    pages = tab.evaluate("""async () => { const seen = {};
        for (const page of Chapter.pages) {
            Chapter.show(page);
            const count = selector => page.querySelectorAll(selector).length;
            const images = [...page.querySelectorAll('img')].filter(i => i.src);
            await Promise.allSettled(images.map(i => i.decode()));
            seen[page.dataset.page] = { alone: Chapter.pages.every(p => p.hasAttribute('hidden') === (p !== page)),
                unloaded: images.filter(i => !(i.complete && i.naturalWidth)).length };
        }
        return seen; }""")
    assert len(pages) > 20
    good = {"alone": True, "unloaded": 0}
    assert {name: page for name, page in pages.items() if page != good} == {}
    formulas = "[...document.fonts].filter(f => f.family.includes('Book Formulas')).map(f => f.status)"
    assert tab.evaluate(formulas) == ["loaded"]


def test_links_turn_pages_and_the_way_back_leads_back(tab):
    go(tab, "s1")
    tab.locator(".bd-docs-nav a:visible", has_text="§7").click()
    wait_for(tab, "Chapter.shown().dataset.page === 's7'")
    assert tab.locator(".bd-docs-nav a.current").inner_text().startswith("§7") and tab.title().startswith("§7")
    tab.evaluate("scrollTo(0, 600)")
    tab.locator(".chapter-page:not([hidden]) a[href^='#theorem-']:visible").first.evaluate("link => link.click()")
    wait_for(tab, "document.querySelector(':target')?.getBoundingClientRect().top < innerHeight")
    tab.go_back()
    wait_for(tab, "Chapter.shown().dataset.page === 's7' && Math.abs(scrollY - 600) < 2")


def test_simulator_draws_its_slider_works_and_loupe_and_certificate_are_there(tab):
    go(tab, "s4")
    tab.evaluate("document.querySelectorAll('.sim-fold').forEach(fold => { fold.open = true })")
    pixels = "document.querySelector('[data-picture=difference] canvas').toDataURL()"
    before = tab.evaluate(pixels)
    tab.press("#sim-eps", "Home")
    wait_for(tab, f"{pixels} !== '{before}' && location.hash.startsWith('#sim?')")
    tab.select_option("#sim-view", "bounds")
    for shown in ("#loupe .sim-bits tbody tr", CERTAIN):
        tab.locator(shown.split()[0]).scroll_into_view_if_needed()
        tab.wait_for_selector(shown)
    tab.select_option("#sim-view", "image")


def test_certificates_are_checked_and_kept_files_come_out_under_their_own_names(tab, site):
    go(tab, "theorem-unit_length")
    tab.evaluate(
        "unfold(document); document.querySelectorAll('#theorem-unit_length details').forEach(e => e.open = true)"
    )
    with tab.expect_download() as download:
        tab.locator("a[data-packed='unit_length.py']").first.click()
    written = site / "_downloads" / "theorems" / download.value.suggested_filename
    assert Path(download.value.path()).read_bytes() == written.read_bytes()
    go(tab, tab.evaluate("document.querySelector('.checker[data-all]').closest('section[id]').id"))
    tab.locator(".checker[data-all] button").click()
    count = len(list(FOLDER.glob("*.json")))
    expect(tab.locator(".checker[data-all] .check-verdict")).to_contain_text(
        f"{count} of {count} theorems", timeout=120_000
    )


def test_dark_mode_has_the_dark_pictures_of_the_site(tab, site):
    go(tab, "s1")
    papers = set()
    while len(papers) < 2 or tab.evaluate("document.documentElement.dataset.theme") != "dark":
        tab.locator(".theme-switch-button:visible").first.click()
        papers.add(tab.evaluate("getComputedStyle(document.body).backgroundColor"))
    tab.evaluate("Chapter.pages.forEach(page => Chapter.show(page))")
    sources = set(tab.evaluate("[...document.querySelectorAll('img.only-dark')].map(i => i.getAttribute('src'))"))
    dark = [path for path in (site / "_images").glob("*.dark.svg") if ".phone" not in path.suffixes]
    assert sources == {svg_address(svg_parts(path)) for path in dark}


def test_file_fits_a_phone_and_its_menu_leads_on(browser, alone):
    with opened(browser, alone, **PHONE) as tab:
        assert tab.evaluate("document.documentElement.scrollWidth") <= PHONE["viewport"]["width"]
        tab.locator("button.primary-toggle").click()
        tab.locator(".bd-docs-nav a:visible", has_text="§1").click()
        wait_for(tab, "Chapter.shown().dataset.page === 's1' && !document.querySelector('dialog[open]')")


def test_without_scripts_every_page_stands_there(browser, alone):
    with opened(browser, alone, java_script_enabled=False) as tab:
        for id in ("s9", "theorem-kink_loci", "fig-three_pictures"):
            assert tab.locator(f"[id='{id}']").is_visible()
