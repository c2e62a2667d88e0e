"""sweep: the ε-table of one scene, or the table of a grid of frames."""

import logging
import os
from concurrent.futures import BrokenExecutor, CancelledError, ProcessPoolExecutor, ThreadPoolExecutor
from contextlib import contextmanager
from multiprocessing import get_context, parent_process
from signal import SIG_IGN, SIGINT, signal
from threading import Thread

from renderer import files
from renderer.checkpoint import Checkpoint
from renderer.command_line.options import (
    LISTED,
    add_raster,
    add_scene,
    number,
    progress_bar,
    scene_of,
    several,
    size_of,
    whole,
)
from renderer.facts import facts
from renderer.grid import COLUMNS, grid, records
from renderer.grid import run as run_grid
from renderer.grid import table as grid_table
from renderer.sweep import DECADES, sweep, table, write_csv
from renderer.threads import available_cores, checked_threads

DESCRIPTION = """Print the table of eps: a difference against the exact gradient, step by step. Lists of values, such as
--field sine,ridges --beta 0.1,0.35 --size 256,1024, make a grid of frames, a line each, computed by several workers."""


def add(verbs):
    """Add the verb's parser."""
    parser = verbs.add_parser("sweep", help="print the table of eps, or of a grid of frames", description=DESCRIPTION)
    parser.add_argument(
        "--eps", type=several(number), nargs="+", default=[DECADES], metavar="X", help="steps (default: 1e-1 … 1e-6)"
    )
    parser.add_argument(
        "--gradient", type=several(str), default=["central"], help="forward, central, central4 (default: central)"
    )
    parser.add_argument("--csv", metavar="FILE", help="write the table to a .csv too")
    parser.add_argument("--no-facts", dest="facts", action="store_false", help="print the table alone")
    group = parser.add_argument_group("many frames (of which each is drawn by --threads 1, unless you say)")
    group.add_argument(
        "--checkpoint", metavar="FILE", help="a .jsonl that keeps every result: a sweep that was killed goes on from it"
    )
    group.add_argument("--executor", choices=("threads", "processes"), help="workers here (default: threads)")
    group.add_argument("--workers", type=whole, metavar="N", help="how many of them (default: all cores)")
    group.add_argument("--dask", metavar="ADDRESS", help="workers of the Dask scheduler there, such as tcp://host:8786")
    add_raster(parser, lists=True)
    add_scene(parser, lists=True)


def run(options):
    """Compute, print, and write."""
    target = files.checked_target(options.csv, (".csv",), "csv") if options.csv else None
    steps = [step for steps in options.eps for step in steps]
    values = {name: getattr(options, name) for name in LISTED}
    scene = scene_of(options, **{name: value[0] for name, value in values.items()})
    sizes = [size_of(options, size) for size in options.size]
    tasks = grid(scene, sizes, options.gradient, steps, **values)
    asked = (options.checkpoint, options.executor, options.workers, options.dask)
    if len(tasks) > len(set(steps)) or any(choice is not None for choice in asked):
        _run_grid(options, tasks, target)
    else:
        _run_one(options, scene, sizes[0], steps, target)


def _run_one(options, scene, size, steps, target):
    """The ε-table of one scene, and the facts."""
    method = options.gradient[0]
    rows = sweep(scene, *size, steps, method, options.threads, lambda each: progress_bar(each, desc="eps"))
    print(f"{scene.field}, {scene.model}, {size[0]} x {size[1]}: {method} difference against the exact gradient")
    print(table(rows))
    if target:
        write_csv(target, rows)
        print(f"wrote {target}")
    if options.facts:
        print()
        for what, value in facts(scene, *size):
            print(f"{what + ' ':.<60} {value}")


def _run_grid(options, tasks, target):
    """The table of a grid of frames."""
    checkpoint = Checkpoint(options.checkpoint) if options.checkpoint else None

    def kept():
        if checkpoint is None:
            return "nothing is kept without --checkpoint"
        done = sum(task.key in checkpoint.rows for task in tasks)
        return f"{done} of {len(tasks)} frames are in {checkpoint.path}, and the same command goes on from there"

    def progress(results):
        return progress_bar(results, desc="frames", total=len(tasks), unit="frame")

    try:
        with _executor(options) as executor:
            results = run_grid(tasks, executor, checkpoint, options.threads or 1, progress)
    except KeyboardInterrupt:
        raise KeyboardInterrupt(kept()) from None
    except (BrokenExecutor, CancelledError):
        raise OSError(f"the workers are gone; {kept()}") from None
    print(grid_table(results))
    if target:
        files.write_csv(target, COLUMNS, records(results))
        print(f"wrote {target}")


@contextmanager
def _executor(options):
    if options.dask is not None:
        if options.executor is not None or options.workers is not None:
            raise ValueError(f"dask = {options.dask!r} is not allowed: no --executor and no --workers beside it")
        with _dask(options.dask) as executor:
            yield executor
        return
    workers = available_cores() if options.workers is None else checked_threads(options.workers, "workers")
    if options.executor == "processes":  # spawned: a fork of a process with threads may hang
        pool = ProcessPoolExecutor(workers, get_context("spawn"), initializer=_follow_the_parent)
    else:
        pool = ThreadPoolExecutor(workers)
    with pool:
        yield pool


def _follow_the_parent():
    """Leave Ctrl-C to the process that started this worker, and end when that is killed."""

    def follow():
        parent_process().join()
        os._exit(1)

    signal(SIGINT, SIG_IGN)
    Thread(target=follow, daemon=True).start()


@contextmanager
def _dask(address):
    """Yield the executor of a Dask cluster; what it would log is said in one line when it is the end of the sweep."""
    try:
        from distributed import Client, KilledWorker
    except ImportError:
        raise ValueError(f"dask = {address!r} is not allowed: the package `distributed` is not installed") from None
    logging.getLogger("distributed.client").setLevel(logging.CRITICAL)
    try:
        client = Client(address, timeout=10, set_as_default=False)
    except (ValueError, OSError) as error:
        raise ValueError(
            f"dask = {address!r} is not allowed: the address of a scheduler that answers ({error})"
        ) from None
    with client:
        try:
            yield client.get_executor()
        except KilledWorker as error:
            raise BrokenExecutor from error
