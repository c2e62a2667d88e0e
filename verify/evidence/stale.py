"""Stored certificates that no longer follow from the formulas:  python -m verify.evidence.stale

It lists the theorems whose certificates have to be searched anew; nothing is searched, and no certificate is checked.
It fails where there is any.
"""

import argparse
import sys
from collections.abc import Iterator

from proofs.engine.stored import NotFound, Stale, stored
from proofs.engine.theorem import all_theorems


def problems() -> Iterator[str]:
    """Yield, for each theorem whose claims are not those of its stored certificates, why."""
    for theorem in all_theorems().values():
        try:
            if theorem.claims:
                stored(theorem)
        except (Stale, NotFound) as error:
            yield str(error)


if __name__ == "__main__":
    argparse.ArgumentParser("python -m verify.evidence.stale", description=__doc__).parse_args()
    sys.exit("\n".join(problems()) or None)
