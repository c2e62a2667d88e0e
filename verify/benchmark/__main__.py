"""Measure run time on this machine, print what was asked for against what was measured, and keep it with a label.

Two parts: `frames` (whole frames by every renderer, steps of a sweep, the command line's start) and `gradients` (the
gradient alone, time against error; other libraries where they are installed). A whole part is written to
verify/benchmark/results/PART.json, from which the book prints: commit it. Run it on a machine that does nothing else.
"""

import argparse
import contextlib
import datetime
import importlib.metadata
import json
import os
import sys
from pathlib import Path

from renderer.files import whole_file
from renderer.threads import available_cores
from verify.benchmark import agreement, gradients, image_gradient, start
from verify.benchmark.frames import frame_cases, step_cases
from verify.benchmark.numbers import frame_numbers
from verify.benchmark.plan import ROUNDS, Case, run
from verify.benchmark.rules import rule_cases, rule_numbers
from verify.benchmark.targets import table, verdicts

RESULTS = Path(__file__).parent / "results"
SCENES = 10**4
QUICK_SIDE, QUICK_SCENES = 1024, 100
BUSY = 0.5  # a load of more than this spoils a measurement


def label(report, *packages):
    """Return where, with what and when, from pytest-benchmark's report: machine, cores, versions, date, commit."""
    machine, commit = report["machine_info"], report["commit_info"]
    versions = ", ".join(f"{name} {importlib.metadata.version(name)}" for name in packages)
    processor = machine["cpu"].get("brand_raw") or machine["machine"]
    short = "unknown" if commit["id"] == "unversioned" else commit["id"][:7]
    return {
        "machine": f"{processor}, {available_cores()} cores, Python {machine['python_version']}, {versions}",
        "date": datetime.date.today().isoformat(),
        "commit": short + ("+" if commit["dirty"] else ""),
    }


def selected(cases, only, rounds):
    """Return the cases whose name contains `only`, with at most that many visits."""
    return [Case(c.name, c.prepare, c.repeats, min(rounds, c.visits)) for c in cases if only in c.name]


@contextlib.contextmanager
def one_core():
    """Let this process, and the threads that it starts in here, run on one core alone, where the system can do that."""
    if not hasattr(os, "sched_setaffinity"):
        yield
        return
    cores = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {max(cores)})
    try:
        yield
    finally:
        os.sched_setaffinity(0, cores)


def load():
    """Return how many processes wanted a core during the last minute, and say so if the machine is busy."""
    busy = os.getloadavg()[0] if hasattr(os, "getloadavg") else 0.0
    if busy > BUSY:
        print(f"this machine is busy (load {busy:.1f}): its times will be too long", file=sys.stderr)
    return busy


def measure_frames(only, rounds, quick):
    """Return (label, numbers) of whole frames; None if no case has that name."""
    cases = [
        *frame_cases(QUICK_SIDE if quick else 2**24),
        *step_cases(),
        *rule_cases(),
        image_gradient.CASE,
        *start.CASES,
    ]
    if not (cases := selected(cases, only, rounds)):
        return None
    times, report = run(cases, "frames")
    numbers = frame_numbers(times) | rule_numbers(times)
    if image_gradient.CASE.name in times:
        numbers["image_gradient_ns"] = 1e9 * times[image_gradient.CASE.name] / image_gradient.points()
    if not only:
        scenes = QUICK_SCENES if quick else SCENES
        numbers |= {"scenes": scenes, "chambers_differing": agreement.chambers_differing(scenes)}
        numbers |= {"image_error": agreement.image_error(), "sympy_imported": int(start.imports_sympy())}
    return label(report, "numpy", "llvmlite"), numbers | verdicts(numbers)


def measure_gradients(only, rounds, quick):
    """Return (label, numbers) of the gradient alone; None if no case has that name. It is quick anyway."""
    with one_core():
        functions, absent = gradients.available()
        cases = selected([gradients.gradient_case(*item) for item in functions.items()], only, rounds)
        if not cases:
            return None
        times, report = run(cases, "gradients")
        numbers = gradients.gradient_numbers(times, functions)
    if absent:
        print(f"left out, not installed: {', '.join(absent)}")
    libraries = [gradients.DISTRIBUTIONS.get(n, n) for n in times if n in gradients.LIBRARIES and n != "complex_step"]
    return label(report, "numpy", "llvmlite", *libraries), numbers | {"absent": ", ".join(absent) or "none"}


PARTS = {"frames": measure_frames, "gradients": measure_gradients}


def write(folder, part, where, numbers):
    """Write a part's result, whole or not at all."""
    folder.mkdir(parents=True, exist_ok=True)
    text = json.dumps({"label": where, "numbers": numbers}, indent=2, sort_keys=True, ensure_ascii=False)
    with whole_file(folder / f"{part}.json") as target:
        Path(target).write_text(text + "\n", encoding="utf-8")
    print(f"wrote {part}.json")


def show(part, where, numbers):
    """Print a part's numbers and, for frames, the table of targets."""
    print(f"\n{part}: {where['machine']}; {where['date']}, commit {where['commit']}")
    for key, value in sorted(numbers.items()):
        if not key.endswith(("_target", "_verdict")):
            print(f"  {key:36} {value:12.4g}" if isinstance(value, float) else f"  {key:36} {value!s:>12}")
    if part == "frames":
        print(f"\n{table(numbers)}")


def main(arguments=None):
    """Measure, print, and write whole parts."""
    parser = argparse.ArgumentParser(prog="python -m verify.benchmark", description=__doc__)
    parser.add_argument("--quick", action="store_true", help="one round, sides up to 1024; writes nothing by itself")
    parser.add_argument("--rounds", type=int, default=ROUNDS, metavar="N", help=f"at most N rounds (default: {ROUNDS})")
    parser.add_argument(
        "--only", default="", metavar="NAME", help="frames, gradients, or cases whose name contains NAME"
    )
    parser.add_argument("--output", type=Path, metavar="FOLDER", help="write the results there, whatever was measured")
    options = parser.parse_args(arguments)
    if options.rounds < 1:
        parser.error(f"--rounds {options.rounds} is not allowed: at least 1")
    rounds = 1 if options.quick else options.rounds
    parts = [options.only] if options.only in PARTS else list(PARTS)
    only = "" if options.only in PARTS else options.only
    before = load()
    found = {part: result for part in parts if (result := PARTS[part](only, rounds, options.quick))}
    if not found:
        parser.error(f"--only {options.only}: no case has that in its name")
    folder = options.output or (None if only or options.quick else RESULTS)
    for part, (where, numbers) in found.items():
        show(part, where, numbers)
        if folder:
            write(folder, part, where, numbers | {"load": before})


if __name__ == "__main__":
    sys.exit(main())
