"""Grades of theorems: first on their own evidence, then lowered to those of the theorems that they use."""

import re
from collections import Counter
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

from proofs.engine.project import PROJECT
from proofs.engine.theorem import Theorem
from verify.coq import recorded

BIBLIOGRAPHY = PROJECT.bibliography
if not BIBLIOGRAPHY.is_file():
    BIBLIOGRAPHY = Path(__file__).parents[1] / "references.bib"  # where the wheel has it
NOT_RECHECKED = "not re-checked"  # here: a library is not installed
CERTIFIED = ("proved", "refuted", "certified")
STANDING = (*CERTIFIED, "measured")
ENOUGH: dict[str, tuple[str, ...]] = {"proved": ("proved",), "refuted": ("proved",), "certified": CERTIFIED}
"""{grade: those that it may rest on}, of others any that is STANDING"""


@dataclass
class Examination:
    """A run's evidence for one theorem. problems: the evidence that is missing. record: its entry of the report."""

    id: str
    expected: str
    uses: tuple
    record: dict = field(default_factory=dict)
    problems: list = field(default_factory=list)
    mutants_killed: int = 0
    mutants: int = 0
    claims: int = 0
    reached: str = ""  # by measurement; else the checkers' verdict stands

    def __post_init__(self):
        self.record = self.record or {"id": self.id, "expected": self.expected, "uses": sorted(self.uses)}

    @property
    def grade(self) -> str:
        """The grade on this theorem's own evidence; `final_grades` adds what it rests on."""
        if self.problems:
            return "failed"
        if self.reached or not self.claims:  # without a claim nothing is proved
            return self.reached or "failed"
        return "refuted" if self.expected == "refuted" else "proved"

    def check_sources(self, theorem: Theorem) -> None:
        """Note pinned statements and cited sources: Coq's record must have the former, the bibliography the latter."""
        self.record |= {"pinned": [pin.name for pin in theorem.pinned]} if theorem.pinned else {}
        self.problems += recorded.why_not_pinned(theorem)
        lemmas = [lemma for claim in theorem.claims for lemma in claim.cited]
        if lemmas:
            self.record["cited_lemmas"] = [{"relation": lemma.text, "source": lemma.source} for lemma in lemmas]
        keys = {lemma.source for lemma in lemmas}
        text = BIBLIOGRAPHY.read_text(encoding="utf-8") if BIBLIOGRAPHY.is_file() else ""
        entries = set(re.findall(r"^@\w+\{([^,\s]+)", text, re.MULTILINE))
        self.problems += [f"the bibliography has no {key}" for key in sorted(keys - entries)]


def final_grades(evidences: Iterable[dict]) -> dict[str, tuple[str, str]]:
    """Return {id: (grade, reason)}: a theorem is proved only if all that it uses, in the same run, is proved."""
    by_id = {e["id"]: e for e in evidences}

    @cache
    def grade(id):
        if id not in by_id:
            return "missing", f"{id} was not run"
        alone, uses = by_id[id]["grade"], by_id[id]["uses"]
        enough = ENOUGH.get(alone, STANDING)
        weak = [use for use in uses if grade(use)[0] not in enough]
        if alone != "failed" and NOT_RECHECKED in (alone, *(grade(use)[0] for use in weak)):
            return NOT_RECHECKED, by_id[id].get("reason", "what it uses was not re-checked")
        if alone != "failed" and weak:
            wanted = "without evidence" if enough == STANDING else f"not {', '.join(enough)}"
            return "failed", f"it uses {', '.join(weak)}, {wanted} in this run"
        return alone, ""

    return {id: grade(id) for id in by_id}


def given_cited(evidences: Iterable[dict], in_coq: Collection[str] = ()) -> dict[str, list[str]]:
    """Return {id: the sources whose lemmas it rests on, directly or through what it uses}.

    in_coq: the theorems whose claims Coq has proved in this run, from no lemma and no other theorem.
    """
    by_id = {e["id"]: e for e in evidences}

    @cache
    def sources(id):
        record = {} if id in in_coq else by_id.get(id, {})
        direct = {lemma["source"] for lemma in record.get("cited_lemmas", ())}
        return direct.union(*map(sources, record.get("uses", ())))

    return {id: sorted(sources(id)) for id in by_id}


def grade_line(grade: str, sources: Sequence[str]) -> str:
    """Return a grade in words: "proved", "proved, given Dekker1971", …"""
    return f"{grade}, given {', '.join(sources)}" if grade in ("proved", "refuted") and sources else grade


def graded(evidences: Sequence[dict], in_coq: Collection[str] = ()) -> list[dict]:
    """Return the entries of the report, in order of ids: each theorem's evidence, grade and grade line.

    in_coq: the theorems that Coq has proved in this run.
    """
    grades, sources = final_grades(evidences), given_cited(evidences, in_coq)
    entries = []
    for entry in sorted(evidences, key=lambda e: e["id"]):
        grade, reason = grades[entry["id"]]
        line = grade_line(grade, sources[entry["id"]])
        more = {"reason": reason} if reason else {}
        entries.append(entry | more | {"grade": grade, "grade_line": line, "given_cited": sources[entry["id"]]})
    return entries


def summary(entries: Iterable[dict]) -> dict[str, int]:
    """Return how many theorems have each grade; those proved given a cited lemma are counted apart."""
    counts = Counter(
        e["grade"] + ("_given_cited" if e["given_cited"] and e["grade"] != "failed" else "") for e in entries
    )
    return dict(sorted(counts.items()))
