"""Bands of rows over threads: the compiled kernels release the interpreter's lock."""

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from typing import Any

from renderer.checks import check_whole

MAX_THREADS = 256


def available_cores() -> int:
    """Return how many cores this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def checked_threads(threads: int | None, name: str = "threads") -> int:
    """Return `threads`, all cores for None, or raise ValueError unless it is a whole number from 1 to MAX_THREADS.

    `name` is what the message calls it.
    """
    return available_cores() if threads is None else check_whole(name, threads, MAX_THREADS)


@cache
def _pool(threads):
    return ThreadPoolExecutor(threads, thread_name_prefix="bands")


def run_bands(work: Callable[[int], Any], count: int, threads: int) -> list[Any]:
    """Return [work(0), …, work(count − 1)], done on `threads` threads, this one included.

    An error of any of them is raised when all have stopped; after it, or an interrupt, nothing more is begun.
    """
    numbers, results = iter(range(count)), [None] * count

    def take():
        try:
            for number in numbers:
                results[number] = work(number)
        finally:
            for _ in numbers:
                pass

    helpers = [_pool(threads).submit(take) for _ in range(min(threads, count) - 1)]
    try:
        take()
    finally:
        for helper in helpers:
            helper.result()
    return results
