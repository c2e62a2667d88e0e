"""The book's pages: `_toc.yml` says in which folder each stands; its name, and its address, is the file's alone."""

import re
from pathlib import Path

from book.assembly.stamps import table_in


def page_files(book: Path) -> dict[str, Path]:
    """Return the pages' files by their names, in the contents' order; without contents, those beside each other."""
    contents = book / "_toc.yml"
    if not contents.is_file():
        return {path.stem: path for path in sorted(book.glob("*.md"))}
    table = table_in(contents)
    parts = table.get("parts", [table])
    places = [table["root"], *(chapter["file"] for part in parts for chapter in part.get("chapters", ()))]
    return {Path(place).name: book / f"{place}.md" for place in places}


def placed(book: Path, directives: str) -> list[tuple[str, str]]:
    """Return [(name, the page that places it)] in the order of the pages; directives: their names, | between them."""
    line = re.compile(rf"^\s*(?::{{3,}}|`{{3,}})\{{(?:{directives})\}}\s+(\S+)\s*$", re.MULTILINE)
    texts = {page: path.read_text(encoding="utf-8") for page, path in page_files(book).items()}
    return [(name, page) for page, text in texts.items() for name in line.findall(text)]


def page_title(book: Path, name: str) -> str:
    """Return the title of a page, mathematics as it is typed; the name itself where there is no such page."""
    path = page_files(book).get(name)
    lines = path.read_text(encoding="utf-8").splitlines() if path and path.is_file() else ()
    return next((line.removeprefix("# ") for line in lines if line.startswith("# ")), name)
