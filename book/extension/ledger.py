"""The ledger of claims on pages; a ledger that does not stand fails the build (see book/ledger/__init__.py).

:::{ledger-verdicts}           what the verdicts mean, with the numbers of claims, and of their points
:::
:::{ledger-findings}           the findings by name
:::
:::{ledger-entries}            every claim, by verdict: a line that opens
:::

{merit}`pitfall_crease`        a claim's figure of merit;   {claim}`pitfall_crease` a link to its entry
"""

import re
from functools import cache
from pathlib import Path
from typing import NamedTuple

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective, SphinxRole

from book.assembly import stamps
from book.assembly.contents import page_title, placed
from book.assembly.results import BENCHMARK_PREFIX
from book.extension.cards import link
from book.extension.elements import TEMPLATES, Nodes, directive, filled, on, role, section
from book.extension.figures import file_link
from book.extension.listings import listing_address
from book.extension.numbers import mark, typeset
from book.extension.theorems import CLAIMS_PAGE, Here
from book.ledger.check import refutes, standing, tests_in
from book.ledger.entries import FINDINGS, VERDICTS, WORDS, BadLedger, Ledger, LedgerClaim, relation
from proofs.engine.project import PROJECT
from renderer.intervals import Interval


class Look(NamedTuple):
    """Look of a verdict: its class in the style sheet, sign and word; the title of its claims; what it means."""

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
    Look("outside", "–", "outside", "Outside this chapter", "it is about what is not here, and was not checked."),
)
LOOKS = dict(zip(VERDICTS, _LOOKS, strict=True))


def ledger_of(app: Sphinx) -> Ledger:
    """Return the build's ledger, held against the last run when first asked for; raises BadLedger or NoReport."""
    if not hasattr(app, "chapter_ledger"):
        app.chapter_ledger, app.chapter_run = standing()
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

    def inline(self, text: str) -> Nodes:
        """Return a text of an entry, MyST, as nodes."""
        parsed, messages = self._directive.state.inline_text(text, self._directive.lineno)
        return [*parsed, *messages]

    def entry(self, claim: LedgerClaim) -> str:
        """Return the address of a claim's entry on the page of all."""
        return f"{self.page(CLAIMS_PAGE)}#claim-{claim.id}"

    def title(self, page: str) -> str:
        return page_title(PROJECT.pages, page)

    def value(self, name: str) -> Nodes:
        """Return a number as it is set in type."""
        value = self.run.number(name)
        large = not isinstance(value, Interval) and abs(value) >= 1000
        spec = (",.0f" if isinstance(value, float) else ",") if large else None
        return [*typeset(value, spec), *mark(Path(self.env.srcdir), name.partition(".")[0])]

    def place(self, name: str) -> nodes.Node:
        """Return a link to the figure that a number belongs to, to the benchmark's page, or to the numbers' file."""
        figure, _, key = name.partition(".")
        text = WORDS.get(name) or re.sub("_+", " ", key)
        if figure.startswith(BENCHMARK_PREFIX):
            return link(text, self.page(PROJECT.page["times"]))
        if page := figure_pages(Path(self.env.srcdir)).get(figure):
            return link(text, f"{self.page(page)}#fig-{figure}")
        return file_link(text, f"/_generated/{figure}.json", f"{figure}.json")

    def first_with(self) -> dict[str, LedgerClaim]:
        """Return {finding: the claim that has its anchor}: of its claims the one with the hardest verdict."""
        hardest = sorted(self.ledger.sorted_by_place(), key=lambda claim: VERDICTS.index(claim.verdict))
        return {code: next(claim for claim in hardest if code in claim.findings) for code in FINDINGS}


def in_signs(text: str) -> Nodes:
    """Return a relation as it is set in type: = 0, ≥ 2, 0.45 to 0.65."""
    asked = relation(text)
    first, *second = (
        typeset(int(n) if n.is_integer() and abs(n) < 1e6 else n, None if n.is_integer() else ".4g")
        for n in asked.numbers
    )
    if second:
        return [*first, nodes.Text(" to "), *second[0]]
    return [nodes.Text({"==": "", "!=": "not ", "<=": "≤ ", ">=": "≥ "}.get(asked.sign, f"{asked.sign} ")), *first]


@cache
def figure_pages(book: Path) -> dict[str, str]:
    """Return {figure's id: the page on which it is placed}."""
    return dict(placed(book, "chapter-figure|idea|worked-pixel"))


def test_address(node: str) -> str:
    """Return the address of a test, "file.py::name", on the page of its file."""
    file, _, name = node.partition("::")
    path = stamps.ROOT / file
    return f"{listing_address(path)}#L-{tests_in(path)[name.partition('[')[0]]}"


@directive("ledger-verdicts")
def verdicts(here: SphinxDirective) -> Nodes:
    return [filled("verdicts", claims=ledger_of(here.env.app).claims)]


@directive("ledger-findings")
def finding_index(here: SphinxDirective) -> Nodes:
    return [filled("finding_index")]


@directive("ledger-entries")
def ledger_entries(here: SphinxDirective) -> Nodes:
    book = Entries(here)
    claims, first, parts = book.ledger.sorted_by_place(), book.first_with(), []
    for verdict, look in LOOKS.items():
        group = [claim for claim in claims if claim.verdict == verdict]
        entries = filled("ledger_entries", book=book, claims=group, first=first)
        parts.append(section(f"{look.title}: {len(group)}", f"verdict-{look.slug}", entries))
    return parts


@role("merit")
def merit(here: SphinxRole) -> Nodes:
    claim = ledger_of(here.env.app).get(here.text)
    if not claim.merit:
        raise BadLedger([f"{claim.id}: merit: missing, and a page asks for it"])
    parsed, messages = here.inliner.parse(claim.merit, here.lineno, None, nodes.Element())
    return [nodes.inline("", "", *parsed, classes=["merit"]), *messages]


@role("claim")
def claim_link(here: SphinxRole) -> Nodes:
    claim = ledger_of(here.env.app).get(here.text)
    return [link(claim.verdict, f"{Here(here.env).page(CLAIMS_PAGE)}#claim-{claim.id}")]


TEMPLATES.globals.update(in_signs=in_signs, FINDINGS=FINDINGS, LOOKS=LOOKS, refutes=refutes, test_address=test_address)
