"""What long runs share: their command line, their processes, and the JSON with a label that they write."""

import argparse
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from tqdm import tqdm

from verify.benchmark.label import label, write

RESULTS = Path(__file__).resolve().parent.parent / "verify" / "results"


def command(name, doc, campaign, count, *packages):
    """Run `python -m tests.NAME` and write verify/results/NAME.json, {"label": …, "numbers": …}.

    campaign(count, seed, sums) returns the numbers. sums(work, *arguments) maps work over lists of arguments, on some
    processes, and returns the sums of the tuples that it gives; it raises on the first failure.
    """
    formatter = argparse.RawDescriptionHelpFormatter
    parser = argparse.ArgumentParser(f"python -m tests.{name}", description=doc, formatter_class=formatter)
    parser.add_argument("--count", type=int, default=count, help="how many (default: %(default)s)")
    parser.add_argument("--seed", type=int, default=5, help="of the draw (default: %(default)s)")
    parser.add_argument("--workers", type=int, default=2, help="processes (default: %(default)s)")
    options = parser.parse_args()

    def sums(work, *arguments):
        with ProcessPoolExecutor(options.workers) as pool:
            done = list(tqdm(pool.map(work, *arguments), total=len(arguments[0])))
        return [sum(column) for column in zip(*done, strict=True)]

    numbers = campaign(options.count, options.seed, sums)
    write(RESULTS / f"{name}.json", {"label": label(*packages), "numbers": numbers})
    print(", ".join(f"{key.replace('_', ' ')}: {value:,}" for key, value in numbers.items()))
