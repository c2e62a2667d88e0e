"""Check every stored certificate with the kernel, in bare Python:  python -m proofs.check [ID …]

Imports the standard library alone: no SymPy, so it takes seconds. It decides whether each certificate proves the
statement stored with it. That the statements are those of today's formulas is for `pytest verify` to say.
"""

import argparse
import hashlib
import json
import sys
import time
from collections.abc import Sequence
from pathlib import Path

from proofs.engine.hypotheses import reasons
from proofs.engine.kernel import fits

FOLDER = Path(__file__).parent / "certificates"


def files(ids: Sequence[str]) -> list[Path]:
    """Return the certificate files of the given theorems (all, if none is given); ValueError on an unknown id."""
    known = {path.stem: path for path in sorted(FOLDER.glob("*.json"))}
    if unknown := [id for id in ids if id not in known]:
        raise ValueError(f"no certificates of {', '.join(unknown)}; there are: {', '.join(known)}")
    return [known[id] for id in ids] if ids else list(known.values())


PAIR = dict.fromkeys(("sha256", "statement", "certificate", "point"), lambda data: True)  # looked at below
CLAIM = {"claim": lambda name: isinstance(name, str), "statements": [PAIR]}


def canonical(data: object) -> str:
    """Return the one text that a file of certificates may have: no key twice, no number in another form."""
    return json.dumps(data, indent=1, ensure_ascii=False) + "\n"


def digest(statement: dict) -> str:
    """Return the sha256 of a statement's canonical JSON, as stored beside it."""
    return hashlib.sha256(json.dumps(statement, sort_keys=True, separators=(",", ":")).encode()).hexdigest()


def verdicts(text: str, theorem: str) -> list[tuple[str, object]]:
    """Return [(claim, None or why it is rejected)] of a certificate file's text."""
    data = json.loads(text)
    found: list[tuple[str, object]] = []
    if text != canonical(data):
        return [("the file", "it is not its own canonical form")]
    if not fits(data, {"version": 1, "theorem": theorem, "claims": [CLAIM]}):
        return [("the file", "it has another form")]
    for claim in data["claims"]:
        cases = [(entry["statement"], entry["certificate"], entry["point"]) for entry in claim["statements"]]
        for entry, wrong in zip(claim["statements"], reasons(cases), strict=True):
            if wrong is None and digest(entry["statement"]) != entry["sha256"]:
                wrong = "its sha256 is another statement's"
            found.append((claim["claim"], wrong))
    return found


def main(arguments: list[str] | None = None) -> int:
    """Print a line a theorem; return 0 if the kernel accepts all, 1 if not, 2 on an unknown id."""
    parser = argparse.ArgumentParser(prog="python -m proofs.check", description=__doc__)
    parser.add_argument("ids", nargs="*", metavar="ID", help="theorems (default: all)")
    try:
        chosen = files(parser.parse_args(arguments).ids)
    except ValueError as error:
        print(f"python -m proofs.check: error: {error}", file=sys.stderr)
        return 2
    start, total, rejected = time.perf_counter(), 0, 0
    for path in chosen:
        found = verdicts(path.read_text(encoding="utf-8"), path.stem)
        wrong = [(claim, why) for claim, why in found if why is not None]
        total, rejected = total + len(found), rejected + len(wrong)
        print(f"{path.stem:32} {len(found) - len(wrong)} of {len(found)} accepted")
        for claim, why in wrong:
            print(f"    {claim}: {why}")
    print(f"{total - rejected} of {total} certificates accepted in {time.perf_counter() - start:.1f} s")
    return int(rejected > 0)


if __name__ == "__main__":
    sys.exit(main())
