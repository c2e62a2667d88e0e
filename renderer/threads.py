"""Bands of rows over threads: the compiled kernels release the interpreter's lock."""

import os
import threading
from concurrent.futures import ThreadPoolExecutor
from functools import cache

import numpy as np

_own = threading.local()


def scratch(name, shape, kind=np.float64):
    """Return this thread's own array of that name, shape and kind; its content is whatever was left there.

    Memory fresh from the system costs more to touch than the kernels cost to run, so it is kept.
    """
    arrays = _own.__dict__.setdefault("arrays", {})
    if name not in arrays or arrays[name].shape != shape:
        arrays[name] = np.empty(shape, kind)
    return arrays[name]


MAX_THREADS = 256


def available_cores():
    """Return how many cores this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def checked_threads(threads, name="threads"):
    """Return `threads`, all cores for None, or raise ValueError unless it is a whole number from 1 to MAX_THREADS.

    `name` is what the message calls it.
    """
    if threads is None:
        return available_cores()
    if not isinstance(threads, int) or isinstance(threads, bool) or not 1 <= threads <= MAX_THREADS:
        raise ValueError(f"{name} = {threads!r} is not allowed: a whole number from 1 to {MAX_THREADS}")
    return threads


@cache
def _pool(threads):
    return ThreadPoolExecutor(threads, thread_name_prefix="bands")


def run_bands(work, count, threads):
    """Call work(0), …, work(count − 1) on `threads` threads, this one included, and return when all are done."""
    numbers = iter(range(count))

    def take():
        for number in numbers:
            work(number)

    helpers = [_pool(threads).submit(take) for _ in range(min(threads, count) - 1)]
    try:
        take()
    finally:
        for _ in numbers:  # after an interruption or an error nothing more is begun
            pass
        for helper in helpers:
            helper.result()
