"""The pages of the built site, read: what each shows, and what it asks to be loaded."""

import posixpath
import re
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import unquote, urlsplit

from bs4 import BeautifulSoup, Tag

from proofs.engine.project import PROJECT

ARTICLE = re.compile(r'<article class="bd-article">(.*)</article>', re.DOTALL)
COLORED = re.compile(r'<span class="\w{1,3}">([^<]*)</span>')  # in a listing
SHELL = PROJECT.page.get("shell", "index")  # the page whose frame is taken: one with contents beside it
LEFT_OUT = {"search.html", "genindex.html"}  # a file has no search, and its index is empty


@dataclass(frozen=True)
class Page:
    """A page of the site: its address without .html, and its parts as parsed."""

    name: str
    article: Tag
    contents: Tag | None  # "on this page", a list of links
    neighbours: Tag | None  # links to the pages before and after
    loads: dict[str, Tag]  # style sheets and scripts by their paths in the site, in their order

    @property
    def listing(self) -> bool:
        """Return whether it is a source's listing, which has no place in the order of the chapter."""
        return self.name.startswith("source/")

    @property
    def title(self) -> str:
        heading = self.article.find("h1")
        return heading.get_text().removesuffix("#").strip() if heading else self.name


def parsed(text: str) -> BeautifulSoup:
    return BeautifulSoup(text, "html.parser")


def target(page: str, address: str) -> tuple[str, str] | None:
    """Return the file of the site, and the fragment, that an address on a page means; None if it leads elsewhere."""
    parts = urlsplit(address)
    if parts.scheme or parts.netloc:
        return None
    path = posixpath.normpath(posixpath.join(posixpath.dirname(page), unquote(parts.path))) if parts.path else ""
    return path or f"{page}.html", unquote(parts.fragment)


def read_page(site: Path, name: str) -> Page:
    """Read one page, without what the site alone has. Of a listing, which is large, the bare article is wanted."""
    text = (site / f"{name}.html").read_text(encoding="utf-8")
    if name.startswith("source/"):
        return Page(name, parsed(COLORED.sub(r"\1", ARTICLE.search(text)[0])).article, None, None, {})
    soup = parsed(text)
    article = soup.find("article", class_="bd-article")
    for part in article.select(".site-only"):
        part.decompose()
    contents = soup.select_one("#pst-page-toc-nav > ul")
    loading = soup.select("link[rel=stylesheet][href], script[src]")
    loads = {target(name, tag.get("src") or tag["href"])[0]: tag for tag in loading}
    return Page(name, article, contents, soup.find("footer", class_="prev-next-footer"), loads)


def linked(part: Tag, page: str) -> Iterator[str]:
    """Return the names of the pages that a part of a page leads to."""
    for link in part.find_all("a", href=True):
        aim = target(page, link["href"])
        if aim and aim[0].endswith(".html") and aim[0] not in LEFT_OUT:
            yield aim[0].removesuffix(".html")


def read_pages(site: Path, shell: BeautifulSoup) -> list[Page]:
    """Return every page in the order of the sidebar, then those that these lead to, as they are met."""
    waiting = [*linked(shell.select_one("nav.bd-docs-nav"), SHELL)]
    pages: dict[str, Page] = {}
    for name in waiting:  # it grows while it is read
        if name not in pages:
            pages[name] = read_page(site, name)
            waiting.extend(linked(pages[name].article, name))
    return list(pages.values())


def make_small(page: Page, links: Collection[str]) -> None:
    """Make a listing small: without colours, its numbers in a column of their own.

    Lines that one of the file's `#id` links leads to keep their ids.
    """
    pre = page.article.find("pre")
    for part in pre.find_all(True):
        if f"#{part.get('id')}" in links:
            part.attrs = {"id": part["id"], "class": "line"}
        elif part.name == "a" or "linenos" in part.get("class", ()):
            part.decompose()
        else:
            part.unwrap()
    count = pre.get_text().rstrip("\n").count("\n") + 1
    numbers = "\n".join(str(n + 1) for n in range(count))
    pre.insert_before(parsed(f'<div class="numbers" aria-hidden="true">{numbers}</div>').div)
