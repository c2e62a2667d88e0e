"""The plan of a run: which cases, how often, in which order.

Cases take turns: round after round, every second one backwards, so that a machine that slows down for a while slows
all of them. A case's time is the median over all its calls.
"""

import statistics
import time
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from tqdm import tqdm

ROUNDS = 9


@dataclass(frozen=True)
class Case:
    """One thing that is timed: `prepare`, called once, returns the function; `repeats` timed calls in each visit;
    `visits`: in how many rounds it takes part.
    """

    name: str
    prepare: Callable = field(compare=False)
    repeats: int = 1
    visits: int = ROUNDS

    @cached_property
    def work(self) -> Callable:
        """The prepared function."""
        return self.prepare()


def in_turns(cases: Collection[Case]) -> list[tuple[Case, int]]:
    """Return the visits [(case, round)]: each round goes once through the cases that are still due."""
    visits = []
    for number in range(max((case.visits for case in cases), default=0)):
        due = [(case, number) for case in cases if number < case.visits]
        visits += due if number % 2 == 0 else due[::-1]
    return visits


def timings(cases: Collection[Case], title: str) -> dict[str, list[float]]:
    """Time the cases in turns; return {name: seconds of every call}, the rounds one after another.

    A visit begins with a call that is not timed, which warms the caches, unless a call is so long that it is made once.
    """
    seconds: dict[str, list[float]] = {case.name: [] for case in cases}
    for case, _ in tqdm(in_turns(cases), desc=title, unit="visit"):
        work = case.work
        if case.repeats > 1:
            work()
        for _ in range(case.repeats):
            start = time.perf_counter()
            work()
            seconds[case.name].append(time.perf_counter() - start)
    return seconds


def medians(seconds: Mapping[str, Collection[float]]) -> dict[str, float]:
    """Return {name: median seconds of a call}."""
    return {name: statistics.median(calls) for name, calls in seconds.items()}


def least_of_rounds(calls: Sequence[float], repeats: int) -> np.ndarray:
    """Return the least of each round's calls: what else the machine does can only lengthen one."""
    return np.reshape(calls, (-1, repeats)).min(axis=1)


def with_quartiles(name: str, values: np.ndarray) -> dict[str, float]:
    """Return the median of the rounds' values by name, and their quartiles by NAME_low and NAME_high."""
    keys = (f"{name}_low", name, f"{name}_high")
    return dict(zip(keys, np.quantile(values, (0.25, 0.5, 0.75)).tolist(), strict=True))
