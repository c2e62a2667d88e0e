"""The directive that prints a theorem from its checked object, and the role that refers to one.

:::{theorem} kink_loci
:expect: proved               (by default what the theorem itself expects; anything else fails the build)
:::

{theorem-ref}`kink_loci`      a link that reads "Theorem 3 (Kink loci)"; `kink_loci|short` gives "Theorem 3"
"""

from typing import ClassVar

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.util.docutils import SphinxDirective, SphinxRole

from book.build import stamps
from book.build.report import NoReport
from book.extension import checker
from book.extension.elements import Html, typeset
from book.extension.evidence import badge, evidence_line, killed, measurement
from book.extension.listings import DOWNLOADS, listing_address
from book.extension.points import tex_point
from book.extension.theorems import BadTheorem, Proofs, certificate, kind, module_and_line, proofs_of, script

GRAPH_PAGE = "dependencies"
OUTCOMES = {"holds": "holds", "fails": "fails", "undefined": "has no value"}


class ProofsDirective(SphinxDirective):
    """A directive that prints from the proofs; what is wrong with them fails the build."""

    def run(self):
        try:
            return self.content_nodes(proofs_of(self.env.app))
        except (BadTheorem, NoReport) as error:
            raise self.error(f"{self.name}: {error}") from error

    def address(self, id: str, proofs: Proofs) -> str:
        """The address of a theorem's card, from this page."""
        return address(self.env, proofs, id)


def address(env, proofs: Proofs, id: str) -> str:
    """The address of a theorem's card, from the page that is being read."""
    return f"{page_address(env, proofs.places[id].page)}#theorem-{id}"


def page_address(env, page: str) -> str:
    """The address of a page, from the page that is being read."""
    return "" if page == env.docname else env.app.builder.get_relative_uri(env.docname, page)


def link(text: str, target: str, **attributes) -> nodes.reference:
    """A link inside the book."""
    return nodes.reference("", "", nodes.Text(text), refuri=target, internal=True, **attributes)


def links(env, proofs: Proofs, ids) -> list[nodes.Node]:
    """Links to theorems, with commas."""
    parts = []
    for id in sorted(ids, key=lambda id: proofs.places[id].number):
        parts += [nodes.Text(", ")] if parts else []
        parts.append(link(f"{proofs.label(id)} ({proofs.theorems[id].title})", address(env, proofs, id)))
    return parts


class TheoremCard(ProofsDirective):
    """Place the card of a theorem."""

    required_arguments = 1
    option_spec: ClassVar = {"expect": directives.unchanged}

    def content_nodes(self, proofs: Proofs):
        id = self.arguments[0]
        proofs.get(id)
        proofs.reached(id, self.options.get("expect"))
        if proofs.places[id].page != self.env.docname:
            raise BadTheorem(f"{id!r} is placed on {proofs.places[id].page}, not here")
        return [card(self.env, proofs, id)]


def card(env, proofs: Proofs, id: str) -> Html:
    """The card: title, statement, hypotheses, evidence; folded away, what the evidence is made of."""
    theorem, entry = proofs.theorems[id], proofs.entries[id]
    title = Html(
        "p",
        badge(entry["grade"], entry.get("grade_line", "")),
        Html("strong", nodes.Text(proofs.label(id))),
        nodes.Text(" "),
        Html("span", nodes.Text(theorem.title), classes=["theorem-name"], id=f"title-{id}"),
        classes=["theorem-title"],
    )
    parts = [title, Html("p", *statement(theorem), classes=["statement"])]
    if theorem.hypotheses:
        given = [node for h in theorem.hypotheses for node in (nodes.Text("; "), *typeset(h))][1:]
        parts.append(Html("p", Html("em", nodes.Text("Given: ")), *given, nodes.Text("."), classes=["given"]))
    parts.append(Html("p", nodes.Text(f"{evidence_line(entry)}."), classes=["evidence-line"]))
    parts.append(Html("details", Html("summary", nodes.Text(summary(theorem, entry))), *unfolded(env, proofs, id)))
    parts += checker.check_here(env, proofs, id)
    parts.append(provenance(env, id))
    name = kind(entry["grade"])
    return Html("section", *parts, classes=["theorem", name], id=f"theorem-{id}", aria_labelledby=f"title-{id}")


def statement(theorem) -> list[nodes.Node]:
    """The theorem in words; what no claim says is grey, with the reason."""
    parts = []
    for clause in theorem.clauses:
        parts += [nodes.Text(" ")] if parts else []
        why = [nodes.Text(" (argued: "), *typeset(clause.argued), nodes.Text(")")]
        grey = clause in theorem.argued
        parts += [Html("span", *typeset(clause.text), *why, classes=["argued"])] if grey else typeset(clause.text)
    return parts


def summary(theorem, entry: dict) -> str:
    """What unfolds."""
    refuted = kind(entry["grade"]) == "refuted"
    steps = "The counterexample" if refuted else "Steps" if theorem.steps else "Evidence"
    more = ["side conditions"] if theorem.side_conditions else []
    more += ["true variants" if refuted else "false variants"] if entry.get("mutants") else []
    return ", ".join([steps, *more, "what it rests on"])


