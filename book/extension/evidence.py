"""Evidence in words, made from a theorem's last run and never by its author."""

from book.extension.theorems import kind


def count(number: int, word: str) -> str:
    """Return a count with its noun: 1 certificate, 2 certificates."""
    return f"{number:,} {word}{'' if number == 1 else 's'}"


def killed(mutant: dict) -> bool:
    """Return whether a false variant was refuted, or a refuted claim's true variant proved and spared."""
    if "variant" in mutant:
        return mutant["accepted"] and mutant["spared"]
    return mutant["refused"] and mutant["counterexample"] is not None


def findings(entry: dict) -> list[str]:
    """Return the results of the last run, part by part."""
    refuted, parts = kind(entry["grade"]) == "refuted", []
    if entry.get("statements"):
        proofs = count(entry["statements"], "exact counterexample" if refuted else "certificate")
        parts.append(f"{proofs}, checked by two kernels")
    measured = entry.get("measurements", ())
    if enclosed := sum(each["certified"] for each in measured):
        parts.append(f"{count(enclosed, 'error')} enclosed in every case")
    if cases := sum(each["samples"] for each in measured if not each["certified"]):
        parts.append(count(cases, "measured case"))
    mutants = entry.get("mutants", ())
    rejected = [variant for each in measured for variant in each["false_variants"]]
    if total := len(mutants) + len(rejected):
        good = sum(map(killed, mutants)) + sum(variant["rejected"] for variant in rejected)
        parts.append(f"{good} of {total} {'true variants proved' if refuted else 'false variants refuted'}")
    sampled = [each for each in entry.get("witness", ()) if each.get("digits")]
    if points := sum(each["points"] for each in sampled):
        parts.append(f"{count(points, 'sample')} at {sampled[0]['digits']} digits")
    if edges := sum(len(condition["edges"]) for condition in entry.get("side_conditions", ())):
        parts.append(count(edges, "edge test"))
    return parts


def evidence_line(entry: dict) -> str:
    """Return one line: the grade, and what it follows from."""
    grade = entry.get("grade_line", entry["grade"])
    line = f"{grade}: {'; '.join(findings(entry))}" if findings(entry) else grade
    if entry.get("shown") == "formal":
        statements = sum(len(entry["formal"][of]) for of in ("claims", "statements"))
        line = f"formal: {count(statements, 'statement')} in Coq, {entry['when']}; {line}"
    return line[0].upper() + line[1:]
