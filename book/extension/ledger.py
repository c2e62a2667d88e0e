"""The ledger of claims on pages; a ledger that does not stand fails the build (see book/ledger/__init__.py).

:::{ledger-entries}            every claim, by verdict, with filters that need no script, and an index of F1 to F22
:::
:::{ledger-table} seed:s6      the claims that stand at these places (a place, or the beginning of one), as a table
:::
:::{ledger-claims} pitfall_seam pitfall_crease      these claims, each with its verdict and a link to its entry
:::

{merit}`pitfall_crease`        a claim's figure of merit;   {claim}`pitfall_crease` a link to its entry
"""

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from book.build import stamps
from book.build.contents import page_title
from book.build.report import NoReport
from book.extension.cards import link, page_address
from book.extension.elements import Html
from book.extension.ledger_checked import FINDINGS_PAGE, ClaimLink, Merit, ledger_of, require_ledger
from book.extension.ledger_evidence import TITLES, evidence_in_short, evidence_nodes, verdict_chip
from book.extension.ledger_filters import classes, filters
from book.extension.theorems import BadTheorem, proofs_of
from book.ledger.entries import FINDINGS, BadLedger, Claim

GROUPS = {
    "false": "False",
    "corrected": "Corrected",
    "conditional": "True with a condition",
    "holds": "True",
    "outside": "Outside this chapter",
}


class LedgerDirective(SphinxDirective):
    """A directive that prints from the ledger."""

    def run(self):
        try:
            self.ledger = ledger_of(self.env.app)
            self.run_found, self.proofs = self.env.app.chapter_run, proofs_of(self.env.app)
            return self.content_nodes()
        except (BadLedger, NoReport, BadTheorem) as error:
            raise self.error(f"{self.name}: {error}") from error

    def inline(self, text: str) -> list[nodes.Node]:
        """A text of an entry, MyST, as nodes."""
        found, messages = self.state.inline_text(text, self.lineno)
        return [*found, *messages]

    def place(self, claim: Claim) -> list[nodes.Node]:
        """Where a claim stands."""
        if claim.of_seed:
            return [nodes.Text(f"the seed, {self.ledger.places[claim.where.removeprefix('seed:')]}")]
        title = page_title(stamps.ROOT / "book", claim.where)
        return [nodes.Text("this book, "), link(title, page_address(self.env, claim.where))]

    def entry(self, claim: Claim, **attributes) -> Html:
        """A claim with everything that is known of it."""
        head = [verdict_chip(claim.verdict)]
        for code in claim.findings:
            mark = {"id": code} if code in self.anchors.get(claim.id, ()) else {}
            head.append(Html("span", nodes.Text(code), classes=["finding-code"], **mark))
        head.append(Html("span", *self.place(claim), classes=["claim-place"]))
        parts = [
            Html("p", *head, classes=["claim-head"]),
            Html("p", *self.inline(claim.words), classes=["claim-words"]),
        ]
        for name, label in (("condition", "Condition: "), ("so", ""), ("reason", "")):
            if text := getattr(claim, name):
                start = [Html("em", nodes.Text(label))] if label else []
                parts.append(Html("p", *start, *self.inline(text), classes=[f"claim-{name}"]))
        if claim.merit:
            parts.append(Html("p", *self.inline(claim.merit), classes=["claim-merit"]))
        parts += evidence_nodes(self.env, self.proofs, self.run_found, claim)
        return Html("li", *parts, classes=classes(claim), **attributes)

    def address(self, claim: Claim) -> str:
        """The address of a claim's entry on the page of all."""
        return f"{page_address(self.env, FINDINGS_PAGE)}#claim-{claim.id}"

    @property
    def anchors(self) -> dict[str, list[str]]:
        """Which codes have their anchor at which claim, on the page of all claims; none elsewhere."""
        return {}


