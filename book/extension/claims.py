"""The page of all claims: counted, by section and grade, with a filter that needs no script.

:::{all-claims}
:::
:::{grades}           the legend of the badges
:::
:::{check-all}        a button that checks every certificate in the reader's browser
:::
"""

from collections import Counter
from pathlib import Path

from docutils import nodes

from book.build.contents import page_files, page_title
from book.extension.cards import ProofsDirective, card, link
from book.extension.checker import check_all
from book.extension.elements import Html
from book.extension.evidence import badge, count, evidence_line, legend
from book.extension.ledger_filters import choices
from book.extension.theorems import CLAIMS_PAGE, MEANINGS, SHAPES, kind

ORDER = list(MEANINGS)


class Grades(ProofsDirective):
    """The legend: of the grades that occur."""

    def content_nodes(self, proofs):
        occurring = {kind(entry["grade"]) for entry in proofs.entries.values()}
        return [legend([g for g in ORDER if g in occurring or g not in ("failed",)])]


class CheckAll(ProofsDirective):
    """The button that checks every certificate in the reader's browser."""

    def content_nodes(self, proofs):
        return [check_all(proofs)]


class AllClaims(ProofsDirective):
    """Every theorem: a line each; and the cards of those that stand on no other page."""

    def content_nodes(self, proofs):
        grades = {id: kind(entry["grade"]) for id, entry in proofs.entries.items()}
        parts = [filters(Counter(grades.values()))]
        sections = {id: section_of(proofs, id) for id in proofs.in_page_order()}
        pages = page_files(Path(self.env.srcdir))
        in_order = [page for page in pages if page in sections.values()]
        for section in [*in_order, *sorted({*sections.values()} - {*pages})]:
            ids = [id for id in sections if sections[id] == section]
            ids.sort(key=lambda id: ORDER.index(grades[id]))
            title = page_title(Path(self.env.srcdir), section)
            place = nodes.section("", nodes.title("", title), ids=[f"claims-{section}"], names=[], classes=["claims"])
            place += Html("ul", *(self.line(proofs, id) for id in ids), classes=["claim-list"])
            parts.append(place)
        if unplaced := [id for id in proofs.in_page_order() if proofs.places[id].page == CLAIMS_PAGE]:
            place = nodes.section("", nodes.title("", "On no other page"), ids=["on-no-other-page"], names=[])
            place += [card(self.env, proofs, id) for id in unplaced]
            parts.append(place)
        return parts

    def line(self, proofs, id):
        """One theorem: badge, name with a link to its card, evidence."""
        entry = proofs.entries[id]
        name = link(f"{proofs.label(id)}", self.address(id, proofs))
        title = nodes.Text(f" {proofs.theorems[id].title}")
        evidence = Html("span", nodes.Text(evidence_line(entry)), classes=["evidence-line"])
        return Html("li", badge(entry["grade"]), name, title, evidence, classes=[kind(entry["grade"])], data_claim=id)


def filters(counts: Counter) -> Html:
    """Radio buttons, one for each grade that occurs: the style sheet does the rest."""
    options = [("all", f"all {counts.total()}")]
    options += [(grade, f"{SHAPES[grade]} {counts[grade]} {grade}") for grade in ORDER if counts[grade]]
    return choices("grade", f"Show, of {count(counts.total(), 'claim')}:", options)


def section_of(proofs, id: str) -> str:
    """The page that has the card; of those that have none, the section that the theorem names."""
    page = proofs.places[id].page
    return proofs.theorems[id].section if page == CLAIMS_PAGE else page


def setup(app) -> None:
    """Register the directives."""
    app.add_directive("all-claims", AllClaims)
    app.add_directive("check-all", CheckAll)
    app.add_directive("grades", Grades)
