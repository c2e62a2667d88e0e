"""A sweep over a grid of frames: fields × k × β × ε × method × raster, over any `concurrent.futures.Executor`.

Results survive the process in a checkpoint: a file of JSON lines, one a result, that is only ever appended to.
"""

import hashlib
import json
import os
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Executor, as_completed
from contextlib import AbstractContextManager
from dataclasses import asdict, replace
from functools import cache
from importlib import metadata
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np

from renderer.checks import not_allowed
from renderer.machines import machine
from renderer.picture.sweep import SweepRow, Task, compared
from renderer.scene.methods import difference
from renderer.scene.scene import Scene, geometry_of
from renderer.whole_files import checked_target, sole_writer

BATCH_TASKS, BATCH_PIXELS = (4, 16), 2**23  # what a worker is given at once, and what is lost if it is killed
_START = b'{"key": '


@cache
def version() -> str:
    """Return a hash of what computes a result: the renderer's sources, the machine that draws, NumPy, llvmlite.

    And what a field of one's own is derived by: the sources of the formulas, SymPy.
    """
    drawing, root = machine().NAME, Path(__file__).parents[2]  # llvmlite is loaded then, if it draws
    llvmlite = getattr(sys.modules.get("llvmlite"), "__version__", None)
    digest = hashlib.sha256(f"{drawing} {np.__version__} {llvmlite} {metadata.version('sympy')}".encode())
    for folder in ("renderer", "proofs/engine", "proofs/formulas"):
        for path in sorted((root / folder).rglob("*.py")):
            digest.update(path.relative_to(root).as_posix().encode() + path.read_bytes())
    return digest.hexdigest()


def _record(task):
    """Return what JSON can say of a Task."""
    return vars(task) | {"scene": task.scene.as_record(), "method": asdict(task.method)}


def key_of(task: Task) -> str:
    """Return a hash of a Task and of what computes it: equal keys, equal results."""
    return hashlib.sha256(json.dumps([_record(task), version()], sort_keys=True).encode()).hexdigest()


class Checkpoint(AbstractContextManager):
    """The results kept in a .jsonl file: `rows`, by the key of their task.

    A line is {"key": …, "task": …, "row": …}. A last line without an end (its writer was killed) is dropped. Raises
    ValueError if the file cannot be written, holds anything but results, or is written by another sweep. It is this
    one's until `close`, or the end of a `with`.
    """

    def __init__(self, path: str | Path):
        self.path = checked_target(path, (".jsonl",), "checkpoint")
        self.rows: dict[str, SweepRow] = {}
        try:
            self._own = sole_writer(self.path)
        except OSError as error:
            busy = isinstance(error, BlockingIOError)
            allowed = "one that no other sweep is writing" if busy else f"a file that can be written ({error.strerror})"
            raise not_allowed("checkpoint", str(self.path), allowed) from None
        try:
            self._read()
        except ValueError:
            self.close()
            raise

    def __exit__(self, *error: object) -> None:
        self.close()

    def close(self) -> None:
        """Let others write to the file, which is removed if nothing is kept in it."""
        if not self._own.closed and os.fstat(self._own.fileno()).st_size == 0:
            self.path.unlink(missing_ok=True)
        self._own.close()

    def _read(self):
        """Read the results, and drop a last line without an end."""
        content = self.path.read_bytes()
        *lines, torn = content.split(b"\n")
        for number, line in enumerate(lines, 1):
            try:
                record = json.loads(line)
                self.rows[record["key"]] = SweepRow(**record["row"])
            except (ValueError, KeyError, TypeError):
                raise self._none(number) from None
        if torn[: len(_START)] != _START[: len(torn)]:
            raise self._none(len(lines) + 1)
        if torn:
            os.truncate(self.path, len(content) - len(torn))

    def _none(self, number):
        return not_allowed("checkpoint", str(self.path), f"a file of results, and its line {number} is none")

    def kept(self, tasks: Iterable[Task]) -> dict[Task, SweepRow]:
        """Return {task: row} of those of the tasks that are kept."""
        keys = {task: key_of(task) for task in tasks}
        return {task: self.rows[key] for task, key in keys.items() if key in self.rows}

    def append(self, results: Mapping[Task, SweepRow]) -> None:
        """Keep {task: row}; when this returns, they are on the disk."""
        keys = {task: key_of(task) for task in results}
        lines = [{"key": keys[task], "task": _record(task), "row": asdict(row)} for task, row in results.items()]
        self._own.write("".join(json.dumps(line) + "\n" for line in lines).encode())
        self._own.flush()
        os.fsync(self._own.fileno())
        self.rows |= {keys[task]: row for task, row in results.items()}


def grid(
    scene: Scene,
    sizes: Iterable[tuple[int, int]],
    methods: Iterable[str],
    steps: Iterable[float],
    **values: Sequence[Any],
) -> list[Task]:
    """Return the Tasks of every combination, the steps fastest, none twice.

    sizes: (width, height) pairs. methods: names. steps: ε. values: lists of values by the name of the scene's field.
    """
    scenes = [replace(scene, **dict(zip(values, choice, strict=True))) for choice in product(*values.values())]
    differences = [difference(*choice) for choice in product(methods, steps)]
    return list(dict.fromkeys(Task(s, d, *size) for size in sizes for s in scenes for d in differences))


def batches(tasks: Iterable[Task]) -> list[list[Task]]:
    """Return the tasks in lists that share their chambers, in their order: 4 to 16 tasks, the fewer the larger."""
    groups: dict[tuple, list[Task]] = {}
    for task in tasks:
        groups.setdefault((geometry_of(task.scene), task.width, task.height), []).append(task)
    fewest, most = BATCH_TASKS
    parts: list[list[Task]] = []
    for (_, width, height), group in groups.items():
        size = max(fewest, min(most, BATCH_PIXELS // (width * height)))
        parts += [group[first : first + size] for first in range(0, len(group), size)]
    return parts


def compare_batch(batch: list[Task], made_by: str, threads: int = 1) -> dict[Task, SweepRow]:
    """Return {task: SweepRow} of a batch; what a worker does. Raises ValueError unless `made_by` is its own version."""
    if made_by != version():
        raise ValueError("a worker's renderer is not allowed: its sources, machine, NumPy or llvmlite differ")
    return dict(zip(batch, compared(batch, threads), strict=True))


def finished(
    tasks: list[Task], executor: Executor, checkpoint: Checkpoint | None = None, threads: int = 1
) -> Iterator[tuple[Task, SweepRow]]:
    """Yield (task, SweepRow) as they are finished: first what the Checkpoint has, then what the executor computes.

    Every batch is kept in the checkpoint before it is yielded. What has not been started when the generator is closed
    or a batch fails is cancelled. threads: for each frame.
    """
    kept = checkpoint.kept(tasks) if checkpoint else {}
    yield from kept.items()
    missing = batches(task for task in tasks if task not in kept)
    futures = [executor.submit(compare_batch, batch, version(), threads) for batch in missing]
    try:
        for future in as_completed(futures):
            if checkpoint:
                checkpoint.append(future.result())
            yield from future.result().items()
    finally:
        for future in futures:
            future.cancel()


def run(
    tasks: list[Task],
    executor: Executor,
    checkpoint: Checkpoint | None = None,
    threads: int = 1,
    progress: Callable[[Iterator], Iterable] = iter,
) -> dict[Task, SweepRow]:
    """Return {task: SweepRow} of `finished` in the order of the tasks; `progress` wraps the iterable."""
    rows = dict(progress(finished(tasks, executor, checkpoint, threads)))
    return {task: rows[task] for task in tasks}
