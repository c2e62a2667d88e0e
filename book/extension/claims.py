"""The theorems on the page of findings: by section, and what their grades mean.

:::{all-theorems}
:::
:::{grades}           the legend of the badges, with the number of theorems that have each; `:asked:` adds who was asked
:::
:::{argued-clauses}   the words that no claim says, each with its reason
:::
:::{check-all}        a button that checks every certificate in the reader's browser
:::
"""

from collections import Counter
from pathlib import Path

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.util.docutils import SphinxDirective

from book.assembly import report
from book.assembly.contents import page_files, page_title
from book.extension.cards import card
from book.extension.checker import check_all
from book.extension.elements import directive, filled, section
from book.extension.theorems import CLAIMS_PAGE, GRADES, LEGEND, Here, kind

ORDER = list(GRADES)


@directive("grades", asked=directives.flag)
def grades_legend(here: SphinxDirective) -> list[nodes.Node]:
    counts = Counter(kind(entry["shown"]) for entry in Here(here.env).proofs.entries.values())
    asked = report.asked() if "asked" in here.options else {}
    grades = [grade for grade in ORDER if counts[grade]]
    return [filled("grades", id="" if asked else LEGEND[1], counts=counts, grades=grades, asked=asked)]


@directive("check-all")
def check_all_here(here: SphinxDirective) -> list[nodes.Node]:
    return [check_all(Here(here.env).proofs)]


@directive("argued-clauses")
def argued_clauses(here: SphinxDirective) -> list[nodes.Node]:
    book = Here(here.env)
    found = [(id, clause) for id in book.proofs.places for clause in book.proofs.theorems[id].argued]
    return [filled("argued_clauses", book=book, found=found)]


@directive("all-theorems")
def all_theorems(here: SphinxDirective) -> list[nodes.Node]:
    book = Here(here.env)
    grades = {id: kind(entry["shown"]) for id, entry in book.proofs.entries.items()}
    sections = book.proofs.places
    pages = page_files(Path(here.env.srcdir))
    parts = []
    for page in [page for page in pages if page in sections.values()]:
        ids = sorted((id for id in sections if sections[id] == page), key=lambda id: ORDER.index(grades[id]))
        lines = filled("claim_list", book=book, ids=ids)
        parts.append(section(page_title(Path(here.env.srcdir), page), f"theorems-{page}", lines))
    if unplaced := [id for id in sections if sections[id] == CLAIMS_PAGE]:
        parts.append(section("On no other page", "on-no-other-page", *(card(book, id) for id in unplaced)))
    return parts
