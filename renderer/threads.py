"""Bands of rows over threads: the compiled kernels release the interpreter's lock."""

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from threading import Condition
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
def _pool():
    """Return the helpers of every picture that this process draws: one for each core, begun when they are needed."""
    return ThreadPoolExecutor(available_cores(), thread_name_prefix="bands")


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_pool.cache_clear)  # a child has none of its parent's threads


class _Crew:
    """Those who are at work on the bands of one picture, and the errors that they met."""

    def __init__(self) -> None:
        self._change, self._at_work, self.errors = Condition(), 0, []  # type: ignore[var-annotated]

    def __enter__(self) -> None:
        with self._change:
            self._at_work += 1

    def __exit__(self, kind, error, trace):
        with self._change:
            self._at_work -= 1
            self.errors += [error] if error else []
            self._change.notify_all()
        return True

    def wait(self) -> None:
        """Return when nobody is at work."""
        with self._change:
            self._change.wait_for(lambda: not self._at_work)


def run_bands(work: Callable[[int], Any], count: int, threads: int) -> list[Any]:
    """Return [work(0), …, work(count − 1)], done on at most `threads` threads, this one included.

    Helpers that come late, or not at all because the process ends or the system has no more threads, are not waited
    for. An error of any of them is raised when all have stopped; after it, or an interrupt, nothing more is begun.
    """
    numbers, results, crew = iter(range(count)), [None] * count, _Crew()

    def take():
        with crew:
            try:
                for number in numbers:
                    results[number] = work(number)
            finally:
                for _ in numbers:
                    pass

    try:
        for _ in range(min(threads, count) - 1):
            _pool().submit(take)
    except RuntimeError:  # no new thread, or none any more
        pass
    take()
    crew.wait()
    if crew.errors:
        try:
            raise crew.errors[0]
        finally:
            crew.errors.clear()  # lest they keep this frame, and the picture's memory with it
    return results
