"""The benchmark's machinery: turns, medians, the table's verdicts, the results' shape. No time is asserted."""

import json
from functools import partial

from verify.benchmark import __main__ as frames, timing
from verify.benchmark.timing import Case
from verify.evidence.records import read


def with_quartiles(numbers):
    """Return the names of the numbers of a run that have quartiles, which are in their order."""
    names = {key.removesuffix("_low") for key in numbers if key.endswith("_low")}
    assert all(0 < numbers[f"{key}_low"] <= numbers[key] <= numbers[f"{key}_high"] for key in names)
    return names


def test_cases_take_turns_forwards_and_backwards():
    """Each is called once before all, and a visit of several calls begins with one that is not timed."""
    order, times = [], {"a": (1, 3), "b": (2, 2), "c": (1, 1)}
    seconds = timing.timings([Case(name, partial(order.append, name), *times[name]) for name in times], "test")
    assert "".join(order) == "abc" + "abbbc" + "bbba" + "a"
    assert {name: len(calls) for name, calls in seconds.items()} == {"a": 3, "b": 4, "c": 1}


def test_a_small_run_writes_what_it_measured(tmp_path):
    frames.main(["--only", "algebraic_64", "--rounds", "2", "--output", str(tmp_path)])
    numbers = json.loads((tmp_path / "frames.json").read_text("utf-8"))["numbers"]
    assert set() < with_quartiles(numbers) <= with_quartiles(read("frames")["numbers"])
