"""The ε-table: how far a difference's picture is from the exact one, step by step."""

from collections.abc import Iterable, Iterator
from dataclasses import asdict, dataclass
from itertools import groupby
from pathlib import Path
from typing import Any

import numpy as np

from renderer import whole_files
from renderer.checks import check_choice, check_kind
from renderer.intervals import DIGITS, EVERY_DIGIT, certain_digits, rounded_up
from renderer.machines import at_points
from renderer.picture.differences import distance_from
from renderer.picture.drawing import render
from renderer.scene.fields import field_kernels
from renderer.scene.methods import DECADES, DIFFERENCES, GradientMethod, checked_method, difference, exact
from renderer.scene.raster import Raster
from renderer.scene.scene import MOVE_NO_BOUNDARY, Scene
from renderer.threads import checked_threads

HEADINGS = {"largest": "max |dI| on A", "rms": "RMS on A"}
"""{enclosed quantity: its heading}"""


@dataclass(frozen=True)
class Task:
    """A frame to compare with the exact one: a difference, and a raster's width and height. Raises ValueError."""

    scene: Scene
    method: GradientMethod
    width: int
    height: int

    def __post_init__(self):
        check_kind("scene", self.scene, Scene)
        Raster(self.width, self.height)
        check_choice("gradient", checked_method("gradient", self.method).name, DIFFERENCES)


@dataclass(frozen=True)
class SweepRow:
    """A row of the table, of one ε: the largest and the RMS difference over A's pixels and channels, the pixels whose
    chamber differs (flips), and those whose difference straddles a crease.

    The difference of the float64 picture from the exact one in real arithmetic lies between `_lower` and `_upper`.
    """

    eps: float
    largest: float
    rms: float
    flips: int
    straddling: int
    largest_lower: float
    largest_upper: float
    rms_lower: float
    rms_upper: float


Results = list[SweepRow] | dict[Task, SweepRow]


def compared(tasks: Iterable[Task], threads: int | None = None) -> Iterator[SweepRow]:
    """Yield the SweepRow of every Task, of which all share their chambers.

    The exact frame is drawn once a scene, on the first one's stage, with its bounds: it stands for the exact picture.
    A difference's frame stands for itself, rounding and all. It is drawn whole, so that flips are counted, not assumed.
    """
    stage, threads = None, checked_threads(threads)
    for _, of_scene in groupby(tasks, lambda task: task.scene):
        reference = distance = None
        for task in of_scene:
            raster = task.scene, task.width, task.height
            reference = reference or render(*raster, exact(), threads=threads, stage=stage, bounds=True)
            stage, distance = reference.stage, distance or distance_from(reference, [reference], threads)
            frame = render(*raster, task.method, threads=threads)
            largest, rms = distance(frame)
            flips = int(np.count_nonzero(frame.chambers != reference.chambers))
            straddling = frame.straddling.sum() if flips else _straddling(reference, task.method.eps).sum()
            eps: Any = task.method.eps  # None of the exact gradient alone, which no Task has
            ends = largest.lower, largest.upper, rms.lower, rms.upper
            yield SweepRow(eps, largest.value, rms.value, flips, int(straddling), *ends)


def _straddling(reference, eps):
    """Return 1 for each pixel of a frame's A whose step straddles a crease, else 0, by its chart, made once."""
    scene, data = reference.scene, reference.data_on_a
    kernel = field_kernels(scene.field)["straddling"]
    return at_points(kernel, data["u"], data["v"], scene.ku, scene.kv, eps)[0]


def sweep(
    scene: Scene,
    width: int,
    height: int,
    steps: Iterable[float] = DECADES,
    method: str = "central",
    threads: int | None = None,
) -> list[SweepRow]:
    """Return a SweepRow for every ε in `steps`: `method` against the exact gradient. Raises ValueError as `render`.

    >>> from renderer import Scene, records, sweep
    >>> [row["flips"] for row in records(sweep(Scene(field="sine"), 16, 16, [1e-2, 1e-3]))]
    [0, 0]
    """
    check_kind("steps", steps, Iterable, "a sequence of numbers")  # type: ignore[type-abstract]
    return list(compared([Task(scene, difference(method, eps), width, height) for eps in steps], threads))


def records(results: Results) -> list[dict[str, Any]]:
    """Return the rows of `sweep`, or the {Task: row} of `renderer.command_line.grid.run`, as dicts.

    >>> from renderer import Scene, records, sweep
    >>> [*records(sweep(Scene(), 8, 8, [1e-3]))[0]][:5]
    ['eps', 'largest', 'rms', 'flips', 'straddling']
    """
    if not isinstance(results, dict):
        return [asdict(row) for row in results]
    return [
        {name: getattr(task.scene, name) for name in MOVE_NO_BOUNDARY}
        | {"gradient": task.method.name, "width": task.width, "height": task.height}
        | asdict(row)
        for task, row in results.items()
    ]


def _with_certain_digits(record, digits, otherwise):
    """Return a record with each enclosed quantity as text: its certain digits, or `otherwise` of its upper end."""
    ends = {name: (record[f"{name}_lower"], record[f"{name}_upper"]) for name in HEADINGS}
    return record | {name: certain_digits(*ends[name], digits) or otherwise(ends[name][1]) for name in HEADINGS}


def table(results: Results) -> str:
    """Return the results, as `records` takes them, as text, a line each.

    Only certain digits: where none is, an upper bound.
    """
    texts = [_with_certain_digits(r, DIGITS, lambda upper: f"<= {rounded_up(upper)}") for r in records(results)]
    lines = [[HEADINGS.get(name, name) for name in _shown(record)] for record in texts[:1]]
    lines += [[f"{v:.4g}" if isinstance(v, float) else str(v) for v in _shown(record).values()] for record in texts]
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
    return "\n".join("  ".join(map(str.rjust, line, widths)) for line in lines)


def _shown(record):
    """Return a record without the intervals' ends, which the certain digits of its texts imply."""
    return {name: value for name, value in record.items() if not name.endswith(("_lower", "_upper"))}


def write_csv(path: str | Path, results: Results) -> None:
    """Write the results, as `records` takes them, with their column names.

    An enclosed quantity has its certain digits, or nothing, and its two ends in further columns.
    """
    rows = records(results)
    whole_files.write_csv(path, [_with_certain_digits(record, EVERY_DIGIT, lambda upper: "") for record in rows])
