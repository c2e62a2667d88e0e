"""The printed chapter: every section and figure is there, nothing is cut off, and every link leads to a page."""

import re
from io import BytesIO
from itertools import pairwise

import pypdfium2
import pytest
from pypdf import PdfReader

from book.editions import chromium
from book.editions.files import printed
from book.editions.graph import TALLEST, cut_graph, cuts
from book.editions.pages import parsed
from book.editions.paper import STILL, document, drop_link, keep_together, on_paper

POINTS = 72 / 25.4  # in a millimetre
SIDE, TOP, FOOT = 18 * POINTS, 18 * POINTS, 20 * POINTS  # the margins of a page
A4 = (210 * POINTS, 297 * POINTS)
BESIDE_THE_PAGE = """() => [...document.querySelectorAll('body *')].filter(e => {
    const box = e.getBoundingClientRect();
    return box.width && box.height && (box.right > innerWidth + 1 || box.left < -1) && !e.closest('mjx-assistive-mml');
}).map(e => e.outerHTML.slice(0, 120))"""
CAPTIONS = """() => [...document.querySelectorAll('figcaption .caption-number')].map(n => [n.textContent.trim(),
    n.parentElement.querySelector('.caption-text').firstChild.textContent.slice(0, 20).trim()])"""
CLIPPED = """() => [...document.querySelectorAll('pre, table, mjx-container, p, li, details, figure, div')].filter(e =>
    e.scrollWidth > e.clientWidth + 1 && e.clientWidth && getComputedStyle(e).overflowX !== 'visible')
    .map(e => e.outerHTML.slice(0, 120))"""


@pytest.fixture(scope="module")
def paper(browser, site, tmp_path_factory):
    """The document as the browser is about to print it."""
    place = tmp_path_factory.mktemp("paper") / "chapter.html"
    place.write_text(document(site), encoding="utf-8")
    tab = chromium.opened(browser, place)
    yield tab
    tab.close()


@pytest.fixture(scope="module")
def pdf(paper) -> bytes:
    return chromium.numbered(paper)


@pytest.fixture(scope="module")
def texts(pdf) -> list[str]:
    """The text of every page, without blanks."""
    pages = pypdfium2.PdfDocument(pdf)
    return [words(page.get_textpage().get_text_bounded()) for page in pages]


def words(text: str) -> str:
    """A text without its blanks, which a reader of PDF may see where letters are kerned, and without pictographs."""
    return "".join(
        c for c in "".join(text.replace("\ufffe", "-").split()) if not "\ud800" <= c <= "\udfff" and c < "\U00010000"
    )


def test_every_section_stands_on_the_page_that_the_contents_name(paper, texts):
    entries = paper.evaluate(
        """[...document.querySelectorAll('.paper-contents li')].map(e => [e.querySelector('a').textContent,
            e.querySelector('.page-number').textContent])"""
    )
    assert len(entries) > 40
    for title, number in entries:
        assert words(title) in texts[int(number) - 1], (title, number)
    headings = paper.evaluate("[...document.querySelectorAll('h1, h2, h3')].map(h => h.innerText)")
    assert len(headings) > len(entries)
    assert [heading for heading in headings if not any(words(heading) in text for text in texts)] == []


def test_every_figure_of_the_site_is_drawn_on_a_page(paper, pdf, site):
    numbers = set()
    for path in site.glob("*.html"):
        if on_paper(path.stem):
            numbers.update(re.findall(r'<span class="caption-number">(Figure \d+) ', path.read_text(encoding="utf-8")))
    assert len(numbers) > 30
    captions = paper.evaluate(CAPTIONS)
    assert {number for number, _ in captions} >= numbers
    assert paper.evaluate("[...document.images].filter(i => !i.naturalWidth || !i.offsetWidth).length") == 0
    drawn = set()
    for page in pypdfium2.PdfDocument(pdf):
        text = page.get_textpage()
        for number, words_before_formulas in captions:
            found = text.search(f"{number} {words_before_formulas}".strip()).get_next()
            if found:
                _, _, _, top = text.get_charbox(found[0])
                assert ink(page, SIDE, top + 3, A4[0] - SIDE, top + 63) > 0.002, number
                drawn.add(number)
    assert drawn >= numbers


def ink(page, left: float, bottom: float, right: float, top: float) -> float:
    """Which part of a rectangle of a page, in points from its lower left corner, is not white."""
    width, height = page.get_size()
    cropped = page.render(scale=2, crop=(left, bottom, width - right, height - top), grayscale=True).to_numpy()
    return float((cropped < 250).mean())


def test_no_page_has_ink_in_its_margins(pdf):
    pages = pypdfium2.PdfDocument(pdf)
    assert len(pages) > 50
    for number, page in enumerate(pages, 1):
        width, height = page.get_size()
        assert (width, height) == pytest.approx(A4, abs=1)
        assert ink(page, 0, 0, SIDE - 2, height) == 0, f"page {number}, left"
        assert ink(page, width - SIDE + 2, 0, width, height) == 0, f"page {number}, right"
        assert ink(page, 0, height - TOP + 2, width, height) == 0, f"page {number}, top"
        assert ink(page, 0, 0, width, FOOT / 4) == 0, f"page {number}, bottom"
    assert ink(pages[0], SIDE, FOOT, A4[0] - SIDE, A4[1] - TOP) > 0.05  # it sees ink where there is some


