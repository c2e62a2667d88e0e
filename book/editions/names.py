"""Every id once: those that several pages use get their page's name, and whatever refers to them follows."""

from collections import Counter
from collections.abc import Callable, Iterable

from bs4 import Tag

from book.editions.pages import Page, target

REFERRING = ("for", "aria-labelledby", "aria-describedby")  # what pages have of them


def ids_of(part: Tag) -> list[str]:
    return [tag["id"] for tag in part.find_all(id=True)]


class Names:
    """Names of the pages' ids in the one file."""

    def __init__(self, pages: Iterable[Page], reserved: Iterable[str]):
        """pages: every page of the file; reserved: ids of what stands around them, which keep their names."""
        self.pages = {page.name: page for page in pages}
        by_page = {name: ids_of(page.article) for name, page in self.pages.items()}
        count = Counter(id for ids in by_page.values() for id in set(ids)) + Counter(set(reserved))
        self.table = {n: {id: id if count[id] == 1 else f"{n}:{id}" for id in ids} for n, ids in by_page.items()}

    def top(self, name: str) -> str:
        """Return the id of a page: that of its first section, or its address where it has none."""
        section = self.pages[name].article.find("section", id=True)
        return self.table[name].get(section["id"], section["id"]) if section else name

    def place(self, path: str, id: str) -> str | None:
        """Return the single file's `#id` for a page of the site and an id on it; None if the file lacks that page."""
        name = path.removesuffix(".html")
        if name not in self.pages:
            return None
        return f"#{self.table[name][id] if id else self.top(name)}"


def rename(page: Page, names: Names) -> None:
    """Give the page's elements their new ids, and change every attribute that refers to one."""
    table = names.table[page.name]
    for tag in page.article.find_all(True):
        if tag.get("id"):
            tag["id"] = table[tag["id"]]
        for attribute in REFERRING:
            if tag.get(attribute):
                tag[attribute] = " ".join(table.get(word, word) for word in tag[attribute].split())


def relink(part: Tag, page: str, names: Names, file_link: Callable[[Tag, str], None]) -> None:
    """Make a part's links lead to places in the file; file_link(link, path) is asked about other files of the site."""
    for link in part.find_all("a", href=True):
        if aim := target(page, link["href"]):
            if place := names.place(*aim):
                link["href"] = place
            else:
                file_link(link, aim[0])
