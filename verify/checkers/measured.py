"""Theorems without claims: their measurements, in every module of the project's package of them, and their grade.

certified  everything is an enclosure, over whole ranges, of what the theorem's words state, and rejects false variants
measured   every measurement holds on its samples, and rejects its false variants
cited      the source is in the bibliography
"""

import importlib
import pkgutil
import re
from collections.abc import Callable
from functools import cache

from proofs.engine.project import PROJECT
from proofs.engine.theorem import Theorem, Theorems, incomplete
from verify.checkers.grades import Examination
from verify.checkers.measurement import FALSE, REGISTERED, Enclosure, record, says, unnamed
from verify.optional import lacking


@cache
def _left_out():
    """Import every module of measurements; return {id: the library it needs} of those that cannot be imported."""
    needs, folder = {}, PROJECT.folder(PROJECT.measurements)
    for module in sorted(m.name for m in pkgutil.iter_modules([str(folder)])):
        try:
            importlib.import_module(f"{PROJECT.measurements}.{module}")
        except ImportError as error:
            if not (library := lacking(error)):
                raise
            text = (folder / f"{module}.py").read_text(encoding="utf-8")
            needs |= dict.fromkeys(re.findall(r'\bmeasures\(\s*"(\w+)"', text), library)
    return needs


def measurements() -> dict[str, list[tuple[Callable, dict]]]:
    """Return what is registered, of every module of measurements that can be imported here."""
    _left_out()
    return REGISTERED


def library_for(theorem_id: str) -> str | None:
    """Return the library without which a theorem cannot be measured here, or None if it can."""
    return _left_out().get(theorem_id)


def examine(theorem: Theorem, theorems: Theorems) -> Examination:
    """Return the Examination of a theorem without claims: measured, or else cited."""
    examination = Examination(theorem.id, theorem.expected, theorem.uses)
    examination.problems += incomplete(theorem, theorems)
    examination.check_sources(theorem)
    evidence = [(function(), function, false) for function, false in measurements().get(theorem.id, ())]
    examination.record["measurements"] = [_measured(examination, theorem, *entry) for entry in evidence]
    examination.reached = "cited"
    if theorem.expected != "cited":
        enclosed = [seen for seen, *_ in evidence if isinstance(seen, Enclosure)]
        examination.reached = "certified" if evidence and len(enclosed) == len(evidence) else "measured"
        missing = unnamed(theorem.words, [name for seen in enclosed for name in seen.over])
        if examination.reached == "certified" and missing:
            examination.problems.append(f"nothing is enclosed over {', '.join(sorted(missing))}")
        if not evidence:
            examination.problems.append(f"no measurement is registered for it in {PROJECT.measurements}")
    examination.record["grade"] = examination.grade
    return examination


def _measured(examination, theorem, seen, function, false):
    """Judge what a measurement saw, and run its false variants, which it has to reject."""
    rejected: list[dict] = []
    why = seen.why_refused()
    if isinstance(seen, Enclosure) and not says(theorem.words, seen.bound):
        why = why or "the theorem's words do not state this bound"
    if why:
        examination.problems.append(f"{seen.what}: {why}: worst {seen.worst}, bound {seen.bound}")
    for text, changes in false.items():
        rejected.append({"variant": text, "rejected": function(**changes).why_refused() == FALSE})
        examination.mutants += 1
        examination.mutants_killed += rejected[-1]["rejected"]
        if not rejected[-1]["rejected"]:
            examination.problems.append(f"{seen.what}: does not reject the false variant “{text}”")
    return record(seen) | {"false_variants": rejected}
