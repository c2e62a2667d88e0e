"""Certificates in the page, for the reader's own browser to check: their data, places for the buttons, the scripts."""

import json
from pathlib import Path

from docutils import nodes

from book.editions.inlined import base64_gzip
from book.extension.elements import Filled, Page, filled, on_page, raw
from book.extension.theorems import Here, Proofs, certificate, kind

SCRIPTS = ("kernel", "worker", "card", "start")
WITHOUT = {
    "measured": "No certificate to check here: this was measured, and the command below measures it again.",
    "certified": "No certificate to check here: this was enclosed in balls, and the command below encloses it again.",
}


def check_here(book: Here, id: str) -> Filled | str:
    """Return the place of a card's buttons, with the data; or why there is nothing to check."""
    path, grade = certificate(id), kind(book.proofs.entries[id]["grade"])
    if path is None:
        return filled("unchecked", why=WITHOUT[grade]) if grade in WITHOUT else ""
    claims = stored(path)
    steps = [step for claim in claims for pair in claim["statements"] for step in pair["statement"].get("steps", ())]
    shown = [step["of"] for step in steps if step["step"] == "show"]
    data = packed({"theorem": id, "claims": claims})
    return filled("checker", theorem=id, book=book, data=data, given=given(book, id), nothing_left=not all(shown))


def check_all(proofs: Proofs) -> Filled:
    """Return the place of the button that checks everything, with all certificates."""
    paths = [(id, certificate(id)) for id in proofs.places]
    return filled(
        "checker", theorem="", data=packed([{"theorem": id, "claims": stored(path)} for id, path in paths if path])
    )


def stored(path: Path) -> list[dict]:
    """Return the claims of a file of certificates, with what the kernel in the page reads of each."""
    claims = json.loads(path.read_text(encoding="utf-8"))["claims"]
    for claim in claims:
        claim["statements"] = [{key: case[key] for key in ("statement", "certificate")} for case in claim["statements"]]
    return claims


def packed(data: dict | list) -> nodes.raw:
    """Return an element that holds data as compressed JSON; in one piece, so that the search finds no words in it."""
    text = json.dumps(data, separators=(",", ":"), ensure_ascii=False)
    return raw(f'<script type="application/gzip">{base64_gzip(text.encode())}</script>')


def given(book: Here, id: str) -> list[str]:
    """Name in words what the theorem's statements cite."""
    claims = book.proofs.theorems[id].claims
    cited = dict.fromkeys(lemma.source for claim in claims for lemma in getattr(claim, "cited", ()))
    return [f"a lemma from {source}" for source in cited]


@on_page
def add_scripts(page: Page) -> None:
    """Load the checker's scripts and style where a page has a place for it."""
    if 'class="checker"' in page.context.get("body", ""):
        page.load(*(f"checker/{name}.js" for name in SCRIPTS), style="checker/checker.css")
