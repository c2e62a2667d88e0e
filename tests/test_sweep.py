"""The ε-table: the chapter's numbers, no flips, and the table as text and as CSV."""

import csv
import math
from functools import cache

import numpy as np
import pytest

from renderer import Scene, central, render
from renderer.picture.differences import certain_digits, difference_on_a
from renderer.picture.facts import facts
from renderer.picture.sweep import sweep, table, write_csv

CHAPTER = {
    1e-1: (0.1959, 0.98),
    1e-2: (0.04675, 0.72),
    1e-3: (0.01214, 0.62),
    1e-4: (0.00347, 0.46),
    1e-5: (0.001005, 0.28),
}
"""{ε: (RMS, largest)}"""


@cache
def default_rows():
    return {row.eps: row for row in sweep(Scene(), 256, 256)}


@pytest.mark.parametrize("eps", CHAPTER)
def test_the_table_is_the_chapters(eps):
    row, (root_mean_square, largest) = default_rows()[eps], CHAPTER[eps]
    assert row.rms == pytest.approx(root_mean_square, rel=0.01)
    assert row.largest == pytest.approx(largest, rel=0.02)


def test_below_the_last_straddling_pixel_there_is_rounding_alone():
    row = default_rows()[1e-6]
    assert 3.5e-12 < row.rms < 1.4e-11
    assert row.largest < 1e-9
    assert row.straddling == 0


def test_smooth_fields_descend_by_two_orders_a_decade():
    one, other = sweep(Scene(field="sine"), 128, 128, (1e-3, 1e-4))
    assert one.rms / other.rms == pytest.approx(100, rel=0.01)


def test_rms_and_largest_are_over_a_alone():
    scene = Scene()
    one, other = render(scene, 64, 64, central(1e-2)), render(scene, 64, 64)
    delta = (one.rgb - other.rgb)[one.chambers & 3 == 1]
    (row,) = sweep(scene, 64, 64, (1e-2,))
    assert row.rms == pytest.approx(math.sqrt((delta**2).mean()), rel=1e-14)
    assert row.largest == np.abs(delta).max()
    np.testing.assert_array_equal(difference_on_a(one, other), delta)


def test_a_sweep_without_a_pixel_of_a():
    behind_b = Scene(ball_center=(0, 0, 2.5), ball_radius=1.1)
    (row,) = sweep(behind_b, 1, 1, (1e-3,))
    assert render(behind_b, 1, 1).work["pixels_a"] == 0
    assert (row.largest, row.rms, row.flips, row.straddling) == (0, 0, 0, 0)


def test_a_table_has_certain_digits_alone(tmp_path):
    rows = list(default_rows().values())
    lines = [line.split() for line in table(rows).splitlines()[1:]]
    assert lines[2] == ["0.001", "0.6246", "0.01214", "0", "594"]
    assert lines[-1][:4] == ["1e-06", "1.2e-10", "<=", "8e-12"]
    write_csv(tmp_path / "a.csv", rows)
    with open(tmp_path / "a.csv", newline="", encoding="utf-8") as file:
        read = list(csv.DictReader(file))
    for name in ("largest", "rms"):
        for text, row in zip(read, rows, strict=True):
            lower, upper = getattr(row, f"{name}_lower"), getattr(row, f"{name}_upper")
            assert (float(text[f"{name}_lower"]), float(text[f"{name}_upper"])) == (lower, upper)
            assert text[name] == certain_digits(lower, upper, 15)
            assert lower <= getattr(row, name) <= upper
    assert [record["rms"] == "" for record in read] == [False] * 5 + [True]
    kept = ("eps", "flips", "straddling")
    assert [[float(record[name]) for name in kept] for record in read] == [[getattr(r, n) for n in kept] for r in rows]


def test_facts():
    told = dict(facts(Scene(ku=8.0), 64, 64))
    assert told["flips over 96 frames (fields, beta, eps, models)"] == "0"
    assert told["beta = 0: largest |numeric - exact|"] == "0"
    assert told["ridges on the crease u = 1/8: exact (h_u, h_v)"] in ("(0, 0)", "(0, -0)", "(-0, 0)", "(-0, -0)")
    assert told["sine at (0.31, 0.47): error of h_u, eps = 0.001"] == "6.116e-05"
    assert told["sine at (0.31, 0.47): error of h_u, eps = 0.0001"] == "6.116e-07"
    assert 7e-12 < float(told["sine at (0.31, 0.47): error of h_u, eps = 1e-06"]) < 7e-10
    other = dict(facts(Scene(ku=2.0), 32, 32))
    assert other["sine at (0.31, 0.47): error of h_u, eps = 0.001"] != "6.116e-05"
