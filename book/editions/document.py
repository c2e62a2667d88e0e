"""The document: the site's own frame around all of its pages, one shown at a time, with everything in it."""

from collections.abc import Iterator
from pathlib import Path

from bs4 import BeautifulSoup, Tag
from bs4.dammit import EntitySubstitution
from bs4.formatter import HTMLFormatter

from book.editions.inlined import data_address, inlined_script, inlined_styles, packed_address
from book.editions.names import Names, ids_of, relink, rename
from book.editions.pages import SHELL, Page, make_small, parsed, read_pages, target
from book.editions.pictures import inline_pictures

HERE = Path(__file__).parent
SHARED = "shared.js"  # which the file's own script needs; all others are marked data-moves, and are not printed
POLICY = (
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline' 'wasm-unsafe-eval' blob:; "
    "worker-src blob:; img-src data: blob:; font-src data:; connect-src 'none'; form-action 'none'; "
    "base-uri 'none'"
)


LARGEST_DATA = 12_000
"""Bytes of a figure's packed numbers: larger ones are not mailed. The figure is, and the command beside makes them."""


class Addresses(HTMLFormatter):
    """Write as bs4 does, but that a drawing's < and > stay what they are in its address: they would be four letters."""

    def attribute_value(self, value: str) -> str:
        """Return the value between its quotation marks."""
        return value.replace("&", "&amp;")


class Chapter:
    """The pages of the site with the names that they have in one file."""

    def __init__(self, site: Path):
        self.site = site
        self.shell = parsed((site / f"{SHELL}.html").read_text(encoding="utf-8"))
        self.pages = read_pages(site, self.shell)
        strip_shell(self.shell)
        self.names = Names(self.pages, ids_of(self.shell))
        self.used: set[str] = set()
        self.packed: dict[bytes, str] = {}

    def prepare(self) -> None:
        """Rename, link, and put pictures in; listings last, when it is known which of their lines are wanted."""
        for page in self.pages:
            rename(page, self.names)
            for part in filter(None, (page.article, page.contents, page.neighbours)):
                relink(part, page.name, self.names, self.pack)
                self.used.update(link["href"] for link in part.find_all("a", href=True) if link["href"][0] == "#")
            inline_pictures(self.site, page)
            for listed in page.article.select(".checker[data-all] > script"):
                listed.decompose()  # the cards are in the file, with their certificates
        for page in self.pages:
            if page.listing:
                make_small(page, self.used)

    def pack(self, link: Tag, path: str) -> None:
        """Make a link to a file of the site carry the file, compressed; the script unpacks it under its own name."""
        file = self.site / path
        link.attrs.pop("target", None)
        content = file.read_bytes()
        address = packed_address(content)
        if file.suffix in (".csv", ".npz") and len(address) > LARGEST_DATA:
            link.name, link.attrs = "span", {"class": ["not-mailed"]}
            link.string = f"data: {file.name}, by the command"
            return
        link["data-packed"] = file.name
        if content in self.packed:  # the first link to it holds it
            link["href"] = f"#{self.packed[content]}"
            return
        self.packed[content] = link["id"] = f"file-{len(self.packed) + 1}"
        link["href"], link["download"] = address, f"{file.name}.gz"

    def loads(self, kind: str) -> list[tuple[Path, Tag]]:
        """Return the files that pages load as <link> or <script>, each once: its file and its element.

        Scripts stand where they come first: what pages share precedes their own. Style sheets, where they come last.
        """
        pairs = [(path, tag) for page in self.pages for path, tag in page.loads.items() if tag.name == kind]
        tags = dict(pairs) if kind == "script" else dict(reversed(dict(reversed(pairs)).items()))
        return [(self.site / path, tag) for path, tag in tags.items()]

    def scripts(self, deferred: bool) -> Iterator[Tag]:
        """Return every script as an element, with its data: those that wait for the document, or those that do not."""
        for path, tag in self.loads("script"):
            if tag.has_attr("defer") == deferred:
                text, data = inlined_script(path), {n: value for n, value in tag.attrs.items() if n.startswith("data-")}
                if path.name != SHARED:
                    data["data-moves"] = ""
                yield self.shell.new_tag("script", attrs=data, string=text)


def strip_shell(shell: BeautifulSoup) -> None:
    for rule in (
        "article, footer.prev-next-footer, #jb-print-docs-body, #searchbox, .dropdown-download-buttons li:has(a[href])",
        "#pst-page-toc-nav > ul, .search-button, .sidebar-primary-item:has(.search-button-field), #pst-search-dialog",
        "link[rel]:not([rel=icon]), script[src], #ethical-ad-placement, .bd-footer, .bd-footer-content",
    ):
        for tag in shell.select(rule):
            tag.decompose()


def wrapped(chapter: Chapter, page: Page) -> Tag:
    """Return a page as it stands in the file: its article, and the links to its neighbours."""
    attributes = {"class": "chapter-page", "data-page": page.name, "data-title": page.title}
    box = chapter.shell.new_tag("div", attrs=attributes)
    if not page.article.find("section", id=True):
        box["id"] = page.name
    for load in page.article.select("link[rel=stylesheet], script[src]"):
        load.extract()
    box.append(page.article)
    if page.neighbours:
        box.append(page.neighbours)
    return box


def put_pages(chapter: Chapter) -> None:
    shell = chapter.shell
    inside, contents = shell.select_one(".bd-article-container"), shell.select_one("#pst-page-toc-nav")
    for page in chapter.pages:
        inside.append(wrapped(chapter, page))
        if page.contents:
            page.contents["data-of"] = page.name  # it is shown with this page only
            contents.append(page.contents)


def put_head(chapter: Chapter) -> None:
    shell, head = chapter.shell, chapter.shell.head
    head.select_one("meta[http-equiv=Content-Security-Policy]").decompose()
    shell.title.string = shell.select_one("nav.bd-docs-nav a").get_text().strip()
    icon = shell.select_one("link[rel=icon]")
    icon["href"] = data_address(chapter.site / target(SHELL, icon["href"])[0])
    policy = {"http-equiv": "Content-Security-Policy", "content": POLICY}
    head.find("meta", charset=True).insert_after(shell.new_tag("meta", attrs=policy))
    styles = "\n".join(inlined_styles(path) for path, _ in chapter.loads("link"))
    head.append(shell.new_tag("style", string=styles + (HERE / "single.css").read_text(encoding="utf-8")))


def put_scripts(chapter: Chapter) -> None:
    """Put scripts in the order in which a browser would run them; the file's own comes last."""
    head, body = chapter.shell.head, chapter.shell.body
    options = next(tag for tag in head.find_all("script") if "DOCUMENTATION_OPTIONS" in tag.get_text())
    options.insert_before(*chapter.scripts(deferred=False))
    body.extend(chapter.scripts(deferred=True))
    body.append(chapter.shell.new_tag("script", string=(HERE / "single.js").read_text(encoding="utf-8")))


def document(site: Path) -> str:
    chapter = Chapter(site)
    chapter.prepare()
    sidebar = chapter.shell.select_one("#pst-primary-sidebar")
    relink(sidebar, SHELL, chapter.names, lambda link, path: link.decompose())
    put_pages(chapter)
    put_head(chapter)
    put_scripts(chapter)
    return chapter.shell.decode(formatter=Addresses(EntitySubstitution.substitute_xml)).strip() + "\n"
