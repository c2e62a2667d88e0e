"""A source's listing made small: one <pre> without colours, its numbers in a column of their own."""

import re
from collections.abc import Collection

from bs4 import BeautifulSoup

from book.editions.pages import Page

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
        if "linenos" in span.get("class", []):
            span.decompose()
        else:
            span.unwrap()
    pre.smooth()
    count = pre.get_text().rstrip("\n").count("\n") + 1
    numbers = BeautifulSoup("", "html.parser").new_tag("div", attrs={"class": "numbers", "aria-hidden": "true"})
    numbers.string = "\n".join(str(n + 1) for n in range(count))
    pre.insert_before(numbers)
