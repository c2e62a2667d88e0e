"""Tamper with every stored certificate, and ask three kernels: Python's, FLINT's, and the browser's JavaScript.

    python -m tests.tampered_certificates --count 1000 --seed 5

One coefficient or exponent is changed at a time (verify/checkers/tampering.py). Whatever is certainly false has to be
rejected by all three, and whatever a change leaves true accepted by all three; the run ends at the first that is not.
Writes verify/results/tampered_certificates.json, {"label": …, "numbers": …}: commit it. Needs Chromium.
"""

import argparse
import hashlib
import json
import shutil
import zlib
from concurrent.futures import ProcessPoolExecutor
from functools import cache
from pathlib import Path

from playwright.sync_api import sync_playwright
from tqdm import tqdm

from book.editions.chromium import FLAGS
from proofs.check import FOLDER
from proofs.engine import kernel
from proofs.engine.hypotheses import consistency
from verify.benchmark.label import label, write
from verify.checkers import second_checker
from verify.checkers.tampering import draws

ROOT = Path(__file__).resolve().parent.parent
RESULT = ROOT / "verify" / "results" / "tampered_certificates.json"
JAVASCRIPT = ROOT / "book" / "static" / "checker" / "kernel.js"
ASK = "(text) => { const { check } = Checker.kernel(); return JSON.parse(text).map((pair) => check(...pair)) }"
BATCH = 100
SHARE = 6  # certificates that a browser is opened for


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


def load_kernel(tab):
    """Put the JavaScript kernel into an empty tab, and return it as a function: pairs → what it says of each."""
    tab.goto("about:blank")
    tab.add_script_tag(path=JAVASCRIPT)
    return lambda pairs: tab.evaluate(ASK, json.dumps(pairs))


def accepted(pairs, javascript):
    """Return [(Python's verdict, FLINT's, JavaScript's)] of (statement, certificate) pairs: True where accepted."""
    answers = javascript(pairs)
    return [
        (kernel.check(*pair) is None, second_checker.why_refused(*pair) is None, answer["accepted"])
        for pair, answer in zip(pairs, answers, strict=True)
    ]


def different(drawn):
    """Yield what was not drawn before."""
    seen = set()
    for *pair, holds in drawn:
        digest = hashlib.sha256(json.dumps(pair, sort_keys=True).encode()).digest()
        if digest not in seen:
            seen.add(digest)
            yield *pair, holds


def trial(name, count, seed, javascript):
    """Draw until `count` different changes made a certificate false; return (false ones, harmless ones).

    Raises AssertionError, with the certificate's name, where a kernel's verdict is not what it should be.
    """
    original = stored()[name]
    assert accepted([original], javascript) == [(True, True, True)], f"{name}: the original is rejected"
    drawn, false, harmless = different(draws(*original, seed + zlib.crc32(name.encode()))), 0, 0
    while false < count:
        batch = [next(drawn) for _ in range(min(BATCH, count - false))]
        verdicts = accepted([pair for *pair, _ in batch], javascript)
        for (*pair, holds), verdict in zip(batch, verdicts, strict=True):
            assert verdict == (holds,) * 3, f"{name}: (Python, FLINT, JavaScript) say {verdict}, not {holds}: {pair}"
            false, harmless = false + (not holds), harmless + holds
    return false, harmless


def _share(arguments):
    """Try some certificates in a browser of one's own; return the counts of each."""
    names, count, seed = arguments
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=FLAGS)
        javascript = load_kernel(browser.new_page())
        counts = [trial(name, count, seed, javascript) for name in names]
        browser.close()
    return counts


def campaign(count, seed, workers):
    """Try every stored certificate on several processes; return what was done. Raises on the first failure."""
    names = list(stored())
    shares = [(names[n : n + SHARE], count, seed) for n in range(0, len(names), SHARE)]
    with ProcessPoolExecutor(workers) as pool:
        done = [each for part in tqdm(pool.map(_share, shares), total=len(shares), unit="share") for each in part]
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
    numbers = campaign(options.count, options.seed, options.workers)
    write(options.out, {"label": label("python-flint", "playwright"), "numbers": numbers})
    print(", ".join(f"{key.replace('_', ' ')}: {value:,}" for key, value in numbers.items()))


if __name__ == "__main__":
    main()
