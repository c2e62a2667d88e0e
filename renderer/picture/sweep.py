"""The ε-table: how far a difference's picture is from the exact one, step by step."""

from collections.abc import Iterable, Iterator
from dataclasses import asdict, dataclass
from itertools import groupby
from pathlib import Path
from typing import Any

import numpy as np

from renderer import whole_files
from renderer.checks import check_choice
from renderer.picture.drawing import render
from renderer.picture.frame import Frame
from renderer.scene.methods import DIFFERENCES, GradientMethod, difference, exact
from renderer.scene.raster import Raster
from renderer.scene.scene import Scene

DECADES = (1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6)
MOVE_NO_BOUNDARY = ("field", "ku", "kv", "beta")
HEADINGS = {"largest": "max |dI| on A", "rms": "RMS on A"}


@dataclass(frozen=True)
class Task:
    """A frame to compare with the exact one: a difference, and a raster's width and height. Raises ValueError."""

    scene: Scene
    method: GradientMethod
    width: int
    height: int

    def __post_init__(self):
        Raster(self.width, self.height)
        check_choice("gradient", self.method.name, DIFFERENCES)


@dataclass(frozen=True)
class SweepRow:
    """One ε: the largest and the RMS difference over A's pixels and channels, the pixels whose chamber differs
    (flips), the pixels whose difference straddles a crease."""

    eps: float
    largest: float
    rms: float
    flips: int
    straddling: int


Results = list[SweepRow] | dict[Task, SweepRow]


def difference_on_a(frame: Frame, reference: Frame) -> np.ndarray:
    """Return the differences of two frames of one raster on sphere A: (pixels, 3)."""
    return (frame.rgb - reference.rgb)[reference.stage.on_a]


def rms(values: np.ndarray) -> float:
    """Return the root of the mean square, 0 of nothing."""
    return float(np.sqrt(np.mean(np.square(values)))) if values.size else 0.0


def compared(tasks: Iterable[Task], threads: int | None = None) -> Iterator[SweepRow]:
    """Yield the SweepRow of every Task, of which all share their chambers.

    The exact frame is drawn once a scene, on the first one's stage; a difference's frame is drawn whole, so that flips
    are counted, not assumed.
    """
    stage = None
    for _, of_scene in groupby(tasks, lambda task: task.scene):
        reference = None
        for task in of_scene:
            raster = task.scene, task.width, task.height
            reference = reference or render(*raster, exact(), threads=threads, stage=stage)
            stage = reference.stage
            frame = render(*raster, task.method, threads=threads)
            delta = difference_on_a(frame, reference)
            flips = int(np.count_nonzero(frame.chambers != reference.chambers))
            eps: Any = task.method.eps  # None of the exact gradient alone, which no Task has
            yield SweepRow(eps, float(np.abs(delta).max(initial=0.0)), rms(delta), flips, int(frame.straddling.sum()))


def sweep(
    scene: Scene,
    width: int,
    height: int,
    steps: Iterable[float] = DECADES,
    method: str = "central",
    threads: int | None = None,
) -> list[SweepRow]:
    """Return a SweepRow for every ε in `steps`: `method` against the exact gradient."""
    return list(compared([Task(scene, difference(method, eps), width, height) for eps in steps], threads))


def records(results: Results) -> list[dict[str, Any]]:
    """Return the rows of `sweep`, or the {Task: row} of `renderer.command_line.grid.run`, as dicts."""
    if not isinstance(results, dict):
        return [asdict(row) for row in results]
    return [
        {name: getattr(task.scene, name) for name in MOVE_NO_BOUNDARY}
        | {"gradient": task.method.name, "width": task.width, "height": task.height}
        | asdict(row)
        for task, row in results.items()
    ]


def table(results: Results) -> str:
    """Return the results, as `records` takes them, as text: a line each."""
    found = records(results)
    lines = [[HEADINGS.get(name, name) for name in record] for record in found[:1]]
    lines += [[f"{value:.4g}" if isinstance(value, float) else str(value) for value in r.values()] for r in found]
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
    return "\n".join("  ".join(map(str.rjust, line, widths)) for line in lines)


def write_csv(path: str | Path, results: Results) -> None:
    """Write the results, as `records` takes them, with their column names."""
    whole_files.write_csv(path, records(results))
