"""The page that this chapter came as, seed.txt, cut at the places of places.toml."""

import tomllib
from pathlib import Path

from book.ledger.entries import FOLDER, BadLedger

SEED = FOLDER / "seed.txt"


def parts(folder: Path = FOLDER) -> dict[str, str]:
    """Place → its text, in order, "" for what stands before the first; BadLedger where a beginning is not found."""
    text = (folder / SEED.name).read_text(encoding="utf-8")
    begins = tomllib.loads((folder / "places.toml").read_text(encoding="utf-8"))["begins"]
    texts, start, name = {}, 0, ""
    for place, phrase in begins.items():
        if (at := text.find(phrase, start + bool(name))) < 0:
            raise BadLedger([f"places.toml: begins: {place}: seed.txt has no {phrase!r} after {name or 'its front'}"])
        texts[name], start, name = text[start:at], at, place
    return texts | {name: text[start:]}
