"""A sweep over a grid of frames: fields × k × β × ε × method × raster, over any `concurrent.futures.Executor`."""

import hashlib
import json
import sys
from concurrent.futures import as_completed
from dataclasses import asdict, dataclass, replace
from functools import cache, cached_property
from itertools import groupby, product
from pathlib import Path

import numpy as np

from renderer.drawing import render, stage_of
from renderer.methods import GradientMethod, exact
from renderer.raster import Raster
from renderer.scene import Scene
from renderer.sweep import SweepRow, compare

MOVE_NO_BOUNDARY = ("field", "ku", "kv", "beta")
BATCH_TASKS, BATCH_PIXELS = (4, 16), 2**23  # what a worker is given at once, and what is lost if it is killed
COLUMNS = (*MOVE_NO_BOUNDARY, "gradient", "width", "height", *SweepRow.__dataclass_fields__)


@cache
def version():
    """Return a hash of what computes a result: the renderer's sources, NumPy's version and, if it draws, Numba's."""
    numba = sys.modules.get("numba")
    digest = hashlib.sha256(f"{np.__version__} {numba.__version__ if numba else 'NumPy draws'}".encode())
    for path in sorted(Path(__file__).parent.glob("*.py")):
        digest.update(path.name.encode() + path.read_bytes())
    return digest.hexdigest()


def _check_difference(name):
    if name == "exact":
        raise ValueError("gradient = 'exact' is not allowed: one of 'forward', 'central', 'central4'")


@dataclass(frozen=True)
class Task:
    """A frame to compare with the exact one: a scene, a difference, the width and height of the raster.

    Raises ValueError that names what is not allowed.
    """

    scene: Scene
    method: GradientMethod
    width: int
    height: int

    def __post_init__(self):
        Raster(self.width, self.height)
        _check_difference(self.method.name)

    @cached_property
    def key(self):
        """A hash of the task and of what computes it: equal keys, equal results."""
        return hashlib.sha256(json.dumps([asdict(self), version()], sort_keys=True).encode()).hexdigest()


def grid(scene, sizes, methods, steps, **values):
    """Return the Tasks of every combination, the steps fastest, none twice.

    sizes: (width, height) pairs. methods: names. steps: ε. values: lists of values by the name of the scene's field.
    """
    for name in methods:
        _check_difference(name)
    scenes = [replace(scene, **dict(zip(values, choice, strict=True))) for choice in product(*values.values())]
    differences = [GradientMethod(*choice) for choice in product(methods, steps)]
    return list(dict.fromkeys(Task(s, d, *size) for size in sizes for s in scenes for d in differences))


def batches(tasks):
    """Return the tasks in lists that share their chambers, in their order: 4 to 16 tasks, the fewer the larger."""
    groups, flat = {}, Scene()
    for task in tasks:
        bodies = replace(task.scene, **{name: getattr(flat, name) for name in MOVE_NO_BOUNDARY})
        groups.setdefault((bodies, task.width, task.height), []).append(task)
    fewest, most = BATCH_TASKS
    parts = []
    for (_, width, height), group in groups.items():
        size = max(fewest, min(most, BATCH_PIXELS // (width * height)))
        parts += [group[first : first + size] for first in range(0, len(group), size)]
    return parts


def compare_batch(batch, made_by, threads=1):
    """Return the SweepRow of every task of a batch; what a worker does.

    The exact frames share one Stage; the differences of a scene share one that is made anew for the scene, so that
    flips are counted, not assumed. Raises ValueError unless `made_by` is this worker's own version.
    """
    if made_by != version():
        raise ValueError("a worker's renderer is not allowed: its sources, NumPy or Numba are of another version")
    size, rows = (batch[0].width, batch[0].height), []
    shared = stage_of(batch[0].scene, *size, threads=threads)
    for scene, tasks in groupby(batch, lambda task: task.scene):
        reference = render(scene, *size, exact(), threads=threads, stage=shared)
        own, frame = stage_of(scene, *size, threads=threads), None
        for task in tasks:
            frame = render(scene, *size, task.method, threads=threads, stage=own, into=frame)
            rows.append(compare(frame, reference))
    return rows


def finished(tasks, executor, checkpoint=None, threads=1):
    """Yield (task, SweepRow) as they are finished: first what the Checkpoint has, then what the executor computes.

    Every batch is kept in the checkpoint before it is yielded. What has not been started when the generator is closed
    or a batch fails is cancelled.
    """
    kept = checkpoint.rows if checkpoint else {}
    yield from [(task, kept[task.key]) for task in tasks if task.key in kept]
    missing = batches(task for task in tasks if task.key not in kept)
    futures = {executor.submit(compare_batch, batch, version(), threads): batch for batch in missing}
    try:
        for future in as_completed(futures):
            batch, rows = futures[future], future.result()
            if checkpoint:
                checkpoint.append(batch, rows)
            yield from zip(batch, rows, strict=True)
    finally:
        for future in futures:
            future.cancel()


def run(tasks, executor, checkpoint=None, threads=1, progress=iter):
    """Return {task: SweepRow} in the order of the tasks; `progress` wraps the iterable of finished ones.

    executor: any `concurrent.futures.Executor`. checkpoint: a Checkpoint; what it has is not computed again.
    threads: for each frame.
    """
    rows = dict(progress(finished(tasks, executor, checkpoint, threads)))
    return {task: rows[task] for task in tasks}


def records(results):
    """Return the results of `run` as dicts by COLUMNS."""
    return [
        {name: getattr(task.scene, name) for name in MOVE_NO_BOUNDARY}
        | {"gradient": task.method.name, "width": task.width, "height": task.height}
        | asdict(row)
        for task, row in results.items()
    ]


def table(results):
    """Return the results as text, a line a frame."""
    lines = [
        f"{'field':8} {'ku':>7} {'kv':>7} {'beta':>9} {'gradient':9} {'raster':>11} {'eps':>8} {'max |dI| on A':>14} "
        f"{'RMS on A':>11} {'flips':>6} {'straddling':>10}"
    ]
    for r in records(results):
        raster = f"{r['width']}x{r['height']}"
        lines.append(
            f"{r['field']:8} {r['ku']:7g} {r['kv']:7g} {r['beta']:9g} {r['gradient']:9} {raster:>11} {r['eps']:8.1e} "
            f"{r['largest']:14.4g} {r['rms']:11.4g} {r['flips']:6d} {r['straddling']:10d}"
        )
    return "\n".join(lines)
