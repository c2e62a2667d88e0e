"""The plan of a run: which cases, how often, in which order.

Cases take turns: round after round, every second one backwards, so that a machine that slows down for a while slows
all of them. A case's time is the median over all its calls.
"""

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
        """The prepared function, which has been called once, so that whatever is to be compiled is."""
        work = self.prepare()
        work()
        return work


def given(work: Callable) -> Callable[[], Callable]:
    """Return the `prepare` of a function that needs no preparation."""
    return lambda: work


def timings(cases: Collection[Case], title: str) -> dict[str, list[float]]:
    """Time the cases in turns; return {name: seconds of every call}, the rounds one after another.

    A visit begins with a call that is not timed, which warms the caches, unless a call is so long that it is made once.
    """
    seconds: dict[str, list[float]] = {case.name: [] for case in cases}
    visits = []
    for number in range(max(case.visits for case in cases)):
        due = [case for case in cases if number < case.visits]
        visits += due if number % 2 == 0 else due[::-1]
    for case in tqdm(visits, desc=title, unit="visit"):
        work = case.work
        if case.repeats > 1:
            work()
        for _ in range(case.repeats):
            start = time.perf_counter()
            work()
            seconds[case.name].append(time.perf_counter() - start)
    return seconds


def with_quartiles(name: str, values: Sequence[float] | np.ndarray) -> dict[str, float]:
    """Return the median of values by name, and their quartiles by NAME_low and NAME_high."""
    keys = (f"{name}_low", name, f"{name}_high")
    return dict(zip(keys, np.quantile(values, (0.25, 0.5, 0.75)).tolist(), strict=True))


def numbers_of(
    seconds: Mapping[str, Sequence[float]], repeats: int, unit: str, factor: float, ratios: Mapping[str, tuple]
) -> dict[str, float]:
    """Return {NAME_UNIT: seconds times factor} and {ratio: of the cases (slow, fast)} over the rounds, with quartiles.

    A round counts by the least of its `repeats` calls: what else the machine does can only lengthen one. A ratio is
    taken round by round.
    """
    rounds = {name: np.reshape(calls, (-1, repeats)).min(axis=1) for name, calls in seconds.items()}
    numbers: dict[str, float] = {}
    for name, least in rounds.items():
        numbers |= with_quartiles(f"{name}_{unit}", factor * least)
    for name, (slow, fast) in ratios.items():
        numbers |= with_quartiles(name, rounds[slow] / rounds[fast])
    return numbers
