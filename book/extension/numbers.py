"""The role that prints a number which was computed, and the directive that says where one was measured.

{number}`eps_sweep.rms_1e-3`         four significant digits for a float, as it stands for an int or a string
{number}`eps_sweep.rms_1e-3|.2e`     any format of Python's; 6.1e-05 is set as 6.1 × 10⁻⁵
{number}`eps_sweep.rms_1e-3 .2e`     the same with a blank, for use inside tables
                                     of a number that is enclosed, what is certain; a format that asks for more is an
                                     error
{number}`bench:frame.time_ms|.1f`    from verify/benchmark/results/frame.json
{spread}`bench:frame.time_ms|.1f`    its quartiles, " (1.2 to 1.4)", or nothing where the run kept none

A number that was measured before the code changed has a mark, †, and the page says at its end at which commit it was.

```{benchmark-label} frame
The words before the label, if any.
```

A label stands behind what it is about: in its section, a number of a record has to be of one that the next labels name,
or the last ones. So no time stands under another run's date.
"""

from itertools import chain, groupby, pairwise
from pathlib import Path

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective, SphinxRole

from book.assembly.results import E_NOTATION, formatted, load_result, look_up, measured, parse, records_of, remark
from book.extension.elements import TEMPLATES, Nodes, directive, on, role
from renderer.intervals import Interval

MINUS = "\N{MINUS SIGN}"
TIMES = "\N{NO-BREAK SPACE}×\N{NO-BREAK SPACE}"


def typeset(value: int | float | str | Interval, spec: str | None = None) -> Nodes:
    """Return the value as it is set in type: a true minus, and powers of ten in place of e-notation."""
    text = formatted(value, spec)
    if isinstance(value, str):
        return [nodes.Text(text)]
    match = E_NOTATION.fullmatch(text)
    if match is None:
        return [nodes.Text(text.replace("-", MINUS))]
    mantissa, exponent = (part.replace("-", MINUS) for part in (match["mantissa"], str(int(match["exponent"]))))
    front = mantissa[:-1] + "10" if mantissa in ("1", f"{MINUS}1") else f"{mantissa}{TIMES}10"
    return [nodes.Text(front), nodes.superscript("", exponent)]


def mark(book: Path, id: str) -> Nodes:
    """Return the mark behind a number that was measured before the code changed; nothing behind others."""
    age = remark(book, id)
    return [nodes.abbreviation("", "†", explanation=age, classes=["stale"])] if age else []


@on("doctree-read")
def explain_marks(app: Sphinx, document: nodes.document) -> None:
    """Say at the end of a page what its marks mean: †, †† and so on, one for each commit that was measured."""
    marks: dict[str, str] = {}
    for node in document.findall(nodes.abbreviation):
        if "stale" in node["classes"]:
            age = node["explanation"]
            node[:] = [nodes.Text(marks.setdefault(age, "†" * (len(marks) + 1)))]
    for age, sign in marks.items():
        document.children[-1].append(nodes.paragraph("", f"{sign} {age[0].upper()}{age[1:]}.", classes=["stale"]))


@role("number")
def number(here: SphinxRole) -> Nodes:
    """Return one number of a result, on one line, or one of its words."""
    book, (id, key, spec) = Path(here.env.srcdir), parse(here.text)
    value = look_up(book, id, key)
    words = isinstance(value, str)
    marked = [] if words else mark(book, id)
    classes, sources = [] if words else ["number"], records_of(book, id)
    node = nodes.inline(here.rawtext, "", *typeset(value, spec), *marked, classes=classes, records=sources)
    here.set_source_info(node)
    return [node]


@role("spread")
def spread(here: SphinxRole) -> Nodes:
    """Return the quartiles of a measured number."""
    book, (id, key, spec) = Path(here.env.srcdir), parse(here.text)
    look_up(book, id, key)
    if f"{key}_low" not in load_result(book, id)["numbers"]:
        return []
    low, high = (typeset(look_up(book, id, f"{key}_{end}"), spec) for end in ("low", "high"))
    return [nodes.Text(" ("), *low, nodes.Text(" to "), *high, nodes.Text(")")]


@directive("benchmark-label", arguments=1, content=True)
def benchmark_label(here: SphinxDirective) -> Nodes:
    record = here.arguments[0]
    text = " ".join([*here.content, measured(Path(here.env.srcdir), record)])
    return [nodes.paragraph("", text, classes=["benchmark-label"], record=record)]


@on("doctree-read")
def hold_numbers_to_their_labels(app: Sphinx, document: nodes.document) -> None:
    """Refuse a number under the label of a record that it is not from."""
    for section in document.findall(nodes.section):
        blocks = [block for block in section if not isinstance(block, nodes.section)]
        runs = [[*run] for _, run in groupby(blocks, lambda block: "record" in block)]
        for run, labels in pairwise(runs + runs[-2:-1]):
            named = {label.get("record") for label in labels}
            for node in chain.from_iterable(block.findall(nodes.inline) for block in run):
                if not named.issuperset(node.get("records", ())):
                    words = f"{node.rawsource} is not of {', '.join(named)}, whose label it has"
                    document.reporter.error(words, base_node=node)


TEMPLATES.globals.update(number=typeset)
