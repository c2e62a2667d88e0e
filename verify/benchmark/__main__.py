"""Measure whole frames on this machine:

    python -m verify.benchmark                           (some minutes, on a machine that does nothing else)
    python -m verify.benchmark --quick                   one round, sides up to 1024
    python -m verify.benchmark --only NAME               cases whose name contains NAME

Whole frames by every renderer, steps of a sweep, the command line's start. Writes verify/benchmark/results/frames.json,
from which the book prints: commit it. The gradient alone is measured by `python -m verify.benchmark.work_precision`.
"""

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from verify.benchmark.frames import FITTED, bounds_cases, frame_cases, image_gradient_case, start_cases, step_cases
from verify.benchmark.timing import ROUNDS, load, numbers_by_calls
from verify.records import command

QUICK_SIDE = 1024
RATIOS = {
    **{f"{slow}_to_algebraic_{side}": (f"{case}_{side}_{threads}", f"algebraic_{side}_2")
       for slow, case, threads in (("numpy", "numpy", 2), ("seed", "seed_exact", 1), ("central", "central", 2))
       for side in (64, 256, 1024, 4096)},
    "seed_central_to_exact": ("seed_central_256_1", "seed_exact_256_1"),
    "eps_step_central_to_exact": ("eps_step_central_1024_2", "eps_step_exact_1024_2"),
    "a_alone_central_to_algebraic": ("a_alone_central_1024_1", "a_alone_algebraic_1024_1"),
    **{f"bounds_to_plain_{side}": (f"bounds_{side}", f"no_bounds_{side}") for side in (256, 1024)},
    "a_alone_central_to_general": ("a_alone_central_1024_1", "a_alone_general_1024_1"),
}  # fmt: skip
"""{number: (the case that takes so many times as long, as this case)}"""


def derived(numbers: Mapping[str, float]) -> dict[str, float]:
    """Return the ratios and exponents of {CASE_ms: milliseconds}, of those cases that were timed."""

    def time(case):
        return numbers[f"{case}_ms"]

    ratios = {}
    for name, (slow, fast) in RATIOS.items():
        with suppress(KeyError):
            ratios[name] = time(slow) / time(fast)
    for threads in (1, 2):
        with suppress(KeyError):
            times = [time(f"algebraic_{side}_{threads}") for side in FITTED]  # time ∝ pixels^p
            ratios[f"exponent_{threads}"] = float(np.polyfit(2 * np.log(FITTED), np.log(times), 1)[0])
    with suppress(KeyError):
        ratios["pixel_2048_to_1024"] = time("no_bounds_2048") / time("no_bounds_1024") / 4
    return ratios


def measure(rounds: int, quick: bool, only: str) -> dict[str, Any]:
    """Return the numbers of whole frames; only: of the cases whose name contains it."""
    before, rounds = load(), 1 if quick else rounds
    cases = [*frame_cases(QUICK_SIDE if quick else 2**24), *bounds_cases(), *step_cases()]
    cases += [image_gradient_case(), *start_cases()]
    cases = [replace(case, visits=min(rounds, case.visits)) for case in cases if only in case.name]
    if not cases:
        raise SystemExit(f"--only {only}: no case has that in its name")
    numbers = numbers_by_calls(cases, "frames")
    return {"numbers": numbers | derived(numbers) | {"load": before}}


main = partial(command, "frames", __doc__, measure, rounds=ROUNDS, quick=False, only="")

if __name__ == "__main__":
    main()
