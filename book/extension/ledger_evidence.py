"""A claim's evidence as nodes: badges with links, what speaks against it first."""

import ast
import re
from collections import Counter
from functools import cache
from pathlib import Path, PurePosixPath

from docutils import nodes
from sphinx import addnodes

from book.build import stamps
from book.build.contents import page_files
from book.extension.cards import address, link, page_address, point_nodes
from book.extension.elements import Html
from book.extension.evidence import badge, count, evidence_line
from book.extension.listings import listing_address
from book.extension.numbers import typeset
from book.extension.results import BENCHMARK_PREFIX
from book.ledger.check import Run, refutes
from book.ledger.entries import VERDICTS, Claim, Evidence
from book.ledger.relations import relation

TITLES = dict(zip(VERDICTS, ("false", "corrected", "conditional", "holds", "outside"), strict=True))
SIGNS = {"false": "✕", "corrected": "↻", "conditional": "◐", "holds": "✓", "outside": "–"}
PLACED_FIGURE = re.compile(r"\{chapter-figure\}\s+(\w+)")


def verdict_chip(verdict: str, short: bool = False) -> Html:
    """The verdict as a sign and, unless it is short, in words; its words are there to be heard."""
    slug = TITLES[verdict]
    words = verdict.partition(":")[0]
    text = SIGNS[slug] if short else f"{SIGNS[slug]} {words}"
    return Html("span", nodes.Text(text), classes=["verdict", slug], role="img", aria_label=verdict, title=verdict)


def evidence_in_short(env, proofs, claim: Claim, target: str) -> list[nodes.Node]:
    """The theorems that a claim rests on; the rest counted, with a link to its entry."""
    theorems = [piece for piece in claim.evidence if piece.kind == "theorem"]
    others = Counter(piece.kind for piece in claim.evidence if piece.kind != "theorem")
    counted = ", ".join(count(number, kind) for kind, number in others.items())
    return [
        *(_theorem(env, proofs, None, piece, short=True) for piece in theorems),
        link(counted or "the entry", target),
    ]


def evidence_nodes(env, proofs, run: Run, claim: Claim) -> list[nodes.Node]:
    """What speaks against a claim, and what for what is so."""
    against = [piece for piece in claim.evidence if refutes(piece, run)]
    rest = [piece for piece in claim.evidence if piece not in against]
    found = []
    for label, pieces in (("Against it: ", against), ("Shown by " if not against else "What is so: ", rest)):
        if pieces:
            items = [part for piece in pieces for part in (nodes.Text("; "), shown(env, proofs, run, piece))][1:]
            found.append(Html("p", Html("em", nodes.Text(label)), *items, nodes.Text("."), classes=["claim-evidence"]))
    return found


def fails_at(theorem) -> list[nodes.Node]:
    """The first exact counterexample of a refuted theorem; what follows from its coordinates is left out."""
    at = {str(symbol): str(value) for symbol, value in theorem.refuted_at or () if symbol.is_Symbol}
    return [nodes.Text(", which fails at "), *point_nodes(at)] if at else []


def shown(env, proofs, run: Run, piece: Evidence) -> nodes.Node:
    """One piece of evidence: its badge, and a link to what it is."""
    kinds = {"theorem": _theorem, "number": _number, "test": _test, "source": _source}
    return kinds[piece.kind](env, proofs, run, piece)


def _theorem(env, proofs, run, piece, short=False):
    entry = proofs.entries[piece.name]
    theorem, label = proofs.theorems[piece.name], proofs.label(piece.name)
    mark, target = badge(entry["grade"], evidence_line(entry)), address(env, proofs, piece.name)
    if short:
        return Html("span", mark, link(label, target), classes=["piece"])
    return Html("span", mark, link(f"{label} ({theorem.title})", target), *fails_at(theorem), classes=["piece"])


def _number(env, proofs, run, piece):
    value = run.number(piece.name)
    asked = f"measured by this run; it has to be {piece.wants}"
    mark, target = badge("measured", asked), _place_of_number(env, piece.name)
    large = abs(value) >= 1000
    spec = (",.0f" if isinstance(value, float) else ",") if large else None
    told = [nodes.Text(", where the claim has "), *in_signs(piece.claimed)] if refutes(piece, run) else []
    return Html("span", mark, target, nodes.Text(" = "), *typeset(value, spec), *told, classes=["piece"])


def in_signs(text: str) -> list[nodes.Node]:
    """A relation as it is set in type: = 0, ≥ 2, 0.45 to 0.65."""
    asked = relation(text)
    numbers = [
        typeset(int(n) if n.is_integer() and abs(n) < 1e6 else n, None if n.is_integer() else ".4g")
        for n in asked.numbers
    ]
    if asked.sign == "in":
        return [*numbers[0], nodes.Text(" to "), *numbers[1]]
    return [nodes.Text({"==": "", "!=": "not ", "<=": "≤ ", ">=": "≥ "}.get(asked.sign, f"{asked.sign} ")), *numbers[0]]


def _place_of_number(env, name: str) -> nodes.Node:
    """A link to the figure that a number belongs to, to the benchmark's page, or to the file of the numbers."""
    figure, _, key = name.partition(".")
    text = re.sub("_+", " ", key)
    if figure.startswith(BENCHMARK_PREFIX):
        return link(text, page_address(env, "benchmark"))
    if page := figure_pages(Path(env.srcdir)).get(figure):
        return link(text, f"{page_address(env, page)}#fig-{figure}")
    target = f"/_generated/{figure}.json"
    file = addnodes.download_reference("", "", reftarget=target, refdoc="", refwarn=True, reftitle=f"{figure}.json")
    file += nodes.inline("", text)
    return file


@cache
def figure_pages(book: Path) -> dict[str, str]:
    """The page on which each figure is placed."""
    pages = {}
    for page, path in page_files(book).items():
        for figure in PLACED_FIGURE.findall(path.read_text(encoding="utf-8")):
            pages[figure] = page
    return pages


def _test(env, proofs, run, piece):
    file, _, name = piece.name.partition("::")
    mark = Html(
        "span", nodes.Text("T"), classes=["evidence", "tested"], role="img", aria_label="test", title=piece.name
    )
    text = name.removeprefix("test_").replace("_", " ")
    target = link(text, f"{listing_address(PurePosixPath(file))}#L-{line_of(file, name)}", reftitle=piece.name)
    return Html("span", mark, target, classes=["piece"])


def line_of(file: str, name: str) -> int:
    """The line on which a test begins."""
    tree = ast.parse((stamps.ROOT / file).read_text(encoding="utf-8"))
    wanted = name.partition("[")[0].rpartition("::")[2]
    return next(node.lineno for node in ast.walk(tree) if isinstance(node, ast.FunctionDef) and node.name == wanted)


def _source(env, proofs, run, piece):
    return Html("span", badge("cited"), link(piece.name, page_address(env, "references")), classes=["piece"])