def test_nothing_is_wider_than_the_page_or_cut_off_and_it_would_be_seen(paper):
    assert paper.evaluate(BESIDE_THE_PAGE) == []
    assert paper.evaluate(CLIPPED) == []
    assert paper.evaluate("document.querySelectorAll('mjx-merror, [data-mjx-error]').length") == 0
    paper.evaluate(
        """() => { document.body.insertAdjacentHTML('beforeend', `<div id=wide style=width:700px>wide</div>
            <pre id=clipped style='overflow: hidden !important; white-space: pre'>${'x'.repeat(400)}</pre>`) }"""
    )
    assert [html[:8] for html in paper.evaluate(BESIDE_THE_PAGE)] == ["<div id="]
    assert [html[:8] for html in paper.evaluate(CLIPPED)] == ["<pre id="]
    paper.evaluate("document.querySelectorAll('#wide, #clipped').forEach(e => e.remove())")


def test_every_link_leads_to_a_page_or_to_the_web(pdf):
    reader = PdfReader(BytesIO(pdf))
    places, inside = reader.named_destinations, 0
    for page in reader.pages:
        for note in page.get("/Annots") or ():
            link = note.get_object()
            if link.get("/Subtype") != "/Link":
                continue
            if "/Dest" in link:
                inside += 1
                assert str(link["/Dest"]) in places, link["/Dest"]
            else:
                assert re.match(r"https?://|mailto:", link["/A"]["/URI"]), link["/A"]
    assert inside > 300
    assert len(reader.outline) > 10


def test_steps_are_unfolded_and_the_simulator_stands_still(paper, texts):
    text = "".join(texts)
    assert paper.evaluate("document.querySelectorAll('details:not([open])').length") == 0
    assert text.count(words("False variants, refused by the same path")) == paper.evaluate(
        "[...document.querySelectorAll('.part')].filter(p => p.textContent.startsWith('False variants')).length"
    )
    assert words(STILL) in text
    assert paper.evaluate("document.querySelectorAll('button, input, canvas, .simulator, .only-dark').length") == 0


def test_pages_are_numbered_and_white(paper, pdf, texts):
    title = words(paper.title())
    assert [number for number, text in enumerate(texts, 1) if not text.endswith(f"{title}{number}")] == []
    for page in pypdfium2.PdfDocument(pdf):
        assert page.render(scale=0.2).to_numpy()[2, 2].min() == 255


def test_what_only_a_run_says_is_not_in_the_file_and_nothing_moves():
    made = b"(D:20991231235959+00'00') /ID (node00000419) /ID (node00001421) /Headers [(node00000419)]"
    later = made.replace(b"2099", b"2098").replace(b"node00000419", b"node00000420").replace(b"1421", b"1423")
    assert chromium.reproducible(made) == chromium.reproducible(later)
    assert len(chromium.reproducible(made)) == len(made)
    assert chromium.reproducible(made) != chromium.reproducible(made.replace(b"[(node00000419)]", b"[(node00001421)]"))


def test_without_a_browser_it_says_so(monkeypatch):
    monkeypatch.setattr(chromium.shutil, "which", lambda name: None)
    monkeypatch.setattr("book.editions.paper.document", lambda site: "")
    with pytest.raises(chromium.NoBrowser, match="no Chromium is installed"):
        printed()


def test_listings_and_reference_stay_elsewhere():
    assert [on_paper(name) for name in ("s1", "accuracy")] == [True, True]
    assert [on_paper(name) for name in ("source/proofs/kernel", "api-proofs")] == [False, False]


def test_link_without_a_page_is_dropped():
    line = parsed(
        '<p class="provenance"><a href="a">source</a> · <a href="b">data</a> · reproduce: x</p><p><a href="a">y</a></p>'
    )
    for link in line.find_all("a"):
        drop_link(link)
    assert line.get_text() == "reproduce: xy"


def test_title_stays_with_its_list():
    part = parsed('<details><p class="part">Steps</p><ol><li>1</li></ol><p>after</p></details>').details
    keep_together(part.p)
    assert part.div.get_text() == "Steps1" and part.find_all("p", recursive=False)[0].get_text() == "after"


def test_graph_is_cut_between_its_rows():
    assert cuts([10, 50, 90], 100) == [(0.0, 100)]
    rows = [20.0 + 30 * n for n in range(40)]
    pieces = cuts(rows, 1220)
    assert all(bottom - top <= TALLEST for top, bottom in pieces)
    assert not any(abs(row - top) < 10 for row in rows for top, _ in pieces[1:])
    assert pieces[0][0] == 0 and pieces[-1][1] == 1220 and all(a[1] == b[0] for a, b in pairwise(pieces))


def test_pieces_of_a_graph_hold_every_node_once():
    nodes = "".join(f'<g class="node" id="n{y}"><circle class="reach" cy="{y}"/></g>' for y in range(20, 620, 30))
    edge = '<path class="edge" d="M100 590C50 590 50 20 100 20"/>'
    graph = parsed(f'<div><div class="graph"><svg viewBox="0 0 450 620">{edge}{nodes}</svg></div></div>').div
    cut_graph(graph)
    assert len(graph.find_all("svg")) >= 3
    assert [g["id"] for g in graph.find_all("g")] == [f"n{y}" for y in range(20, 620, 30)]
    assert len(graph.find_all("path")) == len(graph.find_all("svg"))
