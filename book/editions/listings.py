"""A source's listing made small: one <pre> without colours, its numbers in a column of their own."""

import re
from collections.abc import Collection

from bs4 import Tag

from book.editions.pages import Page, parsed

LINE = re.compile(r"L-\d+$")  # of a renamed id, its end


def make_small(page: Page, links: Collection[str]) -> None:
    """Replace the listing's markup. Lines that one of the file's `#id` links leads to keep their ids."""
    pre = page.article.find("pre")
    kept = [""]  # runs of text, and the places between them
    for part in list(pre.descendants):
        if isinstance(part, Tag):
            if part.name == "a" and LINE.search(part.get("id", "")) and f"#{part['id']}" in links:
                part.attrs = {"id": part["id"], "class": "line"}
                kept += [part, ""]
        elif "linenos" not in part.parent.get("class", ()):
            kept[-1] += part
    pre.clear()
    pre.extend(part for part in kept if part)
    count = pre.get_text().rstrip("\n").count("\n") + 1
    numbers = "\n".join(str(n + 1) for n in range(count))
    pre.insert_before(parsed(f'<div class="numbers" aria-hidden="true">{numbers}</div>').div)
