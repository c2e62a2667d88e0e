"""Measure the same frame on each machine that draws in Python:

    python -m verify.benchmark.machines                  (seconds, on a machine that does nothing else)

LLVM's vectors and NumPy's rows, one thread, chambers given. The bits are the same, so that a frame's error is one on
both; the run counts the bytes that differ. Writes verify/benchmark/results/machines.json: commit it.
"""

from functools import cache, partial
from types import ModuleType
from typing import Any
from unittest import mock

import numpy as np

from renderer import Scene, central, exact, render
from renderer.machines import native, numpy_rows
from renderer.picture import stage
from renderer.picture.frame import Frame
from verify.benchmark.timing import Case, numbers_by_rounds
from verify.records import command

MACHINES = {"llvm": native, "numpy": numpy_rows}
METHODS = {"exact": exact(), "central": central(1e-3)}
RATIOS = {f"{name}_central_to_exact": (f"{name}_central", f"{name}_exact") for name in MACHINES}
SCENE, SIDE, ROUNDS, CALLS = Scene(field="sine"), 256, 15, 3


@cache
def _stage(side: int) -> stage.Stage:
    return render(SCENE, side, side).stage


def drawn_by(machine: ModuleType, method: str) -> Frame:
    """Return the frame, drawn on a machine by a method of METHODS."""
    with mock.patch.object(stage, "machine", lambda: machine):
        return render(SCENE, SIDE, SIDE, METHODS[method], threads=1, stage=_stage(SIDE))


def differing_bytes(method: str) -> int:
    """Return how many bytes of a frame differ between the machines."""
    one, other = (np.ascontiguousarray(drawn_by(machine, method).rgb).view(np.uint8) for machine in MACHINES.values())
    return int(np.count_nonzero(one != other))


def measure(rounds: int) -> dict[str, Any]:
    """Return the milliseconds of a frame by each machine and method, and their ratios."""
    cases = [Case(f"{name}_{method}", partial(drawn_by, machine, method), CALLS, rounds)
             for name, machine in MACHINES.items() for method in METHODS]  # fmt: skip
    numbers = numbers_by_rounds(cases, "machines", RATIOS)
    return {"numbers": numbers | {"side": SIDE, "differing": sum(map(differing_bytes, METHODS))}}


main = partial(command, "machines", __doc__, measure, rounds=ROUNDS)

if __name__ == "__main__":
    main()
