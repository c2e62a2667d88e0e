"""The document that is printed: every page of the chapter, one after the other, with nothing folded away."""

from pathlib import Path

from bs4 import BeautifulSoup, NavigableString, Tag

from book.editions.graph import cut_graph
from book.editions.names import Names, relink, rename
from book.editions.pages import SHELL, Page, parsed, read_pages
from book.editions.pictures import inline_pictures
from book.editions.store import Store, inlined_script, inlined_styles

HERE = Path(__file__).parent
ELSEWHERE = ("source/", "api-")  # how the names of pages begin that are not printed
ACTIVE = "a.headerlink, script, noscript, link, button, input, select, textarea, canvas, dialog, fieldset.grade-filter"
FRAME = """<!DOCTYPE html>
<html lang="en" data-theme="light"><head><meta charset="utf-8"/><title></title></head><body></body></html>
"""
STILL = (
    "On paper the simulator stands still. It runs in the chapter's site, and in its single file; here are its figures."
)


def on_paper(name: str) -> bool:
    """Whether the page with this name is printed."""
    return not name.startswith(ELSEWHERE)


def drop_link(link: Tag) -> None:
    """A link that leads nowhere on paper: of provenance it goes with the dot after it, elsewhere its words stay."""
    after = link.next_sibling
    if link.find_parent(class_="provenance") and isinstance(after, NavigableString) and after.startswith(" · "):
        after.replace_with(str(after).removeprefix(" · "))
        link.decompose()
    else:
        link.unwrap()


def unfold(article: Tag) -> None:
    """Open what is folded, and take away what needs a hand."""
    for place in article.select(".simulator"):
        still = BeautifulSoup("", "html.parser").new_tag("p", attrs={"class": "on-paper"})
        still.string = STILL
        place.replace_with(still)
    for tag in article.select(f"{ACTIVE}, img.only-dark"):
        tag.decompose()
    for details in article.find_all("details"):
        details["open"] = ""
    for part in article.select(".theorem details > .part"):
        keep_together(part)
    cut_graph(article)


def keep_together(title: Tag) -> None:
    """Put the title of a card's part and the list under it into a box, which a page does not break."""
    box = BeautifulSoup("", "html.parser").new_tag("div", attrs={"class": "together"})
    title.insert_before(box)
    below = title.find_next_sibling()
    box.extend([title, below] if below and below.name in ("ul", "ol") else [title])


def sections(page: Page) -> list[Tag]:
    """The page's own sections, one below its title."""
    first = page.article.find("section", id=True)
    return [part for part in first.find_all("section", recursive=False) if part.find("h2", recursive=False)]


def heading(section: Tag) -> str:
    """The text of a section's title."""
    return section.find(["h1", "h2"]).get_text().strip()


def entry(soup: BeautifulSoup, id: str, text: str) -> Tag:
    """A line of the contents; the number of the page is filled in when it is known."""
    item, link = soup.new_tag("li"), soup.new_tag("a", href=f"#{id}")
    link.string = text
    number = soup.new_tag("span", attrs={"class": "page-number", "data-for": id})
    item.extend([link, number])
    return item


def contents(soup: BeautifulSoup, pages: list[Page]) -> Tag:
    """The table of contents: pages, and their sections."""
    nav = soup.new_tag("nav", attrs={"class": "paper-contents"})
    title, outer = soup.new_tag("h2"), soup.new_tag("ol")
    title.string = "Contents"
    nav.extend([title, outer])
    for page in pages:
        first = page.article.find("section", id=True)
        item = entry(soup, first["id"], heading(first))
        inner = soup.new_tag("ol")
        inner.extend(entry(soup, part["id"], heading(part)) for part in sections(page))
        if inner.find("li"):
            item.append(inner)
        outer.append(item)
    return nav


def read(site: Path, shell: BeautifulSoup, store: Store) -> list[Page]:
    """The pages to be printed, ready for paper."""
    pages = read_pages(site, shell, on_paper)
    names = Names(pages)
    for page in pages:
        unfold(page.article)
        rename(page, names)
        relink(page.article, page.name, names, lambda link, path: drop_link(link))
        inline_pictures(site, page, store)
    return pages


def document(site: Path) -> str:
    """The whole document, from the built site. It loads nothing."""
    shell, store = parsed((site / f"{SHELL}.html").read_text(encoding="utf-8")), Store()
    pages = read(site, shell, store)
    loads = dict.fromkeys(load for page in pages for load in page.loads)
    styles = [inlined_styles(site / load.path) for load in loads if not load.script]
    mathjax = next(load.path for load in loads if load.path.startswith("_static/mathjax/"))
    setting = next(tag.get_text() for tag in shell.find_all("script") if "window.MathJax" in tag.get_text())
    whole = parsed(FRAME)
    whole.title.string = heading(pages[0].article)
    front, *rest = [page.article for page in pages]
    whole.body.extend([front, contents(whole, pages[1:]), *rest])
    for place, name, text in (
        (whole.head, "style", "\n".join([*styles, (HERE / "print.css").read_text(encoding="utf-8")])),
        (whole.head, "script", setting),
        (whole.body, "script", inlined_script(site / mathjax)),
        (whole.body, "script", (HERE / "fit.js").read_text(encoding="utf-8")),
    ):
        part = whole.new_tag(name)
        part.string = store.keep(text)
        place.append(part)
    return store.fill(str(whole))
