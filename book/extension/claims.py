"""The theorems on the page of findings: by section, and what their grades mean.

:::{all-theorems}
:::
:::{grades}           the legend of the badges, with the number of theorems that have each
:::
:::{argued-clauses}   the words that no claim says, each with its reason
:::
:::{check-all}        a button that checks every certificate in the reader's browser
:::
"""

from collections import Counter
from pathlib import Path

from docutils import nodes
from sphinx.application import Sphinx

from book.build.contents import page_files, page_title
from book.extension.cards import Here, card
from book.extension.checker import check_all
from book.extension.elements import BookDirective, filled, section
from book.extension.theorems import CLAIMS_PAGE, GRADES, kind

ORDER = list(GRADES)


class Grades(BookDirective):
    """The legend: all grades, "failed" only where it occurs."""

    def content_nodes(self) -> list[nodes.Node]:
        counts = Counter(kind(entry["shown"]) for entry in Here(self.env).proofs.entries.values())
        return [filled("grades", counts=counts, grades=[grade for grade in ORDER if counts[grade]])]


class CheckAll(BookDirective):
    """The button that checks every certificate in the reader's browser."""

    def content_nodes(self) -> list[nodes.Node]:
        return [check_all(Here(self.env).proofs)]


class ArguedClauses(BookDirective):
    """Every clause of a theorem that no claim says, with its reason."""

    def content_nodes(self) -> list[nodes.Node]:
        book = Here(self.env)
        ids = [id for id in book.proofs.in_page_order() if kind(book.proofs.entries[id]["shown"]) != "formal"]
        found = [(id, clause) for id in ids for clause in book.proofs.theorems[id].argued]
        return [filled("argued_clauses", book=book, found=found)]


class AllTheorems(BookDirective):
    """Every theorem: a line each; and the cards of those that stand on no other page."""

    def content_nodes(self) -> list[nodes.Node]:
        book = Here(self.env)
        grades = {id: kind(entry["shown"]) for id, entry in book.proofs.entries.items()}
        sections = {id: book.proofs.places[id].page for id in book.proofs.in_page_order()}
        pages = page_files(Path(self.env.srcdir))
        parts = []
        for page in [page for page in pages if page in sections.values()]:
            ids = sorted((id for id in sections if sections[id] == page), key=lambda id: ORDER.index(grades[id]))
            lines = filled("claim_list", book=book, ids=ids)
            parts.append(section(page_title(Path(self.env.srcdir), page), f"theorems-{page}", lines))
        if unplaced := [id for id in sections if book.proofs.places[id].page == CLAIMS_PAGE]:
            parts.append(section("On no other page", "on-no-other-page", *(card(book, id) for id in unplaced)))
        return parts


def setup(app: Sphinx) -> None:
    """Register the directives."""
    app.add_directive("all-theorems", AllTheorems)
    app.add_directive("argued-clauses", ArguedClauses)
    app.add_directive("check-all", CheckAll)
    app.add_directive("grades", Grades)
