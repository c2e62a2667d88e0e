"""The ledger of claims on pages; a ledger that does not stand fails the build (see book/ledger/__init__.py).

:::{ledger-entries}            every claim, by verdict, with filters that need no script, and an index of F1 to F22
:::
:::{ledger-table} seed:s6      the claims that stand at these places (a place, or the beginning of one), as a table
:::
:::{ledger-claims} pitfall_seam pitfall_crease      these claims, each with its verdict and a link to its entry
:::

{merit}`pitfall_crease`        a claim's figure of merit;   {claim}`pitfall_crease` a link to its entry
"""

from collections import Counter
from pathlib import Path

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError

from book import ledger
from book.build import stamps
from book.build.contents import page_title
from book.extension.cards import Here, link
from book.extension.elements import TEMPLATES, BookDirective, BookRole, filled, section
from book.extension.ledger_evidence import number_nodes, test_address
from book.ledger.check import faults_in, refutes
from book.ledger.entries import FINDINGS, VERDICTS, BadLedger, Evidence, Ledger, LedgerClaim

PAGE = "findings"
SLUGS = dict(zip(VERDICTS, ("false", "corrected", "conditional", "holds", "outside"), strict=True))
SIGNS = {"false": "✕", "corrected": "↻", "conditional": "◐", "holds": "✓", "outside": "–"}
GROUPS = ("False", "Corrected", "True with a condition", "True", "Outside this chapter")


def ledger_of(app: Sphinx) -> Ledger:
    """The build's ledger, held against the last run when first asked for; raises BadLedger or NoReport."""
    if not hasattr(app, "chapter_ledger"):
        from book.ledger import run  # it imports this package's results

        found, app.chapter_run = ledger.load(), run.last_run()
        if wrong := faults_in(found, app.chapter_run):
            raise BadLedger(wrong)
        app.chapter_ledger = found
    return app.chapter_ledger


def require_ledger(app: Sphinx) -> None:
    """Stop a build of this book whose ledger does not stand."""
    if (Path(app.srcdir) / "ledger").is_dir():
        try:
            ledger_of(app)
        except ValueError as error:
            raise ExtensionError(str(error)) from error


class Entries(Here):
    """The claims as they are printed and found from the page that is being read."""

    def __init__(self, directive: BookDirective):
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
        """The title of a page."""
        return page_title(stamps.ROOT / "book", page)

    def number(self, piece: Evidence) -> list[nodes.Node]:
        """A number that is evidence."""
        return number_nodes(self, piece)


class LedgerEntries(BookDirective):
    """Every claim, grouped by verdict."""

    def content_nodes(self) -> list[nodes.Node]:
        book = Entries(self)
        claims = book.ledger.sorted_by_place()
        by_verdict = sorted(claims, key=lambda claim: VERDICTS.index(claim.verdict))
        first = {code: next(claim for claim in by_verdict if code in claim.findings) for code in FINDINGS}
        counts = Counter(claim.verdict for claim in claims)
        counts |= {"seed": sum(claim.of_seed for claim in claims), "code": sum(bool(c.findings) for c in claims)}
        filters = filled("ledger_filters", counts=counts, number=len(claims))
        parts = [filled("finding_index", book=book, first=first), filters]
        for (verdict, slug), title in zip(SLUGS.items(), GROUPS, strict=True):
            group = [claim for claim in claims if claim.verdict == verdict]
            entries = filled("ledger_entries", book=book, claims=group, first=first)
            parts.append(section(f"{title}: {len(group)}", f"verdict-{slug}", entries, classes=["ledger"]))
        return parts


class LedgerTable(BookDirective):
    """The claims at some places of the seed as a table."""

    required_arguments = 1

    def content_nodes(self) -> list[nodes.Node]:
        book = Entries(self)
        claims = [claim for claim in book.ledger.sorted_by_place() if claim.where.startswith(self.arguments[0])]
        if not claims:
            raise BadLedger([f"no claim stands at {self.arguments[0]!r}"])
        return [filled("ledger_table", book=book, claims=claims)]


class LedgerClaims(BookDirective):
    """Some claims, with their verdicts and a link to the rest."""

    required_arguments = 1
    final_argument_whitespace = True

    def content_nodes(self) -> list[nodes.Node]:
        book = Entries(self)
        claims = [book.ledger.get(id) for id in self.arguments[0].split()]
        return [filled("ledger_claims", book=book, claims=claims)]


class Merit(BookRole):
    """A claim's figure of merit."""

    def content_nodes(self) -> list[nodes.Node]:
        claim = ledger_of(self.env.app).get(self.text)
        if not claim.merit:
            raise BadLedger([f"{claim.id}: merit: missing, and a page asks for it"])
        found, messages = self.inliner.parse(claim.merit, self.lineno, None, nodes.Element())
        return [nodes.inline("", "", *found, classes=["merit"]), *messages]


class ClaimLink(BookRole):
    """A link to a claim's entry."""

    def content_nodes(self) -> list[nodes.Node]:
        claim = ledger_of(self.env.app).get(self.text)
        return [link(claim.verdict, f"{Here(self.env).page(PAGE)}#claim-{claim.id}")]


def setup(app: Sphinx) -> None:
    """Register directives, roles, and the check."""
    app.add_directive("ledger-entries", LedgerEntries)
    app.add_directive("ledger-table", LedgerTable)
    app.add_directive("ledger-claims", LedgerClaims)
    app.add_role("merit", Merit())
    app.add_role("claim", ClaimLink())
    app.connect("builder-inited", require_ledger)


TEMPLATES.globals.update(SLUGS=SLUGS, SIGNS=SIGNS, refutes=refutes, test_address=test_address)
