"""A sweep over a grid of frames: fields × k × β × ε × method × raster, over any `concurrent.futures.Executor`."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Executor, as_completed
from dataclasses import replace
from itertools import product
from typing import Any

from renderer.checkpoint import Checkpoint, version
from renderer.methods import difference
from renderer.numbers import geometry_of
from renderer.scene import Scene
from renderer.sweep import SweepRow, Task, compared

BATCH_TASKS, BATCH_PIXELS = (4, 16), 2**23  # what a worker is given at once, and what is lost if it is killed


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
    progress: Callable[[Iterator[tuple[Task, SweepRow]]], Iterable[tuple[Task, SweepRow]]] = iter,
) -> dict[Task, SweepRow]:
    """Return {task: SweepRow} of `finished` in the order of the tasks; `progress` wraps the iterable."""
    rows = dict(progress(finished(tasks, executor, checkpoint, threads)))
    return {task: rows[task] for task in tasks}
