"""The verb sweep: the table of eps, of one frame or of a grid of frames, by threads here or workers elsewhere."""

import gc
import logging
from argparse import Namespace
from concurrent.futures import BrokenExecutor, CancelledError, ThreadPoolExecutor
from contextlib import contextmanager, nullcontext

from renderer.checks import extra, not_allowed
from renderer.command_line import grid
from renderer.command_line.options import progress_bar, scene_of, size_of
from renderer.picture.facts import facts
from renderer.picture.sweep import compared, table, write_csv
from renderer.scene.scene import MOVE_NO_BOUNDARY
from renderer.threads import checked_threads
from renderer.whole_files import checked_target


def print_sweep(options: Namespace) -> None:
    """Print the table of eps: a difference against the exact gradient, step by step.

    Lists of values, such as --field sine,ridges --beta 0.1,0.35 --size 256,1024, make a grid of frames, a line each,
    computed by several workers.
    """
    target = None if options.csv is None else checked_target(options.csv, (".csv",), "csv")
    lists = {name: vars(options).pop(name) for name in MOVE_NO_BOUNDARY if name in options}
    sizes = [size_of(options, size) for size in options.size]
    steps = [step for steps in options.eps for step in steps]
    tasks = grid.grid(scene_of(options), sizes, options.gradient, steps, **lists)
    of_one = len(tasks) == len(set(steps)) and {options.checkpoint, options.workers, options.dask} == {None}
    if of_one:
        scene, method, width, height = vars(tasks[0]).values()
        results = list(compared(progress_bar(desc="eps")(tasks), options.threads))
        print(f"{scene.field}, {scene.model}, {width} x {height}: {method.name} difference against the exact gradient")
    else:
        results = _of_grid(tasks, options)
    print(table(results))
    if target:
        write_csv(target, results)
        print(f"wrote {target}")
    if of_one and not options.no_facts:
        print()
        for name, value in facts(scene, width, height):
            print(f"{name + ' ':.<60} {value}")


def _of_grid(tasks, options):
    """Return the {Task: SweepRow} of a grid of frames, by workers; an error says how many the checkpoint keeps."""
    with nullcontext() if options.checkpoint is None else grid.Checkpoint(options.checkpoint) as checkpoint:
        try:
            with _workers(options) as executor:
                progress = progress_bar(desc="batches of frames", unit="batch")
                return grid.run(tasks, executor, checkpoint, options.threads or 1, progress)
        except (KeyboardInterrupt, BrokenExecutor, CancelledError) as stop:
            told = "nothing is kept without --checkpoint"
            if checkpoint:
                done = f"{len(checkpoint.rows_of(tasks))} of {len(tasks)} frames are in {checkpoint.path}"
                told = f"{done}, and the same command goes on from there"
            if isinstance(stop, KeyboardInterrupt):
                raise type(stop)(told) from None
            raise OSError(f"the workers are gone; {told}") from None


@contextmanager
def _workers(options):
    """Yield the executor that the options ask for: threads here, or a Dask cluster.

    Dask's log is silenced: an error that ends the sweep is one line.
    """
    if options.dask is None:
        with ThreadPoolExecutor(checked_threads(options.workers, "workers")) as executor:
            yield executor
        return
    if options.workers is not None:
        raise not_allowed("dask", options.dask, "no --workers beside it")
    try:
        with extra("dask"):
            from distributed import Client, KilledWorker
        logging.getLogger("distributed.client").setLevel(logging.CRITICAL)
        client, why = Client(options.dask, timeout=10, set_as_default=False), None
    except (ValueError, OSError) as error:
        why = error.with_traceback(None)
    if why:
        gc.collect()  # a client that found none closes itself: were it later, while another begins, both would wait
        raise not_allowed("dask", options.dask, f"the address of a scheduler that answers ({why})")
    with client:
        try:
            yield client.get_executor()
        except KilledWorker as error:
            raise BrokenExecutor from error
