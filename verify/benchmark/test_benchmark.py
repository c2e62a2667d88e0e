"""The benchmark's machinery: turns, medians, the table's verdicts, the results' shape. No time is asserted."""

import json
import math
import subprocess
import sys
from functools import partial
from unittest import mock

import numpy as np
import pytest

from renderer import Scene, exact
from verify.benchmark import __main__ as benchmark
from verify.benchmark import machines, plan, rules, texture
from verify.benchmark.frames import FITTED, START_CASES, frame_cases, step_cases
from verify.benchmark.label import RESULTS
from verify.benchmark.plan import Case, given
from verify.benchmark.targets import TARGETS, derived, table
from verify.sources import ROOT

ROUNDS = {
    "texture": (texture, lambda: {f"{way}_ns" for way in texture.ways()}),
    "machines": (machines, lambda: {f"{m}_{how}_ms" for m in machines.MACHINES for how in machines.METHODS}),
}
"""{run that takes the least of each round: (its module, the times that carry quartiles, as its ratios do)}"""


def numbers_in(folder, name):
    """Return the numbers of a run, which has a label and quartiles in their order."""
    result = json.loads((folder / f"{name}.json").read_text(encoding="utf-8"))
    numbers = result["numbers"]
    assert {"machine", "date", "commit"} <= result["label"].keys() and numbers["load"] >= 0
    ends = [key.removesuffix("_low") for key in numbers if key.endswith("_low")]
    assert all(0 < numbers[f"{key}_low"] <= numbers[key] <= numbers[f"{key}_high"] for key in ends)
    assert not any(key.endswith(("_target", "_verdict")) for key in numbers)  # what was asked for is no measurement
    return numbers, ends


@pytest.mark.parametrize("rule", rules.RULES)
def test_a_picture_is_drawn_without_each_rule(rule, monkeypatch):
    """What takes a rule away replaces a function of the renderer: it must still take what that function is given."""
    monkeypatch.setattr(rules, "SIDE", 8)
    rules.prepare(Scene(beta=0.2), exact(), rules.RULES[rule])()


def test_cases_take_turns_forwards_and_backwards():
    """Each is called once when it is prepared, and a visit of several calls begins with one that is not timed."""
    made, seen = [], []

    def case(name, repeats, visits):
        return Case(name, lambda: made.append(name) or partial(seen.append, name), repeats, visits)

    seconds = plan.timings([case("a", 1, 3), case("b", 2, 2), case("c", 1, 1)], "test")
    assert "".join(seen) == "aabbbbcc" + "bbba" + "a" and made == ["a", "b", "c"]
    assert {name: len(calls) for name, calls in seconds.items()} == {"a": 3, "b": 4, "c": 1}


def test_a_time_is_that_of_the_call(monkeypatch):
    clock = iter([0, 1, 1, 10, 10, 12])
    monkeypatch.setattr(plan.time, "perf_counter", lambda: next(clock))
    assert plan.timings([Case("a", given(lambda: None), visits=3)], "test") == {"a": [1, 9, 2]}
    assert plan.with_quartiles("a", [0.5, 0.1, 0.2, 0.3, 0.4]) == pytest.approx({"a_low": 0.2, "a": 0.3, "a_high": 0.4})


def test_a_ratio_is_taken_round_by_round():
    """A round in which the machine is ten times slower, or a call that is interrupted, leaves the ratio as it was."""
    fast = np.repeat([1.0, 1.0, 10.0, 1.0, 1.0], 4)
    slow = 2 * fast
    slow[1] = 50.0
    for factor, quartiles in ((1, [2, 2, 2]), (np.repeat([1, 2, 3, 4, 5], 4), [4, 6, 8])):
        numbers = plan.numbers_of({"slow": slow * factor, "fast": fast}, 4, "ms", 1e3, {"ratio": ("slow", "fast")})
        assert [numbers[f"ratio{end}"] for end in ("_low", "", "_high")] == pytest.approx(quartiles)
    assert numbers["fast_ms"] == pytest.approx(1e3)


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
    times = {f"algebraic_{side}_2_ms": 1e-5 * side**2 for side in FITTED}
    times |= {"numpy_1024_2_ms": 200.0, "with_all_plain_ms": 3.0, "without_flat_plain_ms": 4.0}
    assert derived(times) == pytest.approx(
        {"exponent_2": 1, "numpy_to_algebraic_1024": 200 / 10.48576, "flat_saves_plain": 25}
    )


def test_every_target_is_measured_by_a_case():
    times = dict.fromkeys((f"{case.name}_ms" for case in (*frame_cases(8192), *step_cases())), 1.0)
    counted = {"image_gradient_ns", "chambers_differing", "image_error", *(f"{case.name}_s" for case in START_CASES)}
    assert TARGETS.keys() <= derived(times).keys() | times.keys() | counted


def test_the_kept_frames_follow_from_their_medians():
    numbers, _ = numbers_in(RESULTS, "frames")
    assert all(value > 0 for key, value in numbers.items() if key.endswith(("_ms", "_ns", "_s")))
    assert "not measured" not in table(numbers)
    assert {key: numbers[key] for key in derived(numbers)} == pytest.approx(derived(numbers))


def test_a_small_run_of_frames_writes_what_it_measured(tmp_path):
    command = [sys.executable, "-m", "verify.benchmark", "--quick", "--only", "algebraic_64", "--output", str(tmp_path)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert {"algebraic_64_1_ms", "algebraic_64_2_ms"} <= numbers_in(tmp_path, "frames")[0].keys()
    assert "not measured" in done.stdout


@pytest.mark.parametrize("name", ROUNDS)
def test_a_run_in_rounds_writes_what_it_measured_as_the_kept_one(name, tmp_path, monkeypatch):
    monkeypatch.setattr(machines, "SIDE", 32)
    module, times = ROUNDS[name]
    module.main(["--rounds", "2", "--output", str(tmp_path)])
    for folder in (tmp_path, RESULTS):
        numbers, ends = numbers_in(folder, name)
        assert times() | {*module.RATIOS} == {*ends} and numbers.get("differing", 0) == 0
    assert numbers_in(tmp_path, name)[0]["rounds"] == 2


def test_a_machine_that_draws_other_bits_is_seen(monkeypatch):
    def drawer(want, job):
        draw = machines.native.drawer(want, job)

        def wrong(rows):
            counted = draw(rows)
            job.planes["red"][:] *= 1 + 2**-50
            return counted

        return wrong

    monkeypatch.setattr(machines, "SIDE", 32)
    monkeypatch.setitem(machines.MACHINES, "numpy", mock.Mock(drawer=drawer, NAME="other"))
    assert machines.differing_bytes("exact") > 0


def test_an_unknown_case_is_refused(capsys):
    with pytest.raises(SystemExit, match="2"):
        benchmark.main(["--only", "nothing_of_that_name"])
    assert "nothing_of_that_name" in capsys.readouterr().err
