"""MathJax's MathML as browsers want it: the spaces that TeX's classes give, and no more elements than are needed."""

from collections.abc import Iterator
from itertools import chain, cycle, islice
from xml.etree.ElementTree import Element, SubElement, tostring

NAMESPACE = "{http://www.w3.org/1998/Math/MathML}"
CLASS = "data-mjx-texclass"
APPLIED, THIN = "\N{FUNCTION APPLICATION}", "0.167em"
NO_SPACE = {"lspace": "0", "rspace": "0"}
FORMS = {"OPEN": {"form": "prefix"}, "CLOSE": {"form": "postfix"}}
SIGNS = ("−", "+", "±", "∓")
PRIMES = ("′", "″", "‴")
ROWS = ("math", "mrow", "mtd", "mstyle", "msqrt")


def compact(formula: Element, tex: str) -> str:
    """A formula in as few bytes as it needs, its TeX in an annotation."""
    simplify(formula)
    for element in formula.iter():
        for name in [name for name in element.attrib if name.startswith("data-")]:
            del element.attrib[name]
    parts, formula[:] = list(formula), []
    semantics = SubElement(formula, "semantics")
    (semantics if len(parts) == 1 else SubElement(semantics, "mrow")).extend(parts)
    SubElement(semantics, "annotation", encoding="application/x-tex").text = tex
    return tostring(formula, encoding="unicode")


def simplify(element: Element) -> None:
    """Say in browsers' words what an element and its insides have in MathJax's own."""
    element.tag, element.tail = element.tag.removeprefix(NAMESPACE), None
    element.text = None if len(element) else element.text
    for child in element:
        simplify(child)
    element[:] = map(unwrapped, element)
    if element.tag in ("msup", "msubsup") and element[-1].text in PRIMES:
        put_prime(element)
    if element.tag in ROWS:
        element[:] = spaced(list(element))
    elif element.tag == "mtable":
        align(element)
    elif element.tag == "mo" and element.text in ("|", "‖", "/"):
        element.attrib.update(FORMS.get(element.get(CLASS, ""), NO_SPACE))
    if element.get("mathvariant") == "sans-serif":  # the one that is no letter of its own
        element.set("style", "font-family:sans-serif")


def unwrapped(element: Element) -> Element:
    """The one child of a row, or of a style that a space does not need; braces take an operator's spaces away."""
    if len(element) != 1 or not (element.tag == "mrow" or (element.tag == "mstyle" and element[0].tag == "mspace")):
        return element
    if element[0].tag == "mo" and element.get(CLASS) == "ORD":
        element[0].attrib.update(NO_SPACE)
    return element[0]


def put_prime(element: Element) -> None:
    """Let a prime stand beside its letter: the font has it raised already. An index then stands below it."""
    base, *index, prime = element
    row = Element("mrow")
    row.append(base)
    (SubElement(row, "mpadded", width="0") if index else row).append(prime)
    element.tag, element[:] = ("msub", [row, *index]) if index else ("mrow", list(row))


def spaced(row: list[Element]) -> Iterator[Element]:
    """A row with thin spaces around its functions' names, as TeX has them, but for a bracket beside them."""
    for before, part, after in zip([None, *row], row, [*row[1:], None], strict=False):
        applied = after is not None and after.text == APPLIED
        if applied and before is not None and before.text != APPLIED and not is_operator(before):
            yield Element("mspace", width=THIN)
        if part.text in SIGNS and (before is None or is_operator(before)):
            part.set("form", "prefix")
        if part.tag == "mo" and (part.text or "").isalpha():  # max
            part.attrib.update(NO_SPACE | ({} if is_bracket(after) else {"rspace": THIN}))
        yield part
        if part.text == APPLIED and not is_bracket(after):
            yield Element("mspace", width=THIN)


def is_operator(element: Element) -> bool:
    """Whether an element is a space, a sign with a space of its own, or opens a bracket."""
    if element.tag == "mspace" or not "".join(element.itertext()).strip():
        return True
    return element.tag == "mo" and element.get(CLASS) != "CLOSE" and element.text not in (")", "]")


def is_bracket(element: Element | None) -> bool:
    """Whether an element opens a bracket, or is one."""
    first = element[0] if element is not None and element.tag == "mrow" and len(element) else element
    return first is None or (first.tag == "mo" and (first.get(CLASS) == "OPEN" or first.text in ("(", "[")))


def align(table: Element) -> None:
    """Say of each cell what MathML Core lets no table say: where its text stands, and how far from others."""
    sides, gaps = table.get("columnalign", "center").split(), table.get("columnspacing", "0.8em").split()
    gap = table.get("rowspacing", "0.5ex").split()[0]
    for row in table:
        count = len(row)
        right = [*islice(cycle(gaps), count - 1), "0"]
        for cell, side, space in zip(row, islice(chain(cycle(sides)), count), right, strict=False):
            cell.attrib.update({"class": side, "style": f"padding:calc({gap}/2) {space} calc({gap}/2) 0"})
    for name in ("columnalign", "columnspacing", "rowspacing"):
        table.attrib.pop(name, None)
