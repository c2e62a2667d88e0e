"""A source's listing made small: one <pre> without colours, its numbers in a column of their own."""

import re
from collections.abc import Collection

from book.editions.pages import Page, parsed

LINE = re.compile(r"L-\d+")


def make_small(page: Page, links: Collection[str]) -> None:
    """Replace the listing's markup. Lines that one of the file's `#id` links leads to keep their ids."""
    pre = page.article.find("pre")
    for anchor in pre.find_all("a", id=LINE):
        if f"#{anchor['id']}" in links:
            anchor.attrs = {"id": anchor["id"], "class": "line"}
        else:
            anchor.decompose()
    for number in pre.select("span.linenos"):
        number.decompose()
    for span in pre.find_all("span"):
        span.unwrap()
    pre.smooth()
    count = pre.get_text().rstrip("\n").count("\n") + 1
    numbers = "\n".join(str(n + 1) for n in range(count))
    pre.insert_before(parsed(f'<div class="numbers" aria-hidden="true">{numbers}</div>').div)
