"""Pictures inside the one-file edition: data: addresses; of a light and a dark drawing, the dark one's differences."""

from os.path import commonprefix  # of any text, letter by letter
from pathlib import Path

from book.editions.inlined import data_address, svg_address, svg_parts
from book.editions.pages import Page, target


def difference(light: list[str], dark: list[str]) -> list[str] | None:
    """Return the parts of the dark drawing that are not those of the light one; None if the drawings are not alike.

    Each is "number start end text": of the part with this number, `start` characters stay at its beginning and
    `end` at its end, with the text between them.
    """
    if len(light) != len(dark):
        return None
    pairs = enumerate(zip(light, dark, strict=True))
    return [f"{n} {change(old, new)}" for n, (old, new) in pairs if old != new]


def change(old: str, new: str) -> str:
    """Return the change from an old text to a new one as "start end text".

    start, end: how many characters of the old text stay at either end. text: what replaces those between them."""
    start = len(commonprefix([old, new]))  # noqa: RUF071
    end = len(commonprefix([old[start:][::-1], new[start:][::-1]]))  # noqa: RUF071
    return f"{start} {end} {new[start : len(new) - end]}"


def inline_pictures(site: Path, page: Page) -> None:
    """Put every picture of a page into the file. A dark one is made of its light neighbour when it is wanted."""
    light: list[str] = []
    for phone in page.article.select("source, img.panel"):  # of a picture's drawings the file has one
        phone.decompose()
    for plot in page.article.select("picture"):
        plot.unwrap()
    for image in page.article.find_all("img", src=True):
        path = site / target(page.name, image["src"])[0]
        image.attrs.pop("loading", None)  # it is there
        if path.suffix != ".svg":
            image["src"] = data_address(path)
            continue
        parts, classes = svg_parts(path), image.get("class", [])
        changes = difference(light, parts) if "only-dark" in classes else None
        if changes is None:
            image["src"] = svg_address(parts)
        else:
            del image["src"]
            image["data-dark"] = "<".join(changes)
        light = parts if "only-light" in classes else []