def unfolded(env, proofs: Proofs, id: str) -> list[nodes.Node]:
    """Steps, side conditions with their edges, variants, and the theorems around it."""
    theorem, entry = proofs.theorems[id], proofs.entries[id]
    parts = []
    if theorem.refuted_at:
        at = {str(symbol): str(value) for symbol, value in theorem.refuted_at}
        parts.append(Html("p", nodes.Text("Fails at "), *point_nodes(at), nodes.Text(".")))
    if theorem.steps:
        steps = [
            Html("li", *typeset(s.what), Html("span", nodes.Text(" — "), *typeset(s.why), classes=["why"]))
            for s in theorem.steps
        ]
        parts += [heading("Steps"), Html("ol", *steps)]
    if lemmas := entry.get("cited_lemmas"):
        items = [Html("li", nodes.literal("", x["relation"]), nodes.Text(f", from {x['source']}")) for x in lemmas]
        parts += [heading("Taken from the literature"), Html("ul", *items)]
    if seen := entry.get("measurements"):
        parts += [heading("Measured"), Html("ul", *(Html("li", *measurement(m)) for m in seen))]
    if entry.get("side_conditions"):
        items = [
            Html("li", *typeset(c["condition"]), Html("ul", *map(edge, c["edges"]))) for c in entry["side_conditions"]
        ]
        parts += [heading("Side conditions, tested at their edge"), Html("ul", *items)]
    if entry.get("mutants"):
        refuted = kind(entry["grade"]) == "refuted"
        what = "True variants, proved by the same path" if refuted else "False variants, refused by the same path"
        parts += [heading(what), Html("ul", *map(variant, entry["mutants"]))]
    around = [("Rests on ", theorem.uses), ("Used by ", proofs.users(id))]
    sentences = [
        node for word, ids in around if ids for node in (nodes.Text(word), *links(env, proofs, ids), nodes.Text(". "))
    ]
    neighbours = link("Show it in the graph", f"{page_address(env, GRAPH_PAGE)}#node-{id}")
    return [*parts, Html("p", *sentences, neighbours, nodes.Text("."), classes=["around"])]


def heading(text: str) -> Html:
    """The title of a folded part; no heading of the page."""
    return Html("p", nodes.Text(text), classes=["part"])


def point_nodes(at: dict[str, str]) -> list[nodes.Node]:
    """A point as mathematics, one equation after the other."""
    if "path" in at:
        return [nodes.literal("", at["path"])]
    equations = tex_point(at)
    tex = [f"{equation}," for equation in equations[:-1]] + equations[-1:]
    return [node for part in tex for node in (nodes.math(part, part), nodes.Text(" "))][:-1]


def edge(tested: dict) -> Html:
    """One edge test."""
    return Html("li", nodes.Text("at "), *point_nodes(tested["at"]), nodes.Text(f" it {OUTCOMES[tested['outcome']]}"))


def variant(mutant: dict) -> Html:
    """One variant, and what became of it."""
    text = mutant.get("mutant", mutant.get("variant"))
    if not killed(mutant):
        return Html("li", *typeset(text), nodes.Text(": not settled"))
    if "variant" in mutant:
        return Html("li", *typeset(text), nodes.Text(": proved, and the counterexample spares it"))
    point = mutant["counterexample"]
    how = "by the path " if "path" in point["at"] else "fails at " if point["exact"] else "fails near "
    return Html("li", *typeset(text), Html("span", nodes.Text(f" — {how}"), *point_nodes(point["at"]), classes=["why"]))


def provenance(env, id: str) -> Html:
    """The small line at the foot: source · certificate · script · the command."""
    path, line = module_and_line(id)
    source = f"{listing_address(path.relative_to(stamps.ROOT))}#L-{line}"
    parts = [link("source", source)]
    if certificate(id):
        parts.append(download("certificate", f"{DOWNLOADS}/{id}.json"))
    if script(id):
        parts.append(download("stand-alone script", f"{DOWNLOADS}/{id}.py"))
    line = [node for part in parts for node in (part, nodes.Text(" · "))]
    command = nodes.literal("", f"pytest verify --theorem {id}")
    return Html("p", *line, nodes.Text("check: "), command, classes=["provenance"])


def download(text: str, target: str) -> Html:
    """A link to a file of the site that a browser keeps."""
    return Html("a", nodes.Text(text), href=target, download=None)


class TheoremReference(SphinxRole):
    """A link to a theorem's card."""

    def run(self):
        id, _, style = self.text.partition("|")
        try:
            proofs = proofs_of(self.env.app)
            title = proofs.get(id).title
            proofs.reached(id)
        except (BadTheorem, NoReport) as error:
            message = self.inliner.reporter.error(f"theorem-ref: {error}", line=self.lineno)
            return [nodes.problematic(self.rawtext, self.rawtext)], [message]
        text = proofs.label(id) if style == "short" else f"{proofs.label(id)} ({title})"
        return [link(text, address(self.env, proofs, id))], []


def setup(app) -> None:
    """Register the directive and the role."""
    app.add_directive("theorem", TheoremCard)
    app.add_role("theorem-ref", TheoremReference())
