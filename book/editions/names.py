"""Every id once: those that several pages use get their page's name, and whatever refers to them follows."""

import re
from collections import Counter
from collections.abc import Callable, Iterable

from bs4 import Tag

from book.editions.pages import BrokenSite, Page, target

REFERRING = ("for", "aria-labelledby", "aria-describedby", "aria-controls", "aria-owns", "headers", "list", "form")


def ids_of(part: Tag) -> list[str]:
    return [tag["id"] for tag in part.find_all(id=True)]


class Names:
    """What the ids of the pages are called in the one file."""

    def __init__(self, pages: Iterable[Page], reserved: Iterable[str]):
        """pages: every page of the file; reserved: ids of what stands around them, which keep their names."""
        self.pages = {page.name: page for page in pages}
        own = {name: ids_of(page.article) for name, page in self.pages.items()}
        count = Counter(id for ids in own.values() for id in set(ids)) + Counter(set(reserved))
        self.table = {n: {id: id if count[id] == 1 else f"{n}:{id}" for id in ids} for n, ids in own.items()}

    def top(self, name: str) -> str:
        """The id of a page: that of its first section, or its address where it has none."""
        section = self.pages[name].article.find("section", id=True)
        return self.table[name].get(section["id"], section["id"]) if section else name

    def fragment(self, page: str, address: str) -> str | None:
        """The `#id` for an address on a page; None if it leads to no page of the file."""
        aim = target(page, address)
        if aim is None or aim[0].removesuffix(".html") not in self.pages or not aim[0].endswith(".html"):
            return None
        name, id = aim[0].removesuffix(".html"), aim[1]
        if not id:
            return f"#{self.top(name)}"
        if id not in self.table[name]:
            raise BrokenSite(f"{page}.html links to {name}.html#{id}, which has no such id")
        return f"#{self.table[name][id]}"


def rename(page: Page, names: Names) -> None:
    """Give the page's elements their new ids, and change what refers to them by name."""
    table = names.table[page.name]
    for tag in page.article.find_all(True):
        if tag.get("id"):
            tag["id"] = table[tag["id"]]
        for attribute in REFERRING:
            if tag.get(attribute) and tag.name != "mo":  # where `form` is an operator's, and names nothing
                value = tag[attribute]
                words = value if isinstance(value, list) else value.split()
                tag[attribute] = " ".join(table.get(word, word) for word in words)
    escaped = {id: re.sub(r"([^\w-])", r"\\\1", new) for id, new in table.items() if id != new}
    for style in page.article.find_all("style"):
        style.string = re.sub(r"#([\w-]+)", lambda match: "#" + escaped.get(match[1], match[1]), style.string or "")


def relink(part: Tag, page: str, names: Names, file_link: Callable[[Tag, str], None]) -> None:
    """Make a part's links lead to places in the file; file_link(link, path) is asked about other files of the site."""
    for link in part.find_all("a", href=True):
        aim = target(page, link["href"])
        if aim is None:
            continue
        if (place := names.fragment(page, link["href"])) is not None:
            link["href"] = place
        else:
            file_link(link, aim[0])
