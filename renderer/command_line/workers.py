"""The workers of a sweep over a grid: threads or processes here, or those of a Dask cluster."""

import logging
import os
from argparse import Namespace
from concurrent.futures import BrokenExecutor, Executor, ProcessPoolExecutor, ThreadPoolExecutor
from contextlib import AbstractContextManager, contextmanager
from multiprocessing import get_context, parent_process
from signal import SIG_IGN, SIGINT, signal
from threading import Thread

from renderer.checks import extra, not_allowed
from renderer.threads import checked_threads


def executor_of(options: Namespace) -> AbstractContextManager[Executor]:
    """Return the executor that the options ask for, a context manager."""
    if options.dask is None:
        workers = checked_threads(options.workers, "workers")
        if options.executor == "processes":  # spawned: a fork of a process with threads may hang
            return ProcessPoolExecutor(workers, get_context("spawn"), initializer=_follow_the_parent)
        return ThreadPoolExecutor(workers)
    if options.executor is not None or options.workers is not None:
        raise not_allowed("dask", options.dask, "no --executor and no --workers beside it")
    return _dask(options.dask)


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
        with extra("dask"):
            from distributed import Client, KilledWorker
        logging.getLogger("distributed.client").setLevel(logging.CRITICAL)
        client = Client(address, timeout=10, set_as_default=False)
    except (ValueError, OSError) as error:
        raise not_allowed("dask", address, f"the address of a scheduler that answers ({error})") from None
    with client:
        try:
            yield client.get_executor()
        except KilledWorker as error:
            raise BrokenExecutor from error
