"""Mutants before the kernel: what a false variant says, with the certificates of its theorem."""

from proofs.engine.claim import AnyClaim
from proofs.engine.derivative import Untranslatable
from proofs.engine.stored import Stale, statements, stored
from proofs.engine.theorem import Mutant, Theorem, Theorems


def splices(theorem: Theorem, claim: AnyClaim, theorems: Theorems) -> list[list[tuple[dict, dict]]]:
    """Return [[(statement, certificate)]]: a mutant's statements with each claim's certificates, one list a claim.

    A mutant is proved by a splice if all of its pairs are accepted. One that no rule translates has no statement.
    """
    try:
        said, proved = statements(claim, theorems), stored(theorem, theorems)
    except (Untranslatable, Stale):
        return []
    tried = []
    for original, cases in proved:
        before = statements(original, theorems)
        places = [(s, min(i, len(cases) - 1)) for i, s in enumerate(said)]
        tried.append([(_fitted(s, before[place], cases[place][0]), cases[place][1]) for s, place in places])
    return tried


def _fitted(said, before, stored_statement):
    """Return what a mutant says without the assumptions that the stored statement leaves out of `before`."""
    if not said.keys() == before.keys() == stored_statement.keys() or "steps" not in said:
        return said
    gone = [step for step in before["steps"] if step not in stored_statement["steps"]]
    return said | {"steps": [step for step in said["steps"] if step["step"] != "assume" or step not in gone]}


def says_the_same(theorem: Theorem, mutant: Mutant, theorems: Theorems) -> str | None:
    """Return the claims and mutants whose statements are those of a mutant, as text; or None but for itself."""
    others = [(f"the claim {claim.name}", claim) for claim in theorem.claims]
    others += [(f"the mutant {other.text}", other.claim) for other in theorem.mutants]
    said = _said(mutant.claim, theorems)
    alike = [name for name, claim in others if said is not None and _said(claim, theorems) == said]
    return ", ".join(alike) if len(alike) > 1 else None


def _said(claim, theorems):
    try:
        return statements(claim, theorems)
    except Untranslatable:
        return None
