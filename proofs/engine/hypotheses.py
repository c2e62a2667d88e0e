"""Hypotheses that can hold: "they contradict each other" as a statement, which an exact point refutes. Trusted.

Every kernel checks the point as it checks any counterexample. Of a case of a claim that cannot occur, the statement
that it cannot is proved instead. Imports the standard library alone.
"""

from collections.abc import Callable

from proofs.engine import kernel

ABSURD = {"step": "show", "is": "=", "of": {"": "1"}}
PI = {"step": "define", "new": "pi", "of": {"": "355/113"}}  # of π a statement knows 3 < π < 22/7, and no more


def contradiction(statement: dict) -> dict:
    """Return the derivation of 1 = 0 from what a derivation or an induction assumes, and what that is made of."""
    steps = statement["steps"] if "steps" in statement else [{"step": "assume"} | s for s in statement["assume"]]
    kept, used = [ABSURD], set()
    for step in reversed(steps):
        if step["step"] == "assume" or step.get("new") in used:
            kept.insert(0, step)
            used |= {factor.partition("^")[0] for monomial in step["of"] for factor in monomial.split()}
    variables = [name for name in statement["variables"] if name in used]
    return {"version": statement["version"], "kind": "derivation", "variables": variables, "steps": kept}


def consistency(statement: dict) -> dict:
    """Return the "refutation" of its contradiction: at the point that is its certificate, the hypotheses hold."""
    said = contradiction(statement)
    if "pi" in said["variables"]:
        variables = [name for name in said["variables"] if name != "pi"]
        said |= {"variables": variables, "steps": [PI, *said["steps"]]}
    return said | {"kind": "refutation"}


def why_void(statement: dict, point: dict | None, check: Callable = kernel.check) -> Exception | str | None:
    """Return None if the point shows that the hypotheses can hold, or where none is needed; else why it does not.

    None is needed by a separation and a refutation; nor by a derivation of 1 = 0, which says that there is none.
    """
    if statement["kind"] in ("derivation", "induction") and not is_empty(statement):
        return check(consistency(statement), {"point": point})
    return None if point is None else "a point where none is needed"


def reasons(cases: list, check: Callable = kernel.check) -> list[Exception | str | None]:
    """Return None, or why `check` does not accept it, of each case of a claim: (statement, certificate, point)."""
    found = [check(said, certificate) or why_void(said, point, check) for said, certificate, point in cases]
    contradictory = not any(found) and all(is_empty(statement) for statement, *_ in cases)
    return ["its hypotheses contradict each other"] * len(cases) if contradictory else found


def is_empty(statement: dict) -> bool:
    """Return whether a statement says that a case of its claim cannot occur."""
    return statement["kind"] == "derivation" and statement == contradiction(statement)


def weaker(statement: dict, kept: dict) -> dict:
    """Return a derivation with no assumption that `kept` lacks: what then follows, follows from all of them."""
    left = [step for step in statement["steps"] if step["step"] != "assume" or step in kept["steps"]]
    return statement | {"steps": left}
