"""Tamper with every stored certificate, and ask three kernels: Python's, FLINT's, and the page's JavaScript.

    python -m tests.tampered_certificates --count 1000 --seed 5

One coefficient or exponent is changed at a time (verify/checkers/tampering.py). Whatever is certainly false has to be
rejected by all three, and whatever a change leaves true accepted by all three; the run ends at the first that is not.
Writes verify/results/tampered_certificates.json, {"label": …, "numbers": …}: commit it. Needs node.
"""

import hashlib
import json
import zlib
from functools import cache

from proofs.check import FOLDER, consistency
from tests.long_run import command
from verify.checkers.kernels import accepted
from verify.checkers.tampering import draws

BATCH = 100


@cache
def stored():
    """Return {theorem/claim/number: (statement, certificate)} of everything that is stored."""
    return {name: (entry["statement"], entry["certificate"]) for name, entry in _entries()}


@cache
def points():
    """Return {theorem/claim/number: (statement, certificate)} of the points at which hypotheses hold."""
    held = {name: entry for name, entry in _entries() if entry["point"] is not None}
    return {name: (consistency(entry["statement"]), {"point": entry["point"]}) for name, entry in held.items()}


def _entries():
    for path in sorted(FOLDER.glob("*.json")):
        for claim in json.loads(path.read_text(encoding="utf-8"))["claims"]:
            for number, entry in enumerate(claim["statements"]):
                yield f"{path.stem}/{claim['claim']}/{number}", entry


def different(drawn):
    """Yield what was not drawn before."""
    seen = set()
    for *pair, holds in drawn:
        digest = hashlib.sha256(json.dumps(pair, sort_keys=True).encode()).digest()
        if digest not in seen:
            seen.add(digest)
            yield *pair, holds


def trial(name, count, seed):
    """Draw until `count` different changes made a certificate false; return (false ones, harmless ones).

    Raises AssertionError, with the certificate's name, where a kernel's verdict is not what it should be.
    """
    original = stored()[name]
    drawn, false, harmless = different(draws(*original, seed + zlib.crc32(name.encode()))), 0, 0
    batch = [(*original, True)]
    while batch:
        texts = [json.dumps(pair, separators=(",", ":"), ensure_ascii=False) for *pair, _ in batch]
        for text, (*_, holds), verdicts in zip(texts, batch, accepted(texts), strict=True):
            assert set(verdicts.values()) == {holds}, f"{name}: the kernels say {verdicts}, not {holds}: {text}"
            false, harmless = false + (not holds), harmless + holds
        batch = [next(drawn) for _ in range(min(BATCH, count - false))]
    return false, harmless - 1  # without the original


def campaign(count, seed, sums):
    """Make `count` false changes of every stored certificate; return what was done."""
    assert len(accepted(["[null,null]"])[0]) == 3, "python-flint and node have to be installed"
    names = list(stored())
    false, harmless = sums(trial, names, [count] * len(names), [seed] * len(names))
    return {
        "certificates": len(names),
        "count": count,
        "seed": seed,
        "tampered": false,
        "rejected_by_python": false,  # by each kernel: else an exception would have ended the run
        "rejected_by_flint": false,
        "rejected_by_javascript": false,
        "harmless_and_accepted_by_all": harmless,
    }


if __name__ == "__main__":
    command("tampered_certificates", __doc__, campaign, 1000, "python-flint")
