"""The benchmark's machinery: turns, medians, the table's verdicts, the results' shape. No time is asserted."""

import json
import math
import subprocess
import sys
from functools import partial
from pathlib import Path

import pytest

from renderer import Scene, exact
from verify.benchmark import __main__ as benchmark
from verify.benchmark import plan, rules
from verify.benchmark.frames import FITTED, frame_cases, step_cases
from verify.benchmark.plan import Case, in_turns
from verify.benchmark.targets import TARGETS, Target, frame_numbers, spreads, table

RESULTS = Path(benchmark.RESULTS)


def good_numbers():
    """Return numbers that meet every target, each on its bound."""
    return {t.key: t.high if math.isfinite(t.high) else t.low for t in TARGETS}


def a_case(name, visits):
    return Case(name, lambda: None, visits=visits)


def test_cases_take_turns_forwards_and_backwards():
    visits = in_turns([a_case("a", 3), a_case("b", 2), a_case("c", 1)])
    assert [f"{case.name}{number}" for case, number in visits] == ["a0", "b0", "c0", "b1", "a1", "a2"]
    assert in_turns([]) == []


@pytest.mark.parametrize("rule", rules.RULES)
def test_a_picture_is_drawn_without_each_rule(rule, monkeypatch):
    """What takes a rule away replaces a function of the renderer: it must still take what that function is given."""
    monkeypatch.setattr(rules, "SIDE", 8)
    rules.prepare(Scene(beta=0.2), exact(), rules.RULES[rule])()


def test_a_time_is_the_median_of_all_calls(monkeypatch):
    """Calls of 1, 9 and 2 s, in three visits; a visit of several calls begins with one that is not timed."""
    clock, seen = iter([0, 1, 1, 10, 10, 12]), []
    monkeypatch.setattr(plan.time, "perf_counter", lambda: next(clock))
    seconds = plan.timings([Case("a", lambda: partial(seen.append, "a"), visits=3)], "test")
    assert plan.medians(seconds) == {"a": 2} and seconds == {"a": [1, 9, 2]}
    assert seen == ["a"] * 3
    monkeypatch.undo()
    made = []
    plan.timings([Case("b", lambda: made.append(1) or partial(seen.append, "b"), 2, 2)], "test")
    assert seen == ["a"] * 3 + ["b"] * 6 and made == [1]  # prepared once


@pytest.mark.parametrize("target", TARGETS, ids=lambda target: target.key)
def test_a_false_number_is_not_met(target):
    good = good_numbers()
    assert target.verdict(good)[1] == "met"
    for false in (target.high + 1, target.low - 1, math.nan):
        if not math.isinf(false):
            assert target.verdict(good | {target.key: false})[1] == "not met"
    assert target.verdict({})[1] == "not measured"


def test_the_table_says_what_is_not_met():
    good, target = good_numbers(), TARGETS[0]
    assert "not met" not in table(good)
    lines = table(good | {target.key: 2 * target.high}).splitlines()
    assert [line.endswith("not met") for line in lines] == [False, True] + [False] * (len(TARGETS) - 1)
    assert all(text in lines[1] for text in (target.what, "≤ 9 ms", "18 ms"))
    assert table({}).count("not measured") == len(TARGETS)


@pytest.mark.parametrize(
    ("target", "text"),
    [
        (Target("k", "w", high=2, form="{} ms"), "≤ 2 ms"),
        (Target("k", "w", low=3), "≥ 3"),
        (Target("k", "w", 1.05, 0.95, "{:.2f}"), "0.95 to 1.05"),
        (Target("k", "w", 0, 0), "0"),
    ],
)
def test_a_target_in_words(target, text):
    assert target.text == text


def test_numbers_follow_from_medians():
    times = {f"algebraic_{side}_2": 1e-8 * side**2 for side in FITTED}
    times |= {"numpy_1024_2": 0.2, "seed_exact_256_1": 4.0, "start_one_picture": 0.5}
    numbers = frame_numbers(times)
    assert numbers["exponent_2"] == pytest.approx(1)
    assert numbers["algebraic_1024_2_ms"] == pytest.approx(10.48576)
    assert numbers["numpy_to_algebraic_1024"] == pytest.approx(0.2 / 0.01048576)
    assert numbers["seed_to_algebraic_256"] == pytest.approx(4 / 0.00065536)
    assert numbers["start_one_picture_s"] == 0.5
    assert "exponent_1" not in numbers


def test_a_time_carries_its_quartiles():
    seconds = {"a": [0.5, 0.1, 0.2, 0.3, 0.4], "start_b": [1.0, 2.0, 3.0], "once": [1.0]}
    assert spreads(seconds) == pytest.approx(
        {"a_ms_low": 200, "a_ms_high": 400, "start_b_s_low": 1.5, "start_b_s_high": 2.5}
    )


def test_every_target_is_measured_by_a_case():
    times = dict.fromkeys((case.name for case in (*frame_cases(8192), *step_cases(), *benchmark.start.CASES)), 1.0)
    counted = {"image_gradient_ns", "chambers_differing", "image_error", "sympy_imported"}
    assert {target.key for target in TARGETS} <= frame_numbers(times).keys() | counted


def test_the_kept_frames_follow_from_their_medians():
    result = json.loads((RESULTS / "frames.json").read_text(encoding="utf-8"))
    numbers = result["numbers"]
    assert all(result["label"][name] for name in ("machine", "date", "commit"))
    assert all(isinstance(value, int | float | str) for value in numbers.values())
    assert all(value > 0 for key, value in numbers.items() if key.endswith(("_ms", "_ns", "_s")))
    assert "not measured" not in table(numbers)
    assert not any(key.endswith(("_target", "_verdict")) for key in numbers)  # what was asked for is no measurement
    ends = [key.removesuffix("_low") for key in numbers if key.endswith("_low")]
    assert all(numbers[f"{key}_low"] <= numbers[key] <= numbers[f"{key}_high"] for key in ends)
    timed = {key.removesuffix("_ms"): value / 1e3 for key, value in numbers.items() if key.endswith("_ms")}
    derived = frame_numbers(timed)
    assert {key: numbers[key] for key in derived} == pytest.approx(derived)


def test_a_small_run_writes_what_it_measured(tmp_path):
    command = [sys.executable, "-m", "verify.benchmark", "--quick", "--only", "algebraic_64", "--output", str(tmp_path)]
    root = RESULTS.parents[2]
    done = subprocess.run(command, cwd=root, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    numbers = json.loads((tmp_path / "frames.json").read_text(encoding="utf-8"))["numbers"]
    assert {"algebraic_64_1_ms", "algebraic_64_2_ms", "load"} <= numbers.keys()
    assert "not measured" in done.stdout


def test_an_unknown_case_is_refused(capsys):
    with pytest.raises(SystemExit, match="2"):
        benchmark.main(["--only", "nothing_of_that_name"])
    assert "nothing_of_that_name" in capsys.readouterr().err
