"""The benchmark's machinery: turns, medians, the table's verdicts, the results' shape. No time is asserted."""

import json
import math
from functools import partial
from unittest import mock

import numpy as np
import pytest

from verify.benchmark import __main__ as frames, machines, own, texture, timing
from verify.benchmark.targets import TARGETS, table
from verify.benchmark.timing import Case
from verify.records import read

RUNS = {
    "frames": (frames, ["--only", "algebraic_64"]),
    "texture": (texture, []),
    "own": (own, []),
    "machines": (machines, []),
}
"""{record: (its run's module, what makes the run short)}"""


def with_quartiles(numbers):
    """Return the names of the numbers of a run that have quartiles, which are in their order."""
    names = {key.removesuffix("_low") for key in numbers if key.endswith("_low")}
    assert all(0 < numbers[f"{key}_low"] <= numbers[key] <= numbers[f"{key}_high"] for key in names)
    return names


def test_cases_take_turns_forwards_and_backwards():
    """Each is called once before all, and a visit of several calls begins with one that is not timed."""
    seen, times = [], {"a": (1, 3), "b": (2, 2), "c": (1, 1)}
    seconds = timing.timings([Case(name, partial(seen.append, name), *times[name]) for name in times], "test")
    assert "".join(seen) == "abc" + "abbbc" + "bbba" + "a"
    assert {name: len(calls) for name, calls in seconds.items()} == {"a": 3, "b": 4, "c": 1}


def test_a_ratio_is_taken_round_by_round(monkeypatch):
    """A round in which the machine is ten times slower, or a call that is interrupted, leaves the ratio as it was."""
    fast = np.repeat([1.0, 1.0, 10.0, 1.0, 1.0], 4)
    slow = 2 * np.repeat([1, 2, 3, 4, 5], 4) * fast
    slow[1] = 50.0
    monkeypatch.setattr(timing, "timings", lambda *_: {"slow": slow, "fast": fast})
    cases = [Case(name, print, repeats=4, visits=5) for name in ("slow", "fast")]
    numbers = timing.numbers_by_rounds(cases, "test", {"ratio": ("slow", "fast")})
    assert [numbers[f"ratio{end}"] for end in ("_low", "", "_high")] == pytest.approx([4, 6, 8])
    assert numbers["fast_ms"] == pytest.approx(1e3) and numbers["rounds"] == 5


def test_the_table_says_what_is_met():
    good = {key: bound for key, (_, _, bound, _) in TARGETS.items()}
    assert table(good).count("  met") == table({}).count("not measured") == len(TARGETS)
    for key, (_, relation, bound, _) in TARGETS.items():
        for false in (bound + 1 if relation == "≤" else bound - 1, math.nan):
            assert table(good | {key: false}).count("not met") == 1


@pytest.mark.parametrize("name", RUNS)
def test_a_small_run_writes_what_it_measured(name, tmp_path, monkeypatch):
    for measured in (machines, own):
        monkeypatch.setattr(measured, "SIDE", 32)
    module, short = RUNS[name]
    module.main([*short, "--rounds", "2", "--output", str(tmp_path)])
    numbers = json.loads((tmp_path / f"{name}.json").read_text("utf-8"))["numbers"]
    assert set() < with_quartiles(numbers) <= with_quartiles(read(name)["numbers"])
    assert numbers.get("rounds", 2) == 2 and numbers.get("differing", 0) == 0


def test_a_machine_that_draws_other_bits_is_seen(monkeypatch):
    def drawer(want, job):
        draw = machines.native.drawer(want, job)

        def wrong(rows):
            counted = draw(rows)
            job["red"][:] *= 1 + 2**-50
            return counted

        return wrong

    monkeypatch.setattr(machines, "SIDE", 32)
    monkeypatch.setitem(machines.MACHINES, "numpy", mock.Mock(drawer=drawer, NAME="other"))
    assert machines.differing_bytes("exact") > 0
