"""Timing: round after round in turns, every second round backwards.

A machine that slows down for a while then slows all of them.
"""

import os
import sys
import time
from collections.abc import Callable, Collection
from dataclasses import dataclass

import numpy as np
from tqdm import tqdm

ROUNDS = 9
UNITS = {"s": 1.0, "ms": 1e3, "ns": 1e9}
BUSY = 0.5  # a load of more than this spoils a measurement


@dataclass(frozen=True)
class Case:
    """One thing that is timed: `repeats` calls of `work` in each visit; `visits`: in how many rounds it takes part.

    Its time is kept as NAME_UNIT, and is that of one of the `points` that a call takes, in seconds of the `clock`.
    """

    name: str
    work: Callable
    repeats: int = 1
    visits: int = ROUNDS
    unit: str = "ms"
    points: int = 1
    clock: Callable[[], float] = time.perf_counter


def load() -> float:
    """Return how many processes wanted a core during the last minute, and say so if the machine is busy."""
    busy = os.getloadavg()[0] if hasattr(os, "getloadavg") else 0.0
    if busy > BUSY:
        print(f"this machine is busy (load {busy:.1f}): its times will be too long", file=sys.stderr)
    return busy


def timings(cases: Collection[Case], title: str) -> dict[str, list[float]]:
    """Time the cases in turns; return {name: seconds of every call}, the rounds one after another.

    Each is called once before all, so that whatever is to be compiled is. A visit begins with a call that is not timed,
    which warms the caches, unless a call is so long that it is made once.
    """
    for case in tqdm(cases, desc=f"{title}, first calls", unit="case"):
        case.work()
    seconds: dict[str, list[float]] = {case.name: [] for case in cases}
    visits = []
    for number in range(max(case.visits for case in cases)):
        due = [case for case in cases if number < case.visits]
        visits += due[:: -1 if number % 2 else 1]
    for case in tqdm(visits, desc=title, unit="visit"):
        if case.repeats > 1:
            case.work()
        for _ in range(case.repeats):
            start = case.clock()
            case.work()
            seconds[case.name].append(case.clock() - start)
    return seconds


def ratios(numbers: dict[str, float], pairs: dict[str, tuple[str, str]]) -> dict[str, float]:
    """Return {name: one number divided by another}, where both were measured; pairs: {name: (the one, the other)}."""
    return {n: numbers[one] / numbers[other] for n, (one, other) in pairs.items() if {one, other} <= numbers.keys()}


def numbers_by_calls(cases: Collection[Case], title: str) -> dict[str, float]:
    """Time the cases; return {NAME_UNIT: the median of all calls}, and its quartiles by NAME_UNIT_low and _high."""
    seconds = timings(cases, title)
    numbers: dict[str, float] = {}
    for case in cases:
        name, times = f"{case.name}_{case.unit}", np.array(seconds[case.name]) * (UNITS[case.unit] / case.points)
        keys = (f"{name}_low", name, f"{name}_high")
        numbers |= dict(zip(keys, np.quantile(times, (0.25, 0.5, 0.75)).tolist(), strict=True))
    return numbers
