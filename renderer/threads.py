"""Bands of rows over threads: the compiled kernels release the interpreter's lock."""

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor, wait
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

    name: the argument's, in the message.
    """
    return available_cores() if threads is None else check_whole(name, threads, MAX_THREADS)


@cache
def _pool():
    """Return the helpers of every picture that this process draws: one for each core, begun when they are needed."""
    return ThreadPoolExecutor(available_cores(), thread_name_prefix="bands")


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_pool.cache_clear)  # a child has none of its parent's threads


def run_bands(work: Callable[[slice], Any], rows: int, each: int, threads: int | None) -> list[Any]:
    """Return the results of `work` on bands of rows, slices of `each` rows and a last one of the rest, in their order.

    It is done on at most `threads` threads (None: as many as cores), this one included.
    Helpers that come late, or not at all because the process ends or the system has no more threads, are not waited
    for. An error of any of them is raised when all have stopped; after it, or an interrupt, nothing more is begun.
    """
    bands = [slice(start, min(rows, start + each)) for start in range(0, rows, each)]
    if len(bands) == 1:
        return [work(*bands)]
    numbered, todo, results, helpers = enumerate(bands), [work], [None] * len(bands), []

    def take():
        try:
            for number, band in numbered:
                results[number] = todo[0](band)
        finally:
            for _ in numbered:
                pass

    try:
        for _ in range(min(threads or available_cores(), len(bands)) - 1):
            helpers.append(_pool().submit(take))
    except RuntimeError:  # no new thread, or none any more
        pass
    try:
        take()
    finally:
        at_work = [helper for helper in helpers if not helper.cancel()]
        wait(at_work)
        helpers.clear()
        answers = results.copy()
        for shared in (todo, results):  # a cancelled helper keeps them until a thread of the pool is free
            shared.clear()
    try:
        while at_work:
            at_work.pop().result()
    finally:
        at_work.clear()  # lest errors keep this frame, and the picture's memory with it
    return answers
