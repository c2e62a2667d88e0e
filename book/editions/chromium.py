"""Print a document with the installed Chromium, twice: the contents have page numbers when the pages are known."""

import re
import shutil
import tempfile
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING

from book.assembly.stamps import Refused

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

# Headless, as root, and without a word to the network of its own.
FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]
PAGE = {"width": 658, "height": 979}  # what A4 has inside its margins, in CSS pixels
PRINTINGS = 4  # at most; the first has the pages that were counted, or the second those of the first
PATIENCE = 900_000  # milliseconds: a busy machine typesets thousands of formulas slowly
FOOTER = (
    '<div style="color: #66625a; display: flex; font: 8pt Georgia, serif; justify-content: space-between; '
    'margin: 0 18mm; width: 100%"><span class="title"></span><span class="pageNumber"></span></div>'
)
DATE = b"D:20250101000000+00'00'"  # the date that the site is told too
NODE = re.compile(rb"node\d{8}")  # by which a table's cells name their heads


class NoBrowser(Refused):
    """There is no Chromium to print with."""

    status = 1


def installed() -> str:
    """The path of the installed Chromium, if it can be the one without a window; NoBrowser if there is none."""
    for name in ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome"):
        if found := shutil.which(name):
            return found
    raise NoBrowser("no Chromium is installed, and the chapter is printed by one (Debian: apt install chromium)")


def opened(browser: "Browser", place: Path) -> "Page":
    """A tab with the document as it will be printed, everything made to fit the page."""
    tab = browser.new_page(viewport=PAGE, color_scheme="light", offline=True)
    tab.set_default_timeout(PATIENCE)
    tab.emulate_media(media="print", color_scheme="light")
    tab.goto(place.as_uri())
    tab.evaluate("fitToPage()")
    return tab


def printed(tab: "Page", marked: bool = True) -> bytes:
    """The document as PDF; marked: with its tags and outline."""
    return tab.pdf(
        prefer_css_page_size=True,
        print_background=True,
        display_header_footer=True,
        header_template="<span></span>",
        footer_template=FOOTER,
        tagged=marked,
        outline=marked,
    )


def page_numbers(pdf: bytes) -> dict[str, int]:
    """The number of the page, from 1, on which every named place stands."""
    from pypdf import PdfReader

    reader = PdfReader(BytesIO(pdf))
    places = reader.named_destinations
    return {name.lstrip("/"): reader.get_destination_page_number(place) + 1 for name, place in places.items()}


def reproducible(pdf: bytes) -> bytes:
    """The file, of the same length, without what Chromium says of this run: its date, and the nodes it has counted."""
    names = {name: b"node%08d" % number for number, name in enumerate(sorted(set(NODE.findall(pdf))))}
    return NODE.sub(lambda found: names[found[0]], re.sub(rb"D:\d{14}\+00'00'", DATE, pdf))


def numbered(tab: "Page") -> bytes:
    """The open document as PDF, with the numbers of its pages in its contents: printed until they stay as they are.

    The first printing only counts pages, and nothing on them is seen: that takes a third of the time.
    """
    unseen = tab.add_style_tag(content="body * { visibility: hidden !important }")
    numbers = page_numbers(printed(tab, marked=False))
    unseen.evaluate("style => style.remove()")
    for _ in range(PRINTINGS):
        tab.evaluate(
            "numbers => document.querySelectorAll('.page-number').forEach(p => p.textContent = numbers[p.dataset.for])",
            numbers,
        )
        pdf = printed(tab)
        found = page_numbers(pdf)
        if found == numbers:
            return reproducible(pdf)
        numbers = found
    raise RuntimeError("the contents moved the pages that they list")


def print_document(text: str) -> bytes:
    from playwright.sync_api import sync_playwright

    path = installed()
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        place = Path(folder) / "chapter.html"
        place.write_text(text, encoding="utf-8")
        browser = playwright.chromium.launch(executable_path=path, args=FLAGS)
        pdf = numbered(opened(browser, place))
        browser.close()
    return pdf
