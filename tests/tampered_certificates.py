"""Tamper with every stored certificate, and ask three kernels: Python's, FLINT's, and the page's JavaScript.

    python -m tests.tampered_certificates --count 1000 --seed 5

One coefficient or exponent is changed at a time (verify/checkers/tampering.py). Whatever is certainly false has to be
rejected by all three, and whatever a change leaves true accepted by all three; the run ends at the first that is not.
Writes verify/results/tampered_certificates.json, {"label": …, "numbers": …}: commit it. Needs node.
"""

import argparse
import hashlib
import json
import zlib
from concurrent.futures import ProcessPoolExecutor
from functools import cache
from pathlib import Path

from tqdm import tqdm

from proofs.check import FOLDER, consistency
from verify.benchmark.label import label, write
from verify.checkers.kernels import accepted
from verify.checkers.tampering import draws

RESULT = Path(__file__).resolve().parent.parent / "verify" / "results" / "tampered_certificates.json"
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


def campaign(count, seed, workers):
    """Try every stored certificate on several processes; return what was done. Raises on the first failure."""
    names = list(stored())
    with ProcessPoolExecutor(workers) as pool:
        tried = pool.map(trial, names, [count] * len(names), [seed] * len(names))
        done = list(tqdm(tried, total=len(names), unit="certificate"))
    false, harmless = (sum(column) for column in zip(*done, strict=True))
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


def main():
    """Parse the command line, run, write."""
    formatter = argparse.RawDescriptionHelpFormatter
    parser = argparse.ArgumentParser(
        "python -m tests.tampered_certificates", description=__doc__, formatter_class=formatter
    )
    parser.add_argument("--count", type=int, default=1000, help="false changes of each (default: %(default)s)")
    parser.add_argument("--seed", type=int, default=5, help="of the draw (default: %(default)s)")
    parser.add_argument("--workers", type=int, default=2, help="processes (default: %(default)s)")
    parser.add_argument("--out", type=Path, default=RESULT, help="the JSON file")
    options = parser.parse_args()
    if len(accepted(["[null,null]"])[0]) < 3:
        parser.error("python-flint and node have to be installed")
    numbers = campaign(options.count, options.seed, options.workers)
    write(options.out, {"label": label("python-flint"), "numbers": numbers})
    print(", ".join(f"{key.replace('_', ' ')}: {value:,}" for key, value in numbers.items()))


if __name__ == "__main__":
    main()
