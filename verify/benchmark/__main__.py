"""Measure whole frames on this machine, and print what was asked for against what was measured:

    python -m verify.benchmark                           (some minutes, on a machine that does nothing else)
    python -m verify.benchmark --quick                   one round, sides up to 1024, 100 scenes
    python -m verify.benchmark --only NAME               cases whose name contains NAME

Whole frames by every renderer, steps of a sweep, the command line's start. Writes verify/benchmark/results/frames.json,
from which the book prints: commit it. The gradient alone is measured by `python -m verify.benchmark.work_precision`.
"""

from dataclasses import replace
from typing import Any

import numpy as np
from tqdm import tqdm

from renderer import exact
from verify.benchmark.frames import SCENE, bounds_cases, frame_cases, image_gradient_case, start_cases, step_cases
from verify.benchmark.targets import derived, table
from verify.benchmark.timing import ROUNDS, load, numbers_by_calls
from verify.records import command
from verify.strict import differing_pixels, image_error, random_raster, random_scene

SCENES, SEED = 10**4, 9
QUICK_SIDE, QUICK_SCENES = 1024, 100


def counted(scenes: int) -> dict[str, float]:
    """Return what the run also counts: whether the fast renderer draws what the strict one draws."""
    random = np.random.default_rng(SEED)
    drawn = ((random_scene(random), random_raster(random)) for _ in tqdm(range(scenes), desc="chambers", unit="scene"))
    differing = sum(differing_pixels(scene, *raster) for scene, raster in drawn)
    error = max(image_error(SCENE, 256, exact(form)) for form in ("algebraic", "general"))
    return {"scenes": scenes, "chambers_differing": differing, "image_error": error}


def measure(rounds: int, quick: bool, only: str) -> dict[str, Any]:
    """Return the numbers of whole frames; only: of the cases whose name contains it, and of nothing that is counted."""
    before, rounds = load(), 1 if quick else rounds
    cases = [*frame_cases(QUICK_SIDE if quick else 2**24), *bounds_cases(), *step_cases()]
    cases += [image_gradient_case(), *start_cases()]
    cases = [replace(case, visits=min(rounds, case.visits)) for case in cases if only in case.name]
    if not cases:
        raise SystemExit(f"--only {only}: no case has that in its name")
    numbers = numbers_by_calls(cases, "frames")
    numbers |= derived(numbers) | {"load": before}
    return {"numbers": numbers if only else numbers | counted(QUICK_SCENES if quick else SCENES)}


def main(arguments: list[str] | None = None) -> None:
    """Measure, print, write a whole run, and print the table of targets."""
    numbers = command("frames", __doc__, measure, arguments, rounds=ROUNDS, quick=False, only="")["numbers"]
    print(f"\n{table(numbers)}")


if __name__ == "__main__":
    main()
