"""Check every stored certificate with the kernel, in bare Python:  python -m proofs.check [ID …].

Imports the standard library alone: no SymPy, so it takes seconds. It decides whether each certificate proves the
statement stored with it, and that hypotheses can hold: "they contradict each other" is a statement, too, which an exact
point refutes. Of a case of a claim that cannot occur, the statement that it cannot is proved instead. `pytest verify`
compares the statements with today's formulas.
"""

import argparse
import hashlib
import json
import sys
import time
from collections.abc import Callable
from pathlib import Path

from proofs.engine import kernel


def text_of(path: Path) -> str:
    """Return a file's text; a byte that is no UTF-8 becomes a character that `parsed` refuses."""
    return path.read_bytes().decode("utf-8", "surrogateescape")


ABSURD = {"step": "show", "is": "=", "of": {"": "1"}}
PI = {"step": "define", "new": "pi", "of": {"": "355/113"}}  # of π a statement knows 3 < π < 22/7, and no more
PAIR = dict.fromkeys(("sha256", "statement", "certificate", "point"), lambda data: True)  # looked at below
CLAIM = {"claim": lambda name: isinstance(name, str), "statements": [PAIR]}


def contradiction(statement: dict) -> dict:
    """Return the derivation of 1 = 0 from a statement's assumptions and the definitions that these use."""
    steps = statement["steps"] if "steps" in statement else [{"step": "assume"} | s for s in statement["assume"]]
    needed, used = [ABSURD], set()
    for step in reversed(steps):
        if step["step"] == "assume" or step.get("new") in used:
            needed.insert(0, step)
            used |= {factor.partition("^")[0] for monomial in step["of"] for factor in monomial.split()}
    variables = [name for name in statement["variables"] if name in used]
    return {"version": statement["version"], "kind": "derivation", "variables": variables, "steps": needed}


def consistency(statement: dict) -> dict:
    """Return the "refutation" of its contradiction: at the point that is its certificate, the hypotheses hold."""
    said = contradiction(statement)
    if "pi" in said["variables"]:
        variables = [name for name in said["variables"] if name != "pi"]
        said |= {"variables": variables, "steps": [PI, *said["steps"]]}
    return said | {"kind": "refutation"}


def is_empty(statement: dict) -> bool:
    """Return whether a statement says that a case of its claim cannot occur."""
    return statement["kind"] == "derivation" and statement == contradiction(statement)


def why_void(statement: dict, point: dict | None, check: Callable) -> Exception | str | None:
    """Return None if the point shows that the hypotheses can hold, or no point is needed; else the reason.

    A separation and a refutation need no point; nor does a derivation of 1 = 0, which proves that there is none.
    """
    if statement["kind"] in ("derivation", "induction") and not is_empty(statement):
        return check(consistency(statement), {"point": point})
    return None if point is None else "a point where none is needed"


def reasons(cases: list, check: Callable = kernel.check) -> list[Exception | str | None]:
    """Return None, or why `check` does not accept it, of each case of a claim: (statement, certificate, point)."""
    refusals = [check(said, certificate) or why_void(said, point, check) for said, certificate, point in cases]
    contradictory = not any(refusals) and all(is_empty(statement) for statement, *_ in cases)
    return ["its hypotheses contradict each other"] * len(cases) if contradictory else refusals


def canonical(data: object) -> str:
    """Return the one text that a file of certificates may have: no key twice, no number in another form."""
    return json.dumps(data, indent=1, ensure_ascii=False) + "\n"


def digest(statement: dict) -> str:
    """Return the sha256 of a statement's canonical JSON, as stored beside it."""
    return hashlib.sha256(json.dumps(statement, sort_keys=True, separators=(",", ":")).encode()).hexdigest()


def parsed(text: str, theorem: str) -> list[dict]:
    """Return the claims of a certificate file's text; raise ValueError where that has another form."""
    try:
        text.encode()
        data = json.loads(text)
        same = text == canonical(data)
    except (ValueError, RecursionError) as why:
        raise ValueError(f"it is no JSON: {why}") from None
    if not same:
        raise ValueError("it is not its own canonical form")
    if not kernel.fits(data, {"version": 1, "theorem": theorem, "claims": [CLAIM]}):
        raise ValueError("it has another form")
    names = [claim["claim"] for claim in data["claims"] if claim["statements"]]
    if not names or len(set(names)) < len(data["claims"]):
        raise ValueError("it has no claim, or one without statements, or one twice")
    return data["claims"]


def verdicts(text: str, theorem: str) -> list[tuple[str, object]]:
    """Return [(claim, None or why it is rejected)] of a certificate file's text."""
    try:
        claims = parsed(text, theorem)
    except ValueError as why:
        return [("the file", why)]
    checked: list[tuple[str, object]] = []
    for claim in claims:
        cases = [(entry["statement"], entry["certificate"], entry["point"]) for entry in claim["statements"]]
        for entry, wrong in zip(claim["statements"], reasons(cases), strict=True):
            if wrong is None and digest(entry["statement"]) != entry["sha256"]:
                wrong = "its sha256 is another statement's"
            checked.append((claim["claim"], wrong))
    return checked


def main(arguments: list[str] | None = None) -> int:
    """Print a line a theorem; return 0 if the kernel accepts all, 1 if not, 2 on an unknown id."""
    from proofs.engine.project import PROJECT  # not above: a stand-alone script has none

    parser = argparse.ArgumentParser(prog="python -m proofs.check", description=__doc__)
    parser.add_argument("ids", nargs="*", metavar="ID", help="theorems (default: all)")
    known = {path.stem: path for path in sorted(PROJECT.certificates.glob("*.json"))}
    ids = parser.parse_args(arguments).ids or list(known)
    if unknown := [id for id in ids if id not in known]:
        there = f"no certificates of {', '.join(unknown)}; there are: {', '.join(known)}"
        print(f"python -m proofs.check: error: {there}", file=sys.stderr)
        return 2
    start, total, rejected = time.perf_counter(), 0, 0
    for id in ids:
        checked = verdicts(text_of(known[id]), id)
        wrong = [(claim, why) for claim, why in checked if why is not None]
        total, rejected = total + len(checked), rejected + len(wrong)
        print(f"{id:32} {len(checked) - len(wrong)} of {len(checked)} accepted")
        for claim, why in wrong:
            print(f"    {claim}: {why}")
    print(f"{total - rejected} of {total} certificates accepted in {time.perf_counter() - start:.1f} s")
    return int(rejected > 0)


if __name__ == "__main__":
    sys.exit(main())
