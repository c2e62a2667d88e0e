"""Check the ledger against the last run and count its verdicts.

Usage: python -m book.ledger [--help]
"""

import argparse
import sys
from collections import Counter
from collections.abc import Sequence

from book.ledger.check import standing
from book.ledger.entries import VERDICTS


def main(arguments: Sequence[str] | None = None) -> int:
    """Return the exit status: 0 when the ledger stands, 1 when it does not."""
    argparse.ArgumentParser(prog="python -m book.ledger", description=__doc__.splitlines()[0]).parse_args(arguments)
    try:
        ledger, _ = standing()
    except ValueError as error:
        print(f"ledger: {error}", file=sys.stderr)
        return 1
    counts = Counter(claim.verdict for claim in ledger.claims)
    for verdict in VERDICTS:
        print(f"{counts[verdict]:4} {verdict}")
    print(f"{len(ledger.claims):4} claims, {sum(claim.of_seed for claim in ledger.claims)} of them the seed's")
    return 0


if __name__ == "__main__":
    sys.exit(main())
