"""Measure run time on this machine, print what was asked for against what was measured, and keep it with a label.

Whole frames by every renderer, steps of a sweep, the command line's start. A whole run is written to
verify/benchmark/results/frames.json, from which the book prints: commit it. Run it on a machine that does nothing else.
The gradient alone is measured by `python -m verify.benchmark.work_precision`.
"""

import argparse
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from tqdm import tqdm

from renderer import exact
from verify.benchmark.frames import IMAGE_GRADIENT, SCENE, START_CASES, frame_cases, image_gradient_points, step_cases
from verify.benchmark.label import RESULTS, label, load, write
from verify.benchmark.plan import ROUNDS, timings, with_quartiles
from verify.benchmark.rules import rule_cases
from verify.benchmark.targets import derived, table
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


def measure_frames(only: str, rounds: int, quick: bool) -> dict[str, Any] | None:
    """Return the numbers of whole frames; None if no case has that name."""
    whole = frame_cases(QUICK_SIDE if quick else 2**24)
    cases = [*whole, *step_cases(), *rule_cases(), IMAGE_GRADIENT, *START_CASES]
    cases = [replace(case, visits=min(rounds, case.visits)) for case in cases if only in case.name]
    if not cases:
        return None
    numbers: dict[str, Any] = {}
    for name, seconds in timings(cases, "frames").items():
        unit, factor = ("s", 1.0) if name.startswith("start") else ("ms", 1e3)
        if name == IMAGE_GRADIENT.name:
            unit, factor = "ns", 1e9 / image_gradient_points()
        numbers |= with_quartiles(f"{name}_{unit}", factor * np.array(seconds))
    numbers |= derived(numbers)
    if not only:
        numbers |= counted(QUICK_SCENES if quick else SCENES)
    return numbers


def show(where: dict[str, str], numbers: dict[str, Any]) -> None:
    """Print the numbers, and the table of targets."""
    print(f"\n{where['machine']}; {where['date']}, commit {where['commit']}")
    for key, value in sorted(numbers.items()):
        print(f"  {key:36} {value:12.4g}" if isinstance(value, float) else f"  {key:36} {value!s:>12}")
    print(f"\n{table(numbers)}")


def main(arguments: list[str] | None = None) -> None:
    """Measure, print, and write a whole run."""
    parser = argparse.ArgumentParser(prog="python -m verify.benchmark", description=__doc__)
    parser.add_argument("--quick", action="store_true", help="one round, sides up to 1024; writes nothing by itself")
    parser.add_argument("--rounds", type=int, default=ROUNDS, metavar="N", help=f"at most N rounds (default: {ROUNDS})")
    parser.add_argument("--only", default="", metavar="NAME", help="cases whose name contains NAME")
    parser.add_argument("--output", type=Path, metavar="FOLDER", help="write the results there, whatever was measured")
    options = parser.parse_args(arguments)
    if options.rounds < 1:
        parser.error(f"--rounds {options.rounds} is not allowed: at least 1")
    rounds = 1 if options.quick else options.rounds
    before = load()
    numbers = measure_frames(options.only, rounds, options.quick)
    if not numbers:
        parser.error(f"--only {options.only}: no case has that in its name")
    where = label("numpy", "llvmlite")
    show(where, numbers)
    if folder := options.output or (None if options.only or options.quick else RESULTS):
        write(folder / "frames.json", {"label": where, "numbers": numbers | {"load": before}})
        print("wrote frames.json")


if __name__ == "__main__":
    main()
