"""The one path by which a claim is accepted, a theorem's or a mutant's: a certificate that both checkers accept.

The second one needs python-flint: a run without it says so in every grade that rests on a certificate.
"""

from collections.abc import Sequence

from proofs.engine import kernel
from proofs.engine.certificate import Proved, prove
from proofs.engine.claim import AnyClaim, Claim
from proofs.engine.hypotheses import is_empty, reasons
from proofs.engine.search import MAX_EFFORT, NotFound
from proofs.engine.theorem import Theorems

try:
    from verify.checkers.second_checker import why_refused
except ImportError:  # no python-flint
    CHECKERS = {"the kernel": kernel.check}
else:
    CHECKERS = {"the kernel": kernel.check, "the second checker": why_refused}
"""{name: a function of a statement and a certificate that returns None, or why the one does not prove the other}"""


def show_polynomial(p: dict, limit: int = 12) -> str:
    """Return a polynomial, the kernel's or polynomial data, as text of at most `limit` terms."""
    terms = p if all(isinstance(k, str) for k in p) else {" ".join(m): str(c) for m, c in p.items()}
    text = " + ".join(f"{c}·{m.replace(' ', '·')}" if m else str(c) for m, c in list(terms.items())[:limit]) or "0"
    return text + (f" + … ({len(terms)} terms)" if len(terms) > limit else "")


def why_rejected(statement: dict, certificate: dict) -> str | None:
    """Return None if every checker accepts, else the reason, with the residual polynomial."""
    for name, checker in CHECKERS.items():
        why = checker(statement, certificate)
        if why is not None:
            reason, *residual = why.args or (repr(why),)
            shown = f"; residual {show_polynomial(residual[0])}" if residual and residual[0] else ""
            return f"{name} rejects: {reason}{shown}"
    return None


def not_found(error: NotFound) -> str:
    """Return the text of a failed search: the goal, and what is left of it."""
    goal, relation = error.goal
    if isinstance(goal, dict):
        left = f"; what is left of it: {show_polynomial(error.remainder)}" if error.remainder else ""
        return f"no certificate found for {show_polynomial(goal)} {relation} 0{left}"
    return f"no certificate found: {goal}"


def by_definition(claim: AnyClaim, cases: Sequence[Proved]) -> bool:
    """Return whether nothing was left for the kernel to decide: all that is shown is 0 = 0, or is given.

    The conditions of branches, which a statement shows besides the claim's own relations, count as something.
    """
    if not isinstance(claim, Claim):
        return False
    steps = [step for statement, *_ in cases if not is_empty(statement) for step in statement.get("steps", ())]
    shown = [step for step in steps if step["step"] == "show"]
    given = [(step["is"], step["of"]) for step in steps if step["step"] == "assume"] * (len(shown) <= len(claim.shows))
    return bool(shown) and all(not step["of"] or (step["is"], step["of"]) in given for step in shown)


def accept(claim: AnyClaim, theorems: Theorems, cases: list[Proved] | None = None, effort: int = MAX_EFFORT) -> list:
    """Return the reasons why a claim is not accepted: the one path for theorems and mutants.

    cases: what `proofs.engine.certificate` found or keeps; None: it is searched for.
    """
    try:
        cases = prove(claim, theorems, effort) if cases is None else cases
    except NotFound as error:
        return [not_found(error)]
    return [why for why in reasons(cases, why_rejected) if why]
