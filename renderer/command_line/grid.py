"""A sweep over a grid of frames: fields × k × β × ε × method × raster, over any `concurrent.futures.Executor`.

Results survive the process in a checkpoint: a file of JSON lines, one a result, that is only ever appended to.
"""

import hashlib
import json
import os
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
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

BATCH_TASKS = 8  # frames that a worker is given at once, and that are lost if it is killed


@cache
def version() -> str:
    """Return a hash of the sources and versions that compute a result: renderer, machine, formulas, libraries."""
    drawing, root = machine().NAME, Path(__file__).parents[2]  # llvmlite is loaded then, if it draws
    llvmlite = getattr(sys.modules.get("llvmlite"), "__version__", None)
    digest = hashlib.sha256(f"{drawing} {np.__version__} {llvmlite} {metadata.version('sympy')}".encode())
    for folder in ("renderer", "proofs/engine", "proofs/formulas"):
        for path in sorted((root / folder).rglob("*.py")):
            digest.update(path.relative_to(root).as_posix().encode() + path.read_bytes())
    return digest.hexdigest()


def _record(task):
    """Return a Task as a record for JSON."""
    return vars(task) | {"scene": task.scene.as_record(), "method": asdict(task.method)}


def key_of(task: Task) -> str:
    """Return a hash of a Task and of the version that computes it: equal keys, equal results."""
    return hashlib.sha256(json.dumps([_record(task), version()], sort_keys=True).encode()).hexdigest()


class Checkpoint(AbstractContextManager):
    """The results kept in a .jsonl file: `rows`, by the key of their task.

    A line is {"key": …, "task": …, "row": …}. A last line without an end (its writer was killed) is dropped. The file
    is this one's alone until the end of a `with`. Raises ValueError if it cannot be written, holds anything but
    results, or is written by another sweep.
    """

    def __init__(self, path: str | Path):
        self.path = checked_target(path, (".jsonl",), "checkpoint")
        try:
            self._file = sole_writer(self.path)
        except OSError as error:
            busy = isinstance(error, BlockingIOError)
            allowed = "one that no other sweep is writing" if busy else f"a file that can be written ({error.strerror})"
            raise not_allowed("checkpoint", str(self.path), allowed) from None
        try:
            self.rows = self._read()
        except (ValueError, KeyError, TypeError):
            self._file.close()
            raise not_allowed("checkpoint", str(self.path), "a file of results alone") from None

    def __exit__(self, *error: object) -> None:
        if not self._file.tell():
            self.path.unlink(missing_ok=True)
        self._file.close()

    def _read(self):
        """Return the results, and drop a last line without an end."""
        content = self.path.read_bytes()
        *lines, torn = content.split(b"\n")
        results = [json.loads(line) for line in lines]
        if not (torn.startswith(b'{"key": ') or b'{"key": '.startswith(torn)):
            raise ValueError
        if torn:
            os.truncate(self.path, len(content) - len(torn))
        return {line["key"]: SweepRow(**line["row"]) for line in results}

    def rows_of(self, tasks: Iterable[Task]) -> dict[Task, SweepRow]:
        """Return {task: row} of those of the tasks that are kept."""
        keys = {task: key_of(task) for task in tasks}
        return {task: self.rows[key] for task, key in keys.items() if key in self.rows}

    def append(self, results: Mapping[Task, SweepRow]) -> None:
        """Keep {task: row}; when this returns, they are on the disk."""
        for task, row in results.items():
            line = {"key": key_of(task), "task": _record(task), "row": asdict(row)}
            self._file.write(json.dumps(line).encode() + b"\n")
            self.rows[line["key"]] = row
        self._file.flush()
        os.fsync(self._file.fileno())


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
    """Return the tasks, in their order, in lists of at most BATCH_TASKS that share their chambers."""
    groups: dict[tuple, list[Task]] = {}
    for task in tasks:
        groups.setdefault((geometry_of(task.scene), task.width, task.height), []).append(task)
    return [group[i : i + BATCH_TASKS] for group in groups.values() for i in range(0, len(group), BATCH_TASKS)]


def compare_batch(batch: list[Task], made_by: str, threads: int = 1) -> dict[Task, SweepRow]:
    """Return {task: SweepRow} of a batch; a worker runs it. Raises ValueError unless `made_by` is its own version."""
    if made_by != version():
        raise ValueError("a worker's renderer is not allowed: its sources, machine, NumPy or llvmlite differ")
    return dict(zip(batch, compared(batch, threads), strict=True))


def run(
    tasks: list[Task],
    executor: Executor,
    checkpoint: Checkpoint | None = None,
    threads: int = 1,
    progress: Callable[..., Iterable] = lambda batches, total: batches,
) -> dict[Task, SweepRow]:
    """Return {task: SweepRow} in the order of the tasks: those of the Checkpoint, and those that the executor computes.

    Every batch is kept in the checkpoint as soon as it is finished. Where one fails, or is stopped, batches that have
    not been started are cancelled. threads: for each frame. progress: wraps the iterable of the finished batches,
    of which there are `total`.
    """
    rows = checkpoint.rows_of(tasks) if checkpoint else {}
    missing = batches(task for task in tasks if task not in rows)
    futures = [executor.submit(compare_batch, batch, version(), threads) for batch in missing]
    try:
        for future in progress(as_completed(futures), total=len(futures)):
            if checkpoint:
                checkpoint.append(future.result())
            rows |= future.result()
    finally:
        for future in futures:
            future.cancel()
    return {task: rows[task] for task in tasks}
