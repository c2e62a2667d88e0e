"""The ε-table: the chapter's numbers, no flips, and the table as text and as CSV."""

import csv
import math

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


@pytest.fixture(scope="module")
def rows():
    return sweep(Scene(), 256, 256)


def test_the_table_is_the_chapters(rows):
    """Below the last straddling pixel there is rounding alone."""
    *straddled, last = rows
    for row, (root_mean_square, largest) in zip(straddled, CHAPTER.values(), strict=True):
        assert row.rms == pytest.approx(root_mean_square, rel=0.01)
        assert row.largest == pytest.approx(largest, rel=0.02)
    assert 3.5e-12 < last.rms < 1.4e-11
    assert last.largest < 1e-9
    assert [row.eps for row in rows] == [*CHAPTER, 1e-6] and last.straddling == 0


def test_smooth_fields_descend_by_two_orders_a_decade():
    one, other = sweep(Scene(field="sine"), 128, 128, (1e-3, 1e-4))
    assert one.rms / other.rms == pytest.approx(100, rel=0.01)


def test_rms_and_largest_are_over_a_alone():
    one, other = render(Scene(), 64, 64, central(1e-2)), render(Scene(), 64, 64)
    delta = (one.rgb - other.rgb)[one.chambers & 3 == 1]
    (row,) = sweep(Scene(), 64, 64, (1e-2,))
    assert row.rms == pytest.approx(math.sqrt((delta**2).mean()), rel=1e-14)
    assert row.largest == np.abs(delta).max()
    np.testing.assert_array_equal(difference_on_a(one, other), delta)


def test_a_sweep_without_a_pixel_of_a():
    behind_b = Scene(ball_center=(0, 0, 2.5), ball_radius=1.1)
    (row,) = sweep(behind_b, 1, 1, (1e-3,))
    assert render(behind_b, 1, 1).work["pixels_a"] == 0
    assert (row.largest, row.rms, row.flips, row.straddling) == (0, 0, 0, 0)


def test_a_table_has_certain_digits_alone(rows, tmp_path):
    lines = [line.split() for line in table(rows).splitlines()[1:]]
    assert lines[2] == ["0.001", "0.6246", "0.01214", "0", "594"]
    assert lines[-1][:4] == ["1e-06", "1.2e-10", "<=", "8e-12"]
    write_csv(tmp_path / "a.csv", rows)
    with open(tmp_path / "a.csv", newline="", encoding="utf-8") as file:
        read = list(csv.DictReader(file))
    for text, row in zip(read, rows, strict=True):
        for name in ("eps", "flips", "straddling", "largest_lower", "largest_upper", "rms_lower", "rms_upper"):
            assert float(text[name]) == getattr(row, name)
        for name in ("largest", "rms"):
            lower, upper = getattr(row, f"{name}_lower"), getattr(row, f"{name}_upper")
            assert text[name] == certain_digits(lower, upper, 15)
            assert lower <= getattr(row, name) <= upper
    assert [text["rms"] == "" for text in read] == [False] * 5 + [True]


def test_facts():
    told = dict(facts(Scene(), 64, 64))
    assert told["flips over 96 frames (fields, beta, eps, models)"] == "0"
    assert told["beta = 0: largest |numeric - exact|"] == "0"
    assert told["ridges on the crease u = 1/8: exact (h_u, h_v)"] == "(0, 0)"
    of_sine = "sine at (0.31, 0.47): error of h_u, eps = "
    assert (told[of_sine + "0.001"], told[of_sine + "0.0001"]) == ("6.116e-05", "6.116e-07")
    assert 7e-12 < float(told[of_sine + "1e-06"]) < 7e-10
    assert dict(facts(Scene(ku=2.0), 32, 32))[of_sine + "0.001"] != "6.116e-05"
