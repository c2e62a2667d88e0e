"""The document that is printed: every page of the chapter, one after the other, with nothing folded away."""

from html import escape
from pathlib import Path

from bs4 import BeautifulSoup, NavigableString, Tag

from book.editions.graph import cut_graph
from book.editions.names import Names, relink, rename
from book.editions.pages import SHELL, Page, parsed, read_pages
from book.editions.pictures import inline_pictures
from book.editions.store import Store, inlined_script, inlined_styles

HERE = Path(__file__).parent
ELSEWHERE = ("source/", "api-")  # how the names of pages begin that are not printed
ACTIVE = "a.headerlink, script, noscript, link, button, input, select, textarea, canvas, dialog"
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
        place.replace_with(parsed(f'<p class="on-paper">{STILL}</p>').p)
    for tag in article.select(f"{ACTIVE}, img.only-dark"):
        tag.decompose()
    for details in article.find_all("details"):
        details["open"] = ""
    for part in article.select(".theorem details > .part"):
        keep_together(part)
    cut_graph(article)


def keep_together(title: Tag) -> None:
    """Put the title of a card's part and the list under it into a box, which a page does not break."""
    box = parsed('<div class="together"></div>').div
    title.insert_before(box)
    below = title.find_next_sibling()
    box.extend([title, below] if below and below.name in ("ul", "ol") else [title])


def heading(section: Tag) -> str:
    return section.find(["h1", "h2"]).get_text().strip()


def entry(section: Tag, inside: str = "") -> str:
    """A line of the contents; the number of the page is filled in when it is known."""
    id, text = section["id"], escape(heading(section))
    return f'<li><a href="#{id}">{text}</a><span class="page-number" data-for="{id}"></span>{inside}</li>'


def contents(pages: list[Page]) -> Tag:
    """The table of contents: pages, and their sections, one below the title."""
    lines = []
    for page in pages:
        first = page.article.find("section", id=True)
        parts = [part for part in first.find_all("section", recursive=False) if part.find("h2", recursive=False)]
        lines.append(entry(first, f"<ol>{''.join(map(entry, parts))}</ol>" if parts else ""))
    return parsed(f'<nav class="paper-contents"><h2>Contents</h2><ol>{"".join(lines)}</ol></nav>').nav


def name_headings(article: Tag) -> None:
    """Give sections' names to their headings: a heading may stand on the page after the one that its section ends."""
    for section in article.find_all("section", id=True):
        if title := section.find(["h1", "h2", "h3"], recursive=False):
            title["id"] = section.attrs.pop("id")


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
    shell, store = parsed((site / f"{SHELL}.html").read_text(encoding="utf-8")), Store()
    pages = read(site, shell, store)
    loads = {path: tag.name for page in pages for path, tag in page.loads.items()}
    styles = [inlined_styles(site / path) for path, name in loads.items() if name == "link"]
    mathjax = next(path for path in loads if path.startswith("_static/mathjax/"))
    setting = next(tag.get_text() for tag in shell.find_all("script") if "window.MathJax" in tag.get_text())
    whole = parsed(FRAME)
    whole.title.string = heading(pages[0].article)
    front, *rest = [page.article for page in pages]
    listed = contents(pages[1:])
    for page in pages:
        name_headings(page.article)
    whole.body.extend([front, listed, *rest])
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
