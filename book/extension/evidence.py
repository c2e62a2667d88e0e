"""Evidence in words, made from a theorem's last run and never by its author."""

from docutils import nodes

from book.extension.elements import Html
from book.extension.numbers import typeset
from book.extension.theorems import LETTERS, MEANINGS, SHAPES, kind


def count(number: int, word: str) -> str:
    """1 certificate, 2 certificates."""
    return f"{number:,} {word}{'' if number == 1 else 's'}"


def killed(mutant: dict) -> bool:
    """Whether a false variant was refuted, or a refuted claim's true variant proved and spared."""
    if "variant" in mutant:
        return mutant["accepted"] and mutant["spared"]
    return mutant["refused"] and mutant["counterexample"] is not None


def findings(entry: dict) -> list[str]:
    """What the last run found, part by part."""
    refuted, parts = kind(entry["grade"]) == "refuted", []
    if entry.get("statements"):
        what = count(entry["statements"], "exact counterexample" if refuted else "certificate")
        parts.append(f"{what}, checked by two kernels")
    measured = entry.get("measurements", ())
    if enclosed := sum(seen["certified"] for seen in measured):
        parts.append(f"{count(enclosed, 'error')} enclosed in every case")
    if cases := sum(seen["samples"] for seen in measured if not seen["certified"]):
        parts.append(count(cases, "measured case"))
    mutants = entry.get("mutants", ())
    rejected = [variant for seen in entry.get("measurements", ()) for variant in seen["false_variants"]]
    if total := len(mutants) + len(rejected):
        good = sum(map(killed, mutants)) + sum(variant["rejected"] for variant in rejected)
        parts.append(f"{good} of {total} {'true variants proved' if refuted else 'false variants refuted'}")
    sampled = [seen for seen in entry.get("witness", ()) if seen.get("digits")]
    if points := sum(seen["points"] for seen in sampled):
        parts.append(f"{count(points, 'sample')} at {sampled[0]['digits']} digits")
    if edges := sum(len(condition["edges"]) for condition in entry.get("side_conditions", ())):
        parts.append(count(edges, "edge test"))
    return parts


def evidence_line(entry: dict) -> str:
    """One line: the grade, and what it follows from."""
    grade = entry.get("grade_line", entry["grade"])
    line = f"{grade}: {'; '.join(findings(entry))}" if findings(entry) else grade
    return line[0].upper() + line[1:]


def measurement(seen: dict) -> list[nodes.Node]:
    """What was measured: how many cases, the worst, its bound."""
    drawn = "" if seen["seed"] is None else f", seed {seen['seed']}"
    parts = [nodes.Text(f"{seen['what']}: {count(seen['samples'], 'case')}{drawn}; worst "), *typeset(seen["worst"])]
    if seen["bound"] is not None:
        parts += [nodes.Text(", bound "), *typeset(seen["bound"])]
    return [*parts, nodes.Text(", enclosed in balls" if seen["certified"] else "")]


def badge(grade: str, line: str = "") -> Html:
    """The grade as a shape and a letter; its name is there to be heard."""
    name = kind(grade)
    text = nodes.Text(f"{SHAPES[name]}\N{THIN SPACE}{LETTERS[name]}".strip())
    return Html("span", text, classes=["evidence", name], title=line or grade, role="img", aria_label=line or grade)


def legend(grades) -> Html:
    """What the badges mean."""
    items = [
        Html("li", badge(g), Html("strong", nodes.Text(g)), nodes.Text(f": {MEANINGS[g]}"))
        for g in MEANINGS
        if g in grades
    ]
    return Html("ul", *items, classes=["legend-of-grades"])
