"""Measure the same frame on each machine that draws in Python, and write it with a label:

    python -m verify.benchmark.machines                  (seconds, on a machine that does nothing else)

LLVM's vectors and NumPy's rows, one thread, chambers given. The bits are the same, so that a frame's error is one on
both; the run counts the bytes that differ. Writes verify/benchmark/results/machines.json: commit it.
"""

import argparse
from collections.abc import Callable
from functools import cache
from pathlib import Path
from types import ModuleType
from unittest import mock

import numpy as np

from renderer import Scene, central, exact, render, stage
from renderer.frame import Frame
from renderer.machines import native, numpy_rows
from verify.benchmark.__main__ import RESULTS, load
from verify.benchmark.frames import warmed
from verify.benchmark.label import label, write
from verify.benchmark.plan import Case, least_of_rounds, timings, with_quartiles

MACHINES = {"llvm": native, "numpy": numpy_rows}
METHODS = {"exact": exact(), "central": central(1e-3)}
SCENE, SIDE, ROUNDS, CALLS = Scene(field="sine"), 256, 15, 3


@cache
def _stage() -> stage.Stage:
    return render(SCENE, SIDE, SIDE).stage


def drawn_by(machine: ModuleType, method: str) -> Callable[[], Frame]:
    """Return the function that draws the frame on a machine by a method of METHODS."""

    def draw():
        with mock.patch.object(stage, "machine", lambda: machine):
            return render(SCENE, SIDE, SIDE, METHODS[method], threads=1, stage=_stage())

    return draw


def differing_bytes(method: str) -> int:
    """Return how many bytes of a frame differ between the machines."""
    one, other = (np.ascontiguousarray(drawn_by(machine, method)().rgb).view(np.uint8) for machine in MACHINES.values())
    return int(np.count_nonzero(one != other))


def main(arguments: list[str] | None = None) -> None:
    """Measure, print, write."""
    parser = argparse.ArgumentParser("python -m verify.benchmark.machines", description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=ROUNDS, help="timed rounds (default: %(default)s)")
    parser.add_argument("--output", type=Path, default=RESULTS, metavar="FOLDER", help="where the result is written")
    options = parser.parse_args(arguments)
    numbers: dict[str, float] = {"load": load(), "side": SIDE, "rounds": options.rounds}
    cases = [Case(f"{name}_{method}", warmed(drawn_by(machine, method)), CALLS, options.rounds)
             for name, machine in MACHINES.items() for method in METHODS]  # fmt: skip
    rounds = {name: least_of_rounds(calls, CALLS) for name, calls in timings(cases, "machines").items()}
    for name, least in rounds.items():
        numbers |= with_quartiles(f"{name}_ms", 1e3 * least)
    for name in MACHINES:
        numbers |= with_quartiles(f"{name}_central_to_exact", rounds[f"{name}_central"] / rounds[f"{name}_exact"])
    numbers["differing"] = sum(map(differing_bytes, METHODS))
    print("\n".join(f"  {name:32} {value:8.3g}" for name, value in numbers.items()))
    write(options.output / "machines.json", {"label": label("numpy", "llvmlite"), "numbers": numbers})


if __name__ == "__main__":
    main()
