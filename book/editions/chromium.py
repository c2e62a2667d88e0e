"""PDF of the one-file edition, printed by the installed Chromium with its own outline and tags."""

import re
import shutil
from collections.abc import Sequence
from pathlib import Path

from playwright.sync_api import Browser, Page, sync_playwright

from book.assembly.stamps import Refused

HERE = Path(__file__).parent
FLAGS = ["--disable-gpu", "--disable-quic"]  # beside Playwright's own, by which it says no word to the network
PAGE = {"width": 658, "height": 979}  # A4 inside its margins, in CSS pixels
PATIENCE = 900_000  # milliseconds: a busy machine typesets thousands of formulas slowly
FOOTER = (
    '<div style="color: #66625a; display: flex; font: 8pt Georgia, serif; justify-content: space-between; '
    'margin: 0 18mm; width: 100%"><span class="title"></span><span class="pageNumber"></span></div>'
)
DATE = b"D:20250101000000+00'00'"  # the date that the site is told too
TITLE = re.compile(rb"/Title (?:<FEFF([0-9A-F]+)>|\(((?:\\.|[^\\)])*)\))")  # in UTF-16, or in ASCII
NODE = re.compile(rb"node\d{8}")  # by which a table's cells name their heads
MOVES = re.compile(r"<script [^>]*data-moves=.*?</script>", re.DOTALL)


class NoBrowser(Refused):
    """There is no Chromium to print with."""

    status = 1


def installed() -> str:
    """Return the path of the installed Chromium, if it can be the one without a window; NoBrowser if there is none."""
    for name in ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome"):
        if path := shutil.which(name):
            return path
    raise NoBrowser("no Chromium is installed, and the chapter is printed by one (Debian: apt install chromium)")


def on_paper(browser: Browser, single: str, pages: Sequence[str] = ()) -> Page:
    """Return a tab with the one file made ready for paper: all of it, or some of its pages. Nothing moves in it."""
    tab = browser.new_page(viewport=PAGE, color_scheme="light", offline=True)
    tab.set_default_timeout(PATIENCE)
    tab.emulate_media(media="print")
    tab.set_content(MOVES.sub("", single))
    tab.add_style_tag(path=HERE / "paper.css")
    tab.add_script_tag(path=HERE / "paper.js")
    tab.evaluate("pages => put_on_paper(pages)", pages)
    return tab


def reproducible(pdf: bytes) -> bytes:
    """Return the file, of the same length, without what Chromium says of this run: its date and its count of nodes."""
    names = {name: b"node%08d" % number for number, name in enumerate(sorted(set(NODE.findall(pdf))))}
    return NODE.sub(lambda node: names[node[0]], re.sub(rb"D:\d{14}\+00'00'", DATE, pdf))


BEGIN_A_PAGE = """numbers => {
    const headings = document.querySelectorAll('h1, h2, h3, h4, h5, h6');
    for (const number of numbers) headings[number].style.breakBefore = 'page';
    return [...headings].map(heading => heading.textContent);
}"""


def printed(tab: Page) -> bytes:
    """Print a tab as PDF; the same bytes each time.

    A heading may find room at the foot of a page and its text none: Chromium then lays it out on both pages and has it
    twice in the outline. Such a one begins a page, and all is printed again.
    """
    twice: list[int] = []
    while True:
        headings = tab.evaluate(BEGIN_A_PAGE, twice)
        pdf = reproducible(
            tab.pdf(
                prefer_css_page_size=True,
                print_background=True,
                display_header_footer=True,
                header_template="<span></span>",
                footer_template=FOOTER,
                tagged=True,
                outline=True,
            )
        )
        outline = titles(pdf)
        twice = [number for number, heading in enumerate(headings) if 2 * "".join(heading.split()) in outline]
        if not twice:
            return pdf


def titles(pdf: bytes) -> set[str]:
    """Return the titles in the outline of a file that Chromium wrote, without blanks."""
    pieces = TITLE.findall(pdf)
    ascii_or_wide = [
        re.sub(rb"\\(.)", rb"\1", text).decode("ascii") or bytes.fromhex(wide.decode()).decode("utf-16-be")
        for wide, text in pieces
    ]
    return {"".join(title.split()) for title in ascii_or_wide}


def print_chapter(single: str) -> bytes:
    """Return the one file's chapter as PDF; raises NoBrowser."""
    path = installed()
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path, args=FLAGS)
        pdf = printed(on_paper(browser, single))
        browser.close()
    return pdf
