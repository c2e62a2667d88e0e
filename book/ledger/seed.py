"""The page that this chapter came as, seed.txt, cut at the places of places.toml."""

from book.assembly.stamps import table_in
from book.ledger.entries import FOLDER, BadLedger

SEED = FOLDER / "seed.txt"
RUN = "· · paste into colab.new → Run\n"  # before each program


def parts() -> dict[str, str]:
    """Place → its text, in order; BadLedger where a beginning is not found."""
    text, texts = SEED.read_text(encoding="utf-8"), {}
    for place, phrase in reversed(table_in(FOLDER / "places.toml")["begins"].items()):
        text, begin, end = text.rpartition(phrase)
        if not begin:
            raise BadLedger([f"places.toml: begins: {place}: seed.txt has no {phrase!r} before the next place"])
        texts[place] = begin + end
    return dict(reversed(texts.items()))
