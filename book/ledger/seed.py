"""The page that this chapter came as, seed.txt, cut at the places of places.toml."""

from pathlib import Path

from book.assembly.stamps import table_in
from book.ledger.entries import FOLDER, BadLedger

SEED = FOLDER / "seed.txt"


def parts(folder: Path = FOLDER) -> dict[str, str]:
    """Place → its text, in order, "" for what stands before the first; BadLedger where a beginning is not found."""
    text = (folder / SEED.name).read_text(encoding="utf-8")
    begins = table_in(folder / "places.toml")["begins"]
    texts, start, name = {}, 0, ""
    for place, phrase in begins.items():
        if (at := text.find(phrase, start + bool(name))) < 0:
            raise BadLedger([f"places.toml: begins: {place}: seed.txt has no {phrase!r} after {name or 'its front'}"])
        texts[name], start, name = text[start:at], at, place
    return texts | {name: text[start:]}
