"""Printed files and stored certificates that no longer follow from the formulas:  python -m verify.evidence.stale

It lists the files that `python -m renderer.generate` would change, and the theorems whose certificates have to be
searched anew; nothing is searched, and no certificate is checked. It fails where there is any.
"""

import argparse
import sys
from collections.abc import Iterator

from proofs.engine.stored import NotFound, Stale, stored
from proofs.engine.theorem import Theorem, all_theorems
from renderer.generate.__main__ import PRINTED


def why_stale(theorem: Theorem) -> str | None:
    """Return why a theorem's claims are not those of its stored certificates, or None."""
    try:
        stored(theorem)
    except (Stale, NotFound) as error:
        return str(error)
    return None


def problems() -> Iterator[str]:
    """Yield the files and theorems that no longer follow from the formulas, each with the reason."""
    for path, source_of in PRINTED.items():
        if path.read_text(encoding="utf-8") != source_of():
            yield f"{path.name}: not what is printed now"
    yield from filter(None, (why_stale(theorem) for theorem in all_theorems().values() if theorem.claims))


if __name__ == "__main__":
    argparse.ArgumentParser("python -m verify.evidence.stale", description=__doc__).parse_args()
    stale = False
    for problem in problems():
        print(problem)
        stale = True
    sys.exit(stale)
