"""The benchmark's machinery: turns, medians, the table's verdicts, the results' shape. No time is asserted."""

import json
import math
from functools import partial
from unittest import mock

import numpy as np
import pytest

from verify.benchmark import __main__ as frames
from verify.benchmark import machines, own, texture, timing
from verify.benchmark.frames import FITTED, bounds_cases, frame_cases, image_gradient_case, start_cases, step_cases
from verify.benchmark.targets import TARGETS, derived, table
from verify.benchmark.timing import Case
from verify.records import read

MEASURED = {
    "frames": (frames, ["--only", "algebraic_64"], {"algebraic_64_1_ms", "algebraic_64_2_ms"}),
    "texture": (texture, [], {f"{way}_ns" for way in texture.ways()} | texture.RATIOS.keys()),
    "own": (
        own,
        [],
        {
            *(f"{case}_ms" for case in ("first_picture", "second_picture", "drawing", "png", "noisy_png")),
            "conversion_ms",
            "encoding_ms",
            *own.RATIOS,
        },
    ),
    "machines": (
        machines,
        [],
        {f"{m}_{how}_ms" for m in machines.MACHINES for how in machines.METHODS} | machines.RATIOS.keys(),
    ),
}
"""{record: (its run's module, what makes the run short, the numbers that carry quartiles)}"""


def with_quartiles(numbers):
    """Return the names of the numbers of a run that have quartiles, which are in their order."""
    names = [key.removesuffix("_low") for key in numbers if key.endswith("_low")]
    assert all(0 < numbers[f"{key}_low"] <= numbers[key] <= numbers[f"{key}_high"] for key in names)
    return {*names}


def test_cases_take_turns_forwards_and_backwards():
    """Each is called once before all, and a visit of several calls begins with one that is not timed."""
    seen = []
    cases = [
        Case(name, partial(seen.append, name), *times) for name, times in (("a", (1, 3)), ("b", (2, 2)), ("c", (1, 1)))
    ]
    seconds = timing.timings(cases, "test")
    assert "".join(seen) == "abc" + "abbbc" + "bbba" + "a"
    assert {name: len(calls) for name, calls in seconds.items()} == {"a": 3, "b": 4, "c": 1}


def test_a_time_is_that_of_the_call(monkeypatch):
    clock = iter([0, 1, 1, 10, 10, 12])
    monkeypatch.setattr(timing.time, "perf_counter", lambda: next(clock))
    assert timing.timings([Case("a", lambda: None, visits=3)], "test") == {"a": [1, 9, 2]}
    assert timing.with_quartiles("a", [0.5, 0.1, 0.2, 0.3, 0.4]) == pytest.approx(
        {"a_low": 0.2, "a": 0.3, "a_high": 0.4}
    )


@pytest.mark.parametrize(("factor", "quartiles"), [(1, [2, 2, 2]), (np.repeat([1, 2, 3, 4, 5], 4), [4, 6, 8])])
def test_a_ratio_is_taken_round_by_round(monkeypatch, factor, quartiles):
    """A round in which the machine is ten times slower, or a call that is interrupted, leaves the ratio as it was."""
    fast = np.repeat([1.0, 1.0, 10.0, 1.0, 1.0], 4)
    slow = 2 * fast
    slow[1] = 50.0
    monkeypatch.setattr(timing, "timings", lambda *_: {"slow": slow * factor, "fast": fast})
    cases = [Case(name, print, repeats=4, visits=5) for name in ("slow", "fast")]
    numbers = timing.numbers_by_rounds(cases, "test", {"ratio": ("slow", "fast")})
    assert [numbers[f"ratio{end}"] for end in ("_low", "", "_high")] == pytest.approx(quartiles)
    assert numbers["fast_ms"] == pytest.approx(1e3) and numbers["rounds"] == 5


def test_the_table_says_what_is_met():
    good = {key: bound for key, (_, _, bound, _) in TARGETS.items()}
    assert [line.endswith("  met") for line in table(good).splitlines()] == [False] + [True] * len(TARGETS)
    for number, (key, (what, relation, bound, _)) in enumerate(TARGETS.items(), start=1):
        for false in (bound + 1 if relation == "≤" else bound - 1, math.nan):
            lines = table(good | {key: false}).splitlines()
            assert [line.endswith("not met") for line in lines].index(True) == number
            assert what in lines[number] and f"{relation} {bound:,g}" in lines[number]
    assert table({}).count("not measured") == len(TARGETS)


def test_numbers_follow_from_medians():
    times = {f"algebraic_{side}_2_ms": 1e-5 * side**2 for side in FITTED} | {"numpy_1024_2_ms": 200.0}
    assert derived(times) == pytest.approx({"exponent_2": 1, "numpy_to_algebraic_1024": 200 / 10.48576})
    kept = read("frames")["numbers"]
    assert kept == pytest.approx(kept | {key: value for key, value in derived(kept).items() if key in kept})


def test_every_target_is_measured_by_a_case():
    cases = [*frame_cases(8192), *bounds_cases(), *step_cases(), image_gradient_case(), *start_cases()]
    times = dict.fromkeys((f"{case.name}_{case.unit}" for case in cases), 1.0)
    assert TARGETS.keys() <= derived(times).keys() | times.keys() | {"chambers_differing", "image_error"}


@pytest.mark.parametrize("name", MEASURED)
def test_a_small_run_writes_what_it_measured(name, tmp_path, monkeypatch):
    for measured in (machines, own):
        monkeypatch.setattr(measured, "SIDE", 32)
    module, short, wanted = MEASURED[name]
    module.main([*short, "--rounds", "2", "--output", str(tmp_path)])
    numbers = json.loads((tmp_path / f"{name}.json").read_text(encoding="utf-8"))["numbers"]
    assert with_quartiles(numbers) == wanted and with_quartiles(read(name)["numbers"])
    assert numbers["load"] >= 0 and numbers.get("rounds", 2) == 2 and numbers.get("differing", 0) == 0


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


def test_an_unknown_case_is_refused():
    with pytest.raises(SystemExit, match="nothing_of_that_name"):
        frames.main(["--only", "nothing_of_that_name"])
