"""Theorems as the book has them: the checked objects, their last run, and which page places which."""

import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment

from book.assembly import report
from book.assembly.contents import placed
from proofs.engine.project import PROJECT
from proofs.engine.theorem import Theorem, all_theorems
from verify.coq import formal

CLAIMS_PAGE = PROJECT.page.get("findings", "index")
LEMMAS_PAGE = PROJECT.page.get("lemmas")
LEGEND = (PROJECT.page.get("legend", "index"), "badges")  # the page and the id of what says what badges mean
WORDS = {"refuted": "Refuted", "measured": "Measured", "certified": "Certified"}  # before a statement
THEOREMS = PROJECT.folder(PROJECT.theorems)
GRADES = {  # shape, letter and meaning of each, in the order of the page of findings
    "formal": (
        "■",
        "F",
        "Coq, a proof assistant, accepted a statement for each of its words, here or on a day that the card names",
    ),
    "proved": ("●", "P", "a kernel, this book's checker, accepted a certificate; samples agree, false variants fail"),
    "certified": ("◆", "C", "enclosed between two ends, by numbers that carry their own error"),
    "measured": ("▲", "M", "sampled, with the worst case given"),
    "refuted": ("✕", "R", "false: the kernel accepted an exact counterexample"),
    "cited": ("○", "", "taken from the literature"),
    "failed": ("!", "?", "did not reach what its author expected"),
}


def kind(grade: str) -> str:
    """Return the grade without its conditions, as one word: "proved given cited" is a kind of proved."""
    return grade.split()[0]


def placements(book: Path, ids: Iterable[str]) -> dict[str, str]:
    """Return the page of every theorem, in page order; those that no page places follow on the page of findings."""
    page_of: dict[str, str] = {}
    for id, page in placed(book, "theorem"):
        if id in page_of:
            raise ValueError(f"{id!r} is placed twice, on {page_of[id]} and on {page}")
        page_of[id] = page
    return page_of | {id: CLAIMS_PAGE for id in ids if id not in page_of}


@dataclass(frozen=True)
class Proofs:
    """The theorems, their reports, and their pages in the order of their numbers; by id."""

    theorems: dict[str, Theorem]
    entries: dict[str, dict]
    places: dict[str, str]

    def reached(self, id: str) -> None:
        """Raise ValueError unless the theorem is known, and its last run gave the grade that it expects."""
        if id not in self.theorems:
            raise ValueError(f"unknown theorem {id!r}; there are: {', '.join(sorted(self.theorems))}")
        expected, grade = self.theorems[id].expected, self.entries[id]["grade"]
        if grade != expected:
            raise ValueError(f"{id!r} is expected to be {expected}; its last run made it {grade}")

    def label(self, id: str) -> str:
        """Return the name by which pages call it: "Theorem 3", "Lemma A.3", or "Claim 4" if it is not proved.

        The lemmas are counted by themselves, so that the numbers of the rest rise from page to page.
        """
        aside = self.places[id] == LEMMAS_PAGE
        counted = [other for other, page in self.places.items() if (page == LEMMAS_PAGE) == aside]
        word = "Lemma" if aside else "Theorem"
        if kind(self.entries[id]["shown"]) not in ("formal", "proved"):
            word = "Claim"
        return f"{word} {'A.' if aside else ''}{counted.index(id) + 1}"

    def users(self, id: str) -> list[str]:
        return [other for other, theorem in self.theorems.items() if id in theorem.uses]


def load(book: Path) -> Proofs:
    """Return everything about the theorems; raises NoReport or ValueError."""
    theorems, entries, accepted = all_theorems(), report.load(), formal.record()
    when = accepted and formal.when()
    for id, entry in entries.items():
        entry |= {"formal": accepted.get(id), "when": when}
        formally = formal.is_formal(theorems[id], entry["formal"]) and entry["grade"] == "proved"
        entry["shown"] = "formal" if formally else entry["grade"]
        entry["word"] = f"Coq, {when}" if formally else WORDS.get(kind(entry["shown"]), "")
    return Proofs(theorems, entries, placements(book, theorems))


def proofs_of(app: Sphinx) -> Proofs:
    """Return the build's Proofs, loaded when first asked for."""
    if not hasattr(app, "chapter_proofs"):
        app.chapter_proofs = load(Path(app.srcdir))
    return app.chapter_proofs


class Here:
    """The theorems as they are named and found from the page that is being read."""

    def __init__(self, env: BuildEnvironment):
        self.env, self.proofs = env, proofs_of(env.app)
        self.label, self.users = self.proofs.label, self.proofs.users

    def page(self, name: str) -> str:
        """Return the address of a page, all of which stand beside each other."""
        return "" if name == self.env.docname else f"{name}.html"

    def card(self, id: str) -> str:
        return f"{self.page(self.proofs.places[id])}#theorem-{id}"

    def legend(self) -> str:
        """Return the address of what the badges mean."""
        return f"{self.page(LEGEND[0])}#{LEGEND[1]}"

    def name(self, id: str) -> str:
        """Return the text of a link to a theorem."""
        return f"{self.label(id)} ({self.proofs.theorems[id].title})"


def module_and_line(id: str) -> tuple[Path, int]:
    """Return the file that declares a theorem, and the line before the one that names it."""
    for path in sorted(THEOREMS.glob("[!_]*.py")):
        text = path.read_text(encoding="utf-8")
        if match := re.search(rf"Theorem\(\s+(id=)?[\"']{id}[\"']", text):
            return path, text.count("\n", 0, match.start()) + 1
    raise ValueError(f"no file of {THEOREMS.name} writes out the id {id!r}")


def certificate(id: str) -> Path | None:
    path = PROJECT.certificates / f"{id}.json"
    return path if path.is_file() else None
