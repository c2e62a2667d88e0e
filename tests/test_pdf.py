"""The printed chapter: its sections and figures are there, nothing is cut off, and every link leads to a page.

Some of its pages are printed here, which takes seconds; with --long, all of them.
"""

import re

import pypdfium2
import pytest

from book.editions import chromium
from book.editions.files import printed

PAGES = ("index", "s1", "s2", "s4")  # formulas, tables, figures, cards, the simulator
BESIDE_THE_PAGE = """() => [...document.querySelectorAll('body *')].filter(e => {
    const box = e.getBoundingClientRect();
    return box.width && box.height && (box.right > innerWidth + 1 || box.left < -1);
}).map(e => e.outerHTML.slice(0, 120))"""
CLIPPED = """() => [...document.querySelectorAll('pre, table, math, p, li, details, figure, div')].filter(e =>
    e.scrollWidth > e.clientWidth + 1 && e.clientWidth && getComputedStyle(e).overflowX !== 'visible')
    .map(e => e.outerHTML.slice(0, 120))"""
BARE = "[...document.querySelectorAll('figure')].filter(f => !f.querySelector('img, svg')).map(f => f.outerHTML)"


@pytest.fixture(scope="module", params=[PAGES, pytest.param((), marks=pytest.mark.long)], ids=["some", "all"])
def paper(browser, single, request):
    """The document as the browser is about to print it."""
    tab = chromium.on_paper(browser, single.read_text("utf-8"), request.param)
    yield tab
    tab.close()


@pytest.fixture(scope="module")
def content(paper):
    return chromium.printed(paper)


@pytest.fixture(scope="module")
def pdf(content):
    return pypdfium2.PdfDocument(content)


@pytest.fixture(scope="module")
def texts(paper, pdf):
    """The text of every page, without blanks and without its foot, which has the title and the page's number."""
    shown = [words(page.get_textpage().get_text_bounded()) for page in pdf]
    feet = [words(f"{paper.title()}{number}") for number in range(1, len(shown) + 1)]
    assert all(map(str.endswith, shown, feet))
    return [*map(str.removesuffix, shown, feet)]


def texts_of(paper, selector):
    """The texts of the document's elements, without blanks."""
    shown = paper.evaluate("selector => [...document.querySelectorAll(selector)].map(e => e.textContent)", selector)
    return [words(text) for text in shown]


def words(text):
    """A text without its blanks, which a reader of PDF may see where letters are kerned, and without pictographs."""
    return re.sub(r"[\s\ud800-\udfff\U00010000-\U0010ffff]", "", text.replace("\ufffe", "-"))


def test_every_heading_is_in_the_outline_which_names_its_page(paper, pdf, texts):
    outline = [(words(entry.get_title()), entry.get_dest().get_index()) for entry in pdf.get_toc()]
    assert [title for title, page in outline if title not in texts[page]] == []
    assert [title for title, _ in outline] == texts_of(paper, "h1, h2, h3, h4, h5, h6")


def test_the_front_has_room_on_one_page(texts):
    assert texts[1].startswith("Contents")


def test_every_figure_is_there_under_its_number(paper, texts):
    numbers, text = texts_of(paper, "figcaption .caption-number"), "".join(texts)
    assert len(numbers) > 5 and [number for number in numbers if number not in text] == []
    assert paper.evaluate(BARE) == []


def test_nothing_is_wider_than_the_page_or_cut_off(paper):
    assert paper.evaluate(BESIDE_THE_PAGE) == []
    assert paper.evaluate(CLIPPED) == []


def test_every_link_leads_to_a_page_or_to_the_web(paper, content):
    places = set(re.findall(rb"/(\S+) \[\d+ 0 R /XYZ", content))
    aims = re.findall(rb"/Dest /(\S+)", content)
    assert len(aims) > 20 and set(aims) <= places
    elsewhere = paper.evaluate("[...document.links].map(a => a.getAttribute('href')).filter(href => href[0] !== '#')")
    assert [address for address in elsewhere if not re.match(r"https?://|mailto:", address)] == []


def test_steps_are_unfolded_under_their_titles_and_the_simulator_stands_still(paper, texts):
    assert paper.evaluate("document.querySelectorAll('details:not([open])').length") == 0
    titles = texts_of(paper, ".theorem .part")
    assert titles and [text[-50:] for text in texts if text.endswith(tuple(titles))] == []
    assert texts_of(paper, "button, input, canvas, .coq, .simulator, .only-dark") == []


def test_what_only_a_run_says_is_not_in_the_file_and_nothing_moves():
    made = b"(D:20991231235959+00'00') /ID (node00000419) /ID (node00001421) /Headers [(node00000419)]"
    later = made.replace(b"2099", b"2098").replace(b"node00000419", b"node00000420").replace(b"1421", b"1423")
    assert chromium.reproducible(made) == chromium.reproducible(later)
    assert chromium.reproducible(made) != chromium.reproducible(made.replace(b"[(node00000419)]", b"[(node00001421)]"))


def test_without_a_browser_it_says_so(monkeypatch):
    monkeypatch.setattr(chromium.shutil, "which", lambda name: None)
    monkeypatch.setattr("book.editions.document.document", lambda site: "")
    with pytest.raises(chromium.NoBrowser, match="no Chromium is installed"):
        printed()
