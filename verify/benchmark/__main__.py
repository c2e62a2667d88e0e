"""Measure whole frames on this machine:

    python -m verify.benchmark                           (some minutes, on a machine that does nothing else)
    python -m verify.benchmark --quick                   one round, sides up to 1024
    python -m verify.benchmark --only NAME               cases whose name contains NAME

Whole frames by every renderer, steps of a sweep, the command line's start. Writes verify/benchmark/results/frames.json,
from which the book prints: commit it. The gradient alone is measured by `python -m verify.benchmark.work_precision`.
"""

from contextlib import suppress
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from verify.benchmark.frames import FITTED, frame_cases, start_cases, step_cases
from verify.benchmark.timing import ROUNDS, load, numbers_by_calls, ratios
from verify.evidence.records import command

QUICK_SIDE = 1024
RATIOS = {
    "numpy_to_algebraic_1024": ("numpy_1024_2_ms", "algebraic_1024_2_ms"),
    "seed_to_algebraic_256": ("seed_exact_256_1_ms", "algebraic_256_2_ms"),
    "seed_central_to_exact": ("seed_central_256_1_ms", "seed_exact_256_1_ms"),
    "eps_step_central_to_exact": ("eps_step_central_1024_2_ms", "eps_step_exact_1024_2_ms"),
    "a_alone_central_to_algebraic": ("a_alone_central_1024_1_ms", "a_alone_algebraic_1024_1_ms"),
}  # fmt: skip
"""{number: (the time that is so many times as long, as this one)}"""


def derived(numbers: dict[str, float]) -> dict[str, float]:
    """Return the ratios and exponents of {CASE_ms: milliseconds}, of those cases that were timed."""
    found = ratios(numbers, RATIOS)
    for threads in (1, 2):
        with suppress(KeyError):
            times = [numbers[f"algebraic_{side}_{threads}_ms"] for side in FITTED]  # time ∝ pixels^p
            found[f"exponent_{threads}"] = float(np.polyfit(2 * np.log(FITTED), np.log(times), 1)[0])
    return found


def measure(rounds: int, quick: bool, only: str) -> dict[str, Any]:
    """Return the numbers of whole frames; only: of the cases whose name contains it."""
    before, rounds = load(), 1 if quick else rounds
    cases = [*frame_cases(QUICK_SIDE if quick else 2**24), *step_cases(), *start_cases()]
    cases = [replace(case, visits=min(rounds, case.visits)) for case in cases if only in case.name]
    if not cases:
        raise SystemExit(f"--only {only}: no case has that in its name")
    numbers = numbers_by_calls(cases, "frames")
    return {"numbers": numbers | derived(numbers) | {"load": before}}


main = partial(command, "frames", __doc__, measure, rounds=ROUNDS, quick=False, only="")

if __name__ == "__main__":
    main()
