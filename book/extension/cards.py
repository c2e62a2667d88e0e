"""Theorems on pages, printed from their checked objects: cards, references, the list of all, what grades mean.

:::{theorem} kink_loci
:::

{theorem-ref}`kink_loci`      a link that reads "Theorem 3 (Kink loci)"; `kink_loci|short` gives "Theorem 3"

:::{all-theorems}     every theorem, by section
:::
:::{dependencies}     what each rests on, below all that it rests on
:::
:::{grades}           the legend of the badges, with the number of theorems that have each; `:asked:` adds who was asked
:::
:::{check-all}        a button that checks every certificate in the reader's browser
:::
"""

import re
from collections import Counter
from pathlib import Path
from textwrap import indent

from docutils import nodes
from docutils.parsers.rst import directives
from markupsafe import Markup, escape
from sphinx.addnodes import index
from sphinx.util.docutils import SphinxDirective, SphinxRole

from book.assembly import report
from book.assembly.contents import page_files, page_title
from book.extension.checker import check_all, check_here
from book.extension.elements import TEMPLATES, Filled, Nodes, directive, filled, role, section
from book.extension.evidence import count, evidence_line, killed
from book.extension.listings import DOWNLOADS, listing_address
from book.extension.printed_claims import point, rows
from book.extension.proof_pages import places
from book.extension.theorems import CLAIMS_PAGE, GRADES, LEGEND, Here, certificate, kind, module_and_line
from proofs.engine.project import HOME, PROJECT
from proofs.engine.theorem import Theorem
from proofs.printers.coq_statements import statements
from verify.coq.recorded import in_full
from verify.coq.survey import AXIOMS, BESIDE

OPEN = 3  # of the lines that a claim shows; the others are folded
BEFORE = ("let", "given", "state", "cited")  # what a claim starts from: folded, below what it shows
KEYWORDS = re.compile(r"\b(Theorem|forall|exists|fun|let|in|if|then|else)\b")


@directive("theorem", arguments=1)
def theorem_card(here: SphinxDirective) -> Nodes:
    book, id = Here(here.env), here.arguments[0]
    book.proofs.reached(id)
    shown, label = card(book, id), book.label(id)
    names = label, label.split()[-1]  # by which the search finds it
    return [index(entries=[("single", name, shown["ids"][0], "main", None) for name in names]), shown]


def card(book: Here, id: str) -> Filled:
    path, line = module_and_line(id)
    source = f"{listing_address(path)}#L-{line}"
    made = filled("card", id=id, book=book, check_here=check_here(book, id), source=source)
    made["ids"] = [f"theorem-{id}"]
    return made


def coq(name: str, statement: str) -> Markup:
    """Return a statement of Coq's, its keywords coloured."""
    words = str(escape(f"Theorem {name} :\n{indent(statement, '  ')}."))  # put into a Markup, a tag would be escaped
    return Markup(KEYWORDS.sub(r'<span class="k">\1</span>', words))


def proof_address(name: str) -> str:
    """Return the address of a theorem of Coq's among the pages of the proofs."""
    return f"{listing_address(places()[name])}#{name}"


def said_by_coq(theorem: Theorem, formally: dict) -> tuple[dict[str, str], int, int]:
    """Return ({name: what Coq proves of a theorem, claims and additions}, how many points, how many false variants)."""
    printed, more = statements(theorem), formally["statements"]
    points, false = (sum(name.endswith(end) for name in more) for end in ("__point", "__false"))
    claims = {name: printed[name] for name in formally["claims"]}
    return claims | {n: text for n, text in more.items() if not n.endswith(BESIDE)}, points, false


def axioms(names: list[str]) -> str:
    """Name the axioms that a formal proof takes from Coq's library without proof."""
    about = [AXIOMS[name] for name in names if name in AXIOMS]
    about += ["Coq's machine numbers"] if len(about) < len(names) else []
    return f"Coq's axioms of {', '.join(dict.fromkeys(about))}" if about else "no axiom"


def link(text: str, target: str) -> nodes.reference:
    return nodes.reference("", "", nodes.Text(text), refuri=target, internal=True)


@role("theorem-ref")
def theorem_reference(here: SphinxRole) -> Nodes:
    id, _, style = here.text.partition("|")
    book = Here(here.env)
    book.proofs.reached(id)
    return [link(book.label(id) if style == "short" else book.name(id), book.card(id))]


@directive("grades", asked=directives.flag)
def grades_legend(here: SphinxDirective) -> Nodes:
    counts = Counter(kind(entry["shown"]) for entry in Here(here.env).proofs.entries.values())
    asked = report.asked() if "asked" in here.options else {}
    return [filled("grades", id="" if asked else LEGEND[1], counts=counts, asked=asked)]


@directive("check-all")
def check_all_here(here: SphinxDirective) -> Nodes:
    return [check_all(Here(here.env).proofs)]


@directive("dependencies")
def dependencies(here: SphinxDirective) -> Nodes:
    return [filled("dependencies", book=Here(here.env))]


@directive("all-theorems")
def all_theorems(here: SphinxDirective) -> Nodes:
    book, source, parts = Here(here.env), Path(here.env.srcdir), []
    order, places = list(GRADES), book.proofs.places
    for page in (page for page in page_files(source) if page in places.values()):
        ids = [id for id in places if places[id] == page]
        ids.sort(key=lambda id: order.index(kind(book.proofs.entries[id]["shown"])))
        parts.append(section(page_title(source, page), f"theorems-{page}", filled("claim_list", book=book, ids=ids)))
    if unplaced := [id for id in places if places[id] == CLAIMS_PAGE]:
        parts.append(section("On no other page", "on-no-other-page", *(card(book, id) for id in unplaced)))
    return parts


CALLED = (axioms, certificate, coq, count, evidence_line, in_full, killed, kind, proof_address, said_by_coq)
TEMPLATES.globals.update(
    {function.__name__: function for function in CALLED},
    BEFORE=BEFORE,
    CHECK="pytest verify" if PROJECT.root == HOME else "pytest -p verify.conftest --noconftest --pyargs verify",
    DOWNLOADS=DOWNLOADS,
    GRADES=GRADES,
    OPEN=OPEN,
    PAGES=PROJECT.page,
    point=point,
    rows=rows,
)
