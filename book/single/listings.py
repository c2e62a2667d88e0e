"""A source's listing made small: one <pre>, its numbers in a column of their own, colours where they differ."""

import re
from collections.abc import Collection

from bs4 import BeautifulSoup, NavigableString, Tag

from book.single.pages import Page

PLAIN = {"n", "p", "w", "nn", "nx"}  # what Pygments' style prints in the colour of the text
LINE = re.compile(r"L-\d+")


def lines_wanted(links: Collection[str], name: str) -> set[str]:
    """The ids of the lines of a listing that something leads to. links: all `#ids` of the file."""
    return {link[len(name) + 2 :] for link in links if link.startswith(f"#{name}:L-")}


def make_small(page: Page, wanted: Collection[str]) -> None:
    """Replace the listing's markup. Lines in `wanted` keep their ids."""
    pre = page.article.find("pre")
    for anchor in pre.find_all("a", id=LINE):
        if anchor["id"].rpartition(":")[2] in wanted:
            anchor.attrs = {"id": anchor["id"], "class": "line"}
        else:
            anchor.decompose()
    for span in pre.find_all("span"):
        classes = set(span.get("class", []))
        if "linenos" in classes:
            span.decompose()
        elif not classes or classes <= PLAIN:
            span.unwrap()
    pre.smooth()
    merge_neighbours(pre)
    count = pre.get_text().rstrip("\n").count("\n") + 1
    numbers = BeautifulSoup("", "html.parser").new_tag("div", attrs={"class": "numbers", "aria-hidden": "true"})
    numbers.string = "\n".join(str(n + 1) for n in range(count))
    pre.insert_before(numbers)


def merge_neighbours(pre: Tag) -> None:
    """Join spans of one class that stand side by side, with nothing or blanks between them."""
    last = None
    for node in list(pre.children):
        if isinstance(node, Tag) and node.name == "span" and not node.find(True):
            gap = node.previous_sibling if last is not None else None
            blank = isinstance(gap, NavigableString) and not gap.strip() and gap.previous_sibling is last
            if last is not None and last["class"] == node["class"] and (gap is last or blank):
                last.string = last.get_text() + (str(gap) if blank else "") + node.get_text()
                if blank:
                    gap.extract()
                node.extract()
            else:
                last = node
        elif isinstance(node, Tag):
            last = None
