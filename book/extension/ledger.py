"""The ledger of claims on pages; a ledger that does not stand fails the build (see book/ledger/__init__.py).

:::{ledger-verdicts}           what the verdicts mean, with the number of claims that have each
:::
:::{ledger-findings}           the findings by name
:::
:::{ledger-entries}            every claim, by verdict: a line that opens
:::

{merit}`pitfall_crease`        a claim's figure of merit;   {claim}`pitfall_crease` a link to its entry
"""

from collections import Counter
from pathlib import Path
from typing import NamedTuple

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective, SphinxRole

from book import ledger
from book.assembly import stamps
from book.assembly.contents import page_title
from book.extension.cards import link
from book.extension.elements import TEMPLATES, directive, filled, on, role, section
from book.extension.ledger_evidence import number_nodes, test_address
from book.extension.theorems import Here
from book.ledger.check import faults_in, last_run, refutes
from book.ledger.entries import FINDINGS, VERDICTS, BadLedger, Evidence, Ledger, LedgerClaim

PAGE = "findings"


class Look(NamedTuple):
    """How a verdict is shown: its class in the style sheet, sign and word; the title of its claims; what it means."""

    slug: str
    sign: str
    word: str
    title: str
    meaning: str


_LOOKS = (
    Look("false", "✕", "false", "False", "it is not so."),
    Look("corrected", "↻", "corrected", "Corrected", "part of it is so, and the entry says which."),
    Look("conditional", "◐", "true if", "True with a condition", "it is so under a condition, which the entry names."),
    Look("holds", "✓", "true", "True", "it is so."),
    Look("outside", "–", "outside", "Outside this chapter", "it is about other chapters, and was not checked."),
)
LOOKS = dict(zip(VERDICTS, _LOOKS, strict=True))


def ledger_of(app: Sphinx) -> Ledger:
    """The build's ledger, held against the last run when first asked for; raises BadLedger or NoReport."""
    if not hasattr(app, "chapter_ledger"):
        found, app.chapter_run = ledger.load(), last_run()
        if wrong := faults_in(found, app.chapter_run):
            raise BadLedger(wrong)
        app.chapter_ledger = found
    return app.chapter_ledger


@on("builder-inited")
def require_ledger(app: Sphinx) -> None:
    """Stop a build of this book whose ledger does not stand."""
    if (Path(app.srcdir) / "ledger").is_dir():
        try:
            ledger_of(app)
        except ValueError as error:
            raise ExtensionError(str(error)) from error


class Entries(Here):
    """The claims as they are printed and found from the page that is being read."""

    def __init__(self, directive: SphinxDirective):
        super().__init__(directive.env)
        self.ledger = ledger_of(self.env.app)
        self.run, self._directive = self.env.app.chapter_run, directive

    def inline(self, text: str) -> list[nodes.Node]:
        """A text of an entry, MyST, as nodes."""
        found, messages = self._directive.state.inline_text(text, self._directive.lineno)
        return [*found, *messages]

    def entry(self, claim: LedgerClaim) -> str:
        """The address of a claim's entry on the page of all."""
        return f"{self.page(PAGE)}#claim-{claim.id}"

    def title(self, page: str) -> str:
        return page_title(stamps.ROOT / "book", page)

    def number(self, piece: Evidence) -> list[nodes.Node]:
        return number_nodes(self, piece)

    def first_with(self) -> dict[str, LedgerClaim]:
        """Finding → the claim that has its anchor: the one whose verdict is the hardest."""
        hardest = sorted(self.ledger.sorted_by_place(), key=lambda claim: VERDICTS.index(claim.verdict))
        return {code: next(claim for claim in hardest if code in claim.findings) for code in FINDINGS}


@directive("ledger-verdicts")
def verdicts(here: SphinxDirective) -> list[nodes.Node]:
    counts = Counter(claim.verdict for claim in ledger_of(here.env.app).claims)
    return [filled("verdicts", counts=counts)]


@directive("ledger-findings")
def finding_index(here: SphinxDirective) -> list[nodes.Node]:
    return [filled("finding_index")]


@directive("ledger-entries")
def ledger_entries(here: SphinxDirective) -> list[nodes.Node]:
    book = Entries(here)
    claims, first, parts = book.ledger.sorted_by_place(), book.first_with(), []
    for verdict, look in LOOKS.items():
        group = [claim for claim in claims if claim.verdict == verdict]
        entries = filled("ledger_entries", book=book, claims=group, first=first)
        parts.append(section(f"{look.title}: {len(group)}", f"verdict-{look.slug}", entries))
    return parts


@role("merit")
def merit(here: SphinxRole) -> list[nodes.Node]:
    claim = ledger_of(here.env.app).get(here.text)
    if not claim.merit:
        raise BadLedger([f"{claim.id}: merit: missing, and a page asks for it"])
    found, messages = here.inliner.parse(claim.merit, here.lineno, None, nodes.Element())
    return [nodes.inline("", "", *found, classes=["merit"]), *messages]


@role("claim")
def claim_link(here: SphinxRole) -> list[nodes.Node]:
    claim = ledger_of(here.env.app).get(here.text)
    return [link(claim.verdict, f"{Here(here.env).page(PAGE)}#claim-{claim.id}")]


TEMPLATES.globals.update(FINDINGS=FINDINGS, LOOKS=LOOKS, refutes=refutes, test_address=test_address)
