"""Sweeps over a grid: the same rows by any executor, and nothing lost or repeated where one was stopped."""

import csv
import json
from dataclasses import replace
from itertools import product

import pytest
from distributed import LocalCluster

from renderer import HeightField, Light, Scene, forward, k_u, render, sinpi, u, v
from renderer.command_line import grid
from renderer.command_line.grid import Checkpoint, key_of
from renderer.command_line.verbs import main
from renderer.intervals import certain_digits
from renderer.picture.stage import Stage
from renderer.picture.sweep import HEADINGS, Task, compared, sweep, table, write_csv
from renderer.scene.methods import GradientMethod, central
from tests.refusals import rejection
from tests.test_machines import numpy_draws

SIZE = (24, 16)
TASK = Task(Scene(), central(1e-3), *SIZE)
BETAS = [0.01 * n for n in range(1, 41)]
CUSTOM = Scene(field=HeightField("swept", v * sinpi(k_u * u)))
MANY = grid.grid(CUSTOM, [(16, 16)], ["central"], (1e-2, 1e-3), beta=BETAS)


@pytest.fixture(scope="module")
def many():
    return dict(zip(MANY, compared(MANY), strict=True))


def test_a_key_is_of_the_task_and_of_its_version(monkeypatch):
    others = {"method": central(1e-4)}, {"width": 9}, {"scene": Scene(beta=0.1)}
    keys = {key_of(TASK), *(key_of(replace(TASK, **other)) for other in others)}
    assert key_of(Task(Scene(beta=0.35), central(0.001), *SIZE)) in keys and len(keys) == 4
    monkeypatch.setattr(grid, "version", lambda: "another")
    assert key_of(TASK) not in keys
    assert rejection(grid.compare_batch, MANY[:1], "yet another").startswith("a worker's renderer is not allowed")


def test_a_batch_shares_its_chambers_and_has_no_task_twice():
    assert grid.grid(Scene(), [SIZE] * 2, ["central"] * 2, [1e-3] * 2, beta=[0.35] * 2) == [TASK]
    tasks = MANY + grid.grid(Scene(ball=False), [(8, 8)], ["central"], (1e-2,), ku=range(1, 11))
    assert [*map(len, grid.batches(tasks))] == [8] * 10 + [8, 2]


def lines(path):
    return path.read_bytes().splitlines()


@pytest.fixture
def full(many, tmp_path):
    """A file with three results."""
    with Checkpoint(tmp_path / "a.jsonl") as checkpoint:
        checkpoint.append({task: many[task] for task in MANY[:3]})
    return checkpoint.path


def test_a_sweep_that_was_stopped_goes_on(many, full, tmp_path, capsys):
    """The same command computes the missing frames, none twice; each line has its scene."""
    before, scene = lines(full), tmp_path / "a.toml"
    CUSTOM.to_file(scene)
    options = ["--size", "16", "--eps", "1e-2,1e-3", "--beta", ",".join(map(str, BETAS)), "--workers", "1"]
    assert main(["sweep", *options, "--scene", str(scene), "--checkpoint", str(full)]) == 0
    assert capsys.readouterr().out == table(many) + "\n"
    after = lines(full)
    assert after[: len(before)] == before
    records = [json.loads(line) for line in after]
    assert sorted(line["key"] for line in records) == sorted(key_of(task) for task in MANY)
    assert {Scene.from_record(line["task"]["scene"]) for line in records} == {task.scene for task in MANY}


def test_a_grid_from_the_command_line_on_a_dask_cluster(tmp_path, capsys):
    """Every combination; the rows are those of a sweep."""
    target, scene = tmp_path / "a.csv", Scene(lights=(Light((5, 5, 10)), Light((1, 1, 9), None)))
    rows = {
        Task(each, GradientMethod(method, eps), side, side): sweep(each, side, side, (eps,), method)[0]
        for side, field, method, eps in product((16, 24), ("sine", "rings"), ("forward", "central"), (1e-2, 0.1))
        for each in [replace(scene, field=field)]
    }
    scene.to_file(tmp_path / "a.toml")
    lists = ["--field", "sine,rings", "--size", "16,24", "--eps", "1e-2", ".1", "--gradient", "forward,central"]
    command = ["sweep", *lists, "--scene", tmp_path / "a.toml", "--csv", target]
    with LocalCluster(n_workers=1, processes=False, dashboard_address=None) as cluster:
        assert main([*map(str, command), "--dask", cluster.scheduler_address]) == 0
    assert capsys.readouterr().out == f"{table(rows)}\nwrote {target}\n"
    assert len(lines(target)) == len(rows) + 1


def test_wherever_the_writer_was_killed_the_complete_lines_are_kept(many, full):
    content = full.read_bytes()
    last = content.rindex(b"\n", 0, -1) + 1
    for size in (last, last + 1, last + 9, len(content) - 1):
        full.write_bytes(content[:size])
        with Checkpoint(full) as checkpoint:
            assert checkpoint.rows_of(MANY) == {task: many[task] for task in MANY[:2]}
        assert full.read_bytes() == content[:last]


def test_one_sweep_at_a_time_writes_to_a_checkpoint(full):
    with Checkpoint(full):
        assert "one that no other sweep is writing" in rejection(Checkpoint, full)


@pytest.mark.parametrize("wrong", ["dear diary", '{"key": "a", "row": {"eps": 1}}\n', "[]\n"])
def test_another_file_is_refused_and_kept(wrong, full):
    before = full.read_bytes() + wrong.encode()
    full.write_bytes(before)
    assert rejection(Checkpoint, full).endswith("a file of results alone")
    assert full.read_bytes() == before


# The ε-table: the chapter's numbers, no flips, and the table as text and as CSV


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


@numpy_draws()
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
