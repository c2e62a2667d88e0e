"""The build's ledger, checked once, and the roles that print from it."""

from pathlib import Path

from docutils import nodes
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxRole

from book import ledger
from book.build.report import NoReport
from book.extension.cards import link, page_address
from book.extension.theorems import BadTheorem
from book.ledger.check import check
from book.ledger.entries import BadLedger, Ledger

FINDINGS_PAGE = "findings"


def ledger_of(app) -> Ledger:
    """The build's ledger, held against the last run when first asked for; raises BadLedger or NoReport."""
    if not hasattr(app, "chapter_ledger"):
        from book.ledger import run  # it imports this package's results

        found, app.chapter_run = ledger.load(), run.last_run()
        if faults := check(found, app.chapter_run):
            raise BadLedger(faults)
        app.chapter_ledger = found
    return app.chapter_ledger


def require_ledger(app) -> None:
    """Stop a build of this book whose ledger does not stand."""
    if (Path(app.srcdir) / "ledger").is_dir():
        try:
            ledger_of(app)
        except (BadLedger, NoReport, BadTheorem) as error:
            raise ExtensionError(str(error)) from error


class Merit(SphinxRole):
    """A claim's figure of merit."""

    def run(self):
        try:
            claim = ledger_of(self.env.app).get(self.text)
            if not claim.merit:
                raise BadLedger([f"{claim.id}: merit: missing, and a page asks for it"])
        except (BadLedger, NoReport) as error:
            return refused(self, error)
        found, messages = self.inliner.parse(claim.merit, self.lineno, None, nodes.Element())
        return [nodes.inline("", "", *found, classes=["merit"])], messages


class ClaimLink(SphinxRole):
    """A link to a claim's entry."""

    def run(self):
        try:
            claim = ledger_of(self.env.app).get(self.text)
        except (BadLedger, NoReport) as error:
            return refused(self, error)
        target = f"{page_address(self.env, FINDINGS_PAGE)}#claim-{claim.id}"
        return [link(f"{claim.verdict}", target)], []


def refused(role: SphinxRole, error: Exception):
    """What a role returns that found nothing."""
    message = role.inliner.reporter.error(f"{role.name}: {error}", line=role.lineno)
    return [nodes.problematic(role.rawtext, role.rawtext)], [message]
