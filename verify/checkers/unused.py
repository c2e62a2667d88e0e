"""Hypotheses that no certificate uses: each may be dropped, or guards what the claim means."""

FACTS = {"assume": 1, "show": 1, "inverse": 1, "root": 2, "define": 0}


def unused(pairs):
    """Return how many hypotheses of [(statement, certificate)] no proof uses, and how many there are.

    One that several cases of a claim share counts once for each. Circles and the bounds of π count as hypotheses.
    """
    idle = given = 0
    for statement, certificate in pairs:
        if statement["kind"] == "derivation":
            assumed = _assumed(statement)
            idle, given = idle + len(assumed - _used(statement, certificate)), given + len(assumed)
    return idle, given


def _assumed(statement):
    numbered, count = set(), 0
    for step in statement["steps"]:
        numbered |= {count} if step["step"] == "assume" else set()
        count += FACTS[step["step"]]
    return numbered


def _used(statement, certificate):
    used, count, proofs = set(), 0, iter(certificate["proofs"])
    for step in statement["steps"]:
        if step["step"] in ("show", "root", "inverse"):
            proof = next(proofs)
            named = [*proof.get("positive", ()), *(i for i, _ in proof["cofactors"])]
            named += [i for _, _, factors in proof.get("sum", ()) for i in factors]
            used |= {i for i in named if i < count}  # the next one is the goal's negation
        count += FACTS[step["step"]]
    return used
