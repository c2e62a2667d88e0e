"""The plan of a run: which cases, how often, in which order; run by pytest-benchmark.

Cases take turns: round after round, every second one backwards, so that a machine that slows down for a while slows
all of them. A case's time is the median over all its calls.
"""

import contextlib
import io
import json
import statistics
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import pytest
from tqdm import tqdm

HERE = Path(__file__).parent
ROUNDS = 9


@dataclass(frozen=True)
class Case:
    """One thing that is timed.

    name: identifier. prepare: returns the function to time; called once, before. repeats: timed calls in a visit.
    visits: in how many rounds it takes part.
    """

    name: str
    prepare: Callable = field(compare=False)
    repeats: int = 1
    visits: int = ROUNDS

    @cached_property
    def work(self):
        """The prepared function."""
        return self.prepare()


def in_turns(cases):
    """Return the visits [(case, round)]: each round goes once through the cases that are still due."""
    visits = []
    for number in range(max((case.visits for case in cases), default=0)):
        due = [(case, number) for case in cases if number < case.visits]
        visits += due if number % 2 == 0 else due[::-1]
    return visits


class Plan:
    """The pytest plugin that hands bench_case its visits and shows how far they are."""

    def __init__(self, cases, title):
        self.visits = in_turns(cases)
        self.bar = tqdm(total=len(self.visits), desc=title, unit="visit")

    def pytest_generate_tests(self, metafunc):
        ids = [f"{case.name}-{number}" for case, number in self.visits]
        metafunc.parametrize("case", [case for case, _ in self.visits], ids=ids)

    def pytest_runtest_logstart(self, nodeid):
        self.bar.set_postfix_str(nodeid.partition("[")[2].rstrip("]").ljust(24), refresh=True)

    def pytest_runtest_logfinish(self):
        self.bar.update()


def run(cases, title):
    """Time the cases in turns; return ({name: median seconds}, pytest-benchmark's report).

    Raises SystemExit with pytest's output if a case fails.
    """
    plan, output = Plan(cases, title), io.StringIO()
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.json"
        options = ["-q", "-p", "no:cacheprovider", "-p", "no:xdist", "-o", "python_functions=bench_*"]
        with contextlib.redirect_stdout(output), contextlib.redirect_stderr(output):
            status = pytest.main([str(HERE / "bench_case.py"), f"--benchmark-json={report}", *options], [plan])
        plan.bar.close()
        if status:
            raise SystemExit(f"{output.getvalue()}\n{title}: pytest ended with status {int(status)}")
        found = json.loads(report.read_text(encoding="utf-8"))
    return medians(found), found


def medians(report):
    """Return {case name: median seconds over all its calls in all its visits} of pytest-benchmark's report."""
    seconds = {}
    for visit in report["benchmarks"]:
        seconds.setdefault(visit["extra_info"]["case"], []).extend(visit["stats"]["data"])
    return {name: statistics.median(data) for name, data in seconds.items()}