class LedgerEntries(LedgerDirective):
    """Every claim, grouped by verdict."""

    def content_nodes(self):
        claims = self.ledger.sorted_by_place()
        parts = [self.index(), filters(claims)]
        for verdict, slug in TITLES.items():
            group = [claim for claim in claims if claim.verdict == verdict]
            title = nodes.title("", f"{GROUPS[slug]}: {len(group)}")
            place = nodes.section("", title, ids=[f"verdict-{slug}"], names=[], classes=["ledger"])
            place += Html("ul", *(self.entry(c, id=f"claim-{c.id}") for c in group), classes=["ledger-list"])
            parts.append(place)
        return parts

    @property
    def anchors(self):
        found: dict[str, list[str]] = {}
        for code in FINDINGS:
            found.setdefault(self.first(code).id, []).append(code)
        return found

    def first(self, code: str) -> Claim:
        """The claim at which a code's anchor stands: the first one of the seed."""
        claims = [claim for claim in self.ledger.sorted_by_place() if code in claim.findings]
        return min(claims, key=lambda claim: list(TITLES).index(claim.verdict))

    def index(self) -> Html:
        """The codes, each with the verdict's sign, in a row."""
        items = []
        for code in FINDINGS:
            claim = self.first(code)
            chip = verdict_chip(claim.verdict, short=True)
            where = self.ledger.places.get(claim.where.removeprefix("seed:"), claim.where)
            target = link(code, f"#{code}", reftitle=f"{where}: {claim.verdict}")
            items.append(Html("li", chip, target))
        return Html("ul", *items, classes=["finding-index"], aria_label="Findings by code")


class LedgerTable(LedgerDirective):
    """The claims at some places of the seed as a table."""

    required_arguments = 1

    def content_nodes(self):
        prefix = self.arguments[0]
        rows = [claim for claim in self.ledger.sorted_by_place() if claim.where.startswith(prefix)]
        if not rows:
            raise BadLedger([f"no claim stands at {prefix!r}"])
        head = Html(
            "tr", *(Html("th", nodes.Text(t), scope="col") for t in ("claimed", "verdict", "what is so", "shown"))
        )
        body = [self.row(claim) for claim in rows]
        table = Html("table", Html("thead", head), Html("tbody", *body), classes=["table", "ledger-table"])
        return [Html("div", table, classes=["pst-scrollable-table-container", "full-width"], tabindex="0")]

    def row(self, claim: Claim) -> Html:
        """One claim as a row."""
        said = self.inline(claim.merit) if claim.merit else self.inline(claim.so or claim.reason)
        shown = evidence_in_short(self.env, self.proofs, claim, self.address(claim))
        cells = [Html("td", *self.inline(claim.words)), Html("td", verdict_chip(claim.verdict, short=True))]
        return Html("tr", *cells, Html("td", *said), Html("td", *shown), classes=classes(claim))


class LedgerClaims(LedgerDirective):
    """Some claims, with their verdicts and a link to the rest."""

    required_arguments = 1
    final_argument_whitespace = True

    def content_nodes(self):
        entries = [self.brief(self.ledger.get(id)) for id in self.arguments[0].split()]
        return [Html("ul", *entries, classes=["ledger-list", "apart"])]

    def brief(self, claim: Claim) -> Html:
        """The words, the verdict, the place."""
        codes = [Html("span", nodes.Text(code), classes=["finding-code"]) for code in claim.findings]
        place = Html("span", *self.place(claim), classes=["claim-place"])
        head = Html(
            "p",
            verdict_chip(claim.verdict),
            *codes,
            place,
            link("the entry", self.address(claim)),
            classes=["claim-head"],
        )
        return Html("li", head, Html("p", *self.inline(claim.words), classes=["claim-words"]), classes=classes(claim))


def setup(app) -> None:
    """Register directives, roles, and the check."""
    for name, directive in {
        "ledger-entries": LedgerEntries,
        "ledger-table": LedgerTable,
        "ledger-claims": LedgerClaims,
    }.items():
        app.add_directive(name, directive)
    app.add_role("merit", Merit())
    app.add_role("claim", ClaimLink())
    app.connect("builder-inited", require_ledger)
