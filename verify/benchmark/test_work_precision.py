"""The committed work-precision run: nobody's method beats ours in both time and error, and the check can fail."""

import csv
import json

import numpy as np
import pytest

from renderer import Scene, central, exact, render, stage_of
from verify.benchmark import work_precision
from verify.benchmark.work_precision import RESULTS, SIDE, image_error, peers_that_beat, unbeaten_by_ours

RESULT = json.loads((RESULTS / "work_precision.json").read_text(encoding="utf-8"))
ROWS = RESULT["gradients"]
OURS = {"method": "ours", "ours": True, "ns": 5.0, "error": 1e-14}


def other(ns, error):
    """Return a row of somebody else's."""
    return {"method": "theirs", "ours": False, "ns": ns, "error": error}


def test_no_other_method_is_both_faster_and_more_accurate():
    assert peers_that_beat(ROWS) == []


def test_what_ours_do_not_beat_has_more_digits_than_float64():
    assert {r["method"] for r in unbeaten_by_ours(ROWS)} <= {"mpmath"}
    assert all(r["error"] < 1e-15 for r in unbeaten_by_ours(ROWS))


@pytest.mark.parametrize(("field", "error"), [("sine", "largest"), ("ridges", "rms")])
def test_no_difference_draws_a_frame_faster_and_better(field, error):
    assert peers_that_beat([r for r in RESULT["frames"] if r["field"] == field], "ms", error) == []


@pytest.mark.parametrize(("ns", "error", "beats"), [(4.0, 1e-15, 1), (6.0, 1e-15, 0), (4.0, 1e-13, 0), (6.0, 1e-13, 0)])
def test_a_better_method_would_be_seen(ns, error, beats):
    rows = [OURS, other(ns, error)]
    assert len(peers_that_beat(rows)) == beats
    assert len(unbeaten_by_ours(rows)) == (0 if (ns, error) == (6.0, 1e-13) else 1)


def test_it_is_labelled_and_compared_somebody():
    assert {"machine", "date", "commit", "absent", "rounds", "seed"} <= RESULT["label"].keys()
    assert {"JAX", "scipy.differentiate", "numdifftools"}.isdisjoint(RESULT["label"]["absent"])
    assert len({r["method"] for r in ROWS}) >= 16


def test_the_table_beside_it_says_the_same():
    with open(RESULTS / "work_precision.csv", newline="", encoding="utf-8") as file:
        table = list(csv.DictReader(file))
    assert [(r["method"], float(r["ns"]), float(r["error"])) for r in table] == [
        (r["method"], r["ns"], r["error"]) for r in ROWS
    ]


def test_image_errors_are_against_50_digits():
    """On a few pixels: the exact frame is right to rounding, a difference is not."""
    scene = Scene(field="sine")
    colours = work_precision.reference_colours(scene, 5)
    stage = stage_of(scene, SIDE, SIDE)
    right, rough = (
        image_error(render(scene, SIDE, SIDE, m, stage=stage), colours)[0] for m in (exact(), central(1e-2))
    )
    assert right <= 5e-14 < 1e-4 < rough


def test_the_timer_times_each_call_in_every_round():
    timer, seen = work_precision.Timer(), []
    timer.add("a", lambda: seen.append("a"), 2)
    timer.add("b", lambda: seen.append("b"), 1)
    timer.run(3)
    assert seen == ["a", "b", *"ab" * 3]
    assert len(timer.seconds["a"]) == 3 and timer.median("a") > 0
    assert np.isfinite(timer.median("b"))
