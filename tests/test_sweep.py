"""The ε-table: the chapter's numbers, no flips, and the table as text and as CSV."""

import csv

import pytest

from renderer import Scene, forward, render
from renderer.intervals import certain_digits
from renderer.picture.stage import Stage
from renderer.picture.sweep import HEADINGS, sweep, table, write_csv


@pytest.fixture(scope="module")
def rows():
    return sweep(Scene(), 256, 256)


def test_a_table_has_certain_digits_alone(rows, tmp_path):
    """The chapter's numbers; below the last straddling pixel there is rounding alone."""
    lines = [line.split() for line in table(rows).splitlines()[1:]]
    assert lines[0] == ["0.1", "0.985", "0.1959", "0", "29919"]
    assert lines[2] == ["0.001", "0.6246", "0.01214", "0", "594"]
    assert lines[-1] == ["1e-06", "1.2e-10", "<=", "8e-12", "0", "0"]
    write_csv(tmp_path / "a.csv", rows)
    with open(tmp_path / "a.csv", newline="", encoding="utf-8") as file:
        read = list(csv.DictReader(file))
    for text, row in zip(read, map(vars, rows), strict=True):
        for name in HEADINGS:
            assert text[name] == certain_digits(row[f"{name}_lower"], row[f"{name}_upper"], 15)
    assert [text["rms"] == "" for text in read] == [False] * 5 + [True]


def test_a_chamber_that_differs_is_counted_as_a_flip(monkeypatch):
    def flipping(*arguments, **options):
        frame = render(*arguments, **options)
        if frame.method.eps:
            frame.stage.chambers = frame.chambers ^ (frame.chambers > 0) * 128
        return frame

    monkeypatch.setattr("renderer.picture.sweep.render", flipping)
    (row,) = sweep(Scene(floor=False), 16, 16, (1e-2,))
    assert row.flips == (render(Scene(floor=False), 16, 16).chambers > 0).sum() > 0


def test_a_further_step_draws_one_picture(monkeypatch):
    """Its straddling pixels are those of the frame itself."""
    drawn, draw = [], Stage.draw
    monkeypatch.setattr(Stage, "draw", lambda *given, **want: drawn.append(want) or draw(*given, **want))
    scene = Scene(ku=7.0)
    (first,) = sweep(scene, 96, 96, [1e-2], "forward")
    before = len(drawn)
    several = sweep(scene, 96, 96, [1e-2, 1e-3, 1e-4], "forward")
    assert several[0] == first and len(drawn) - before == before + 2
    assert [row.straddling for row in several] == [
        render(scene, 96, 96, forward(row.eps)).straddling.sum() for row in several
    ]
