"""Sweeps over a grid: the same rows by any executor, what is shared, and nothing lost or repeated by a kill."""

import json
import os
import shutil
import signal
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from dataclasses import fields, replace

import numpy as np
import pytest
from distributed import Client, LocalCluster

from renderer import Light, Scene, render, stage_of
from renderer.command_line import grid
from renderer.command_line.grid import Checkpoint, key_of
from renderer.command_line.verbs import main
from renderer.machines import numpy_rows
from renderer.picture.sweep import SweepRow, Task, sweep, table
from renderer.scene.methods import GradientMethod, central
from renderer.scene.raster import Raster
from tests.processes import python, started, wait_until
from tests.refusals import rejection
from verify.sources import ROOT

SIZE = (24, 16)
BETAS = [0.01 * n for n in range(1, 41)]
MANY = grid.grid(Scene(), [SIZE], ["central"], (1e-2, 1e-3), beta=BETAS)
LONG = grid.grid(Scene(), [(200, 200)], ["central"], (1e-2, 1e-3), beta=BETAS)  # there is time to kill it


class Inline(Executor):
    """An executor that computes a batch when it is given it, and remembers the tasks."""

    def __init__(self):
        self.tasks = []

    def submit(self, work, batch, *arguments):
        self.tasks += batch
        future = Future()
        future.set_result(work(batch, *arguments))
        return future


@pytest.fixture(scope="module")
def many():
    return grid.run(MANY, Inline())


@pytest.fixture(scope="module")
def long():
    return grid.run(LONG, Inline())


def test_a_grid_has_every_combination_once():
    lists = {"field": ["sine", "rings", "sine"], "ku": [2, 4], "kv": [3.0], "beta": [0.1, -0.1]}
    tasks = grid.grid(Scene(), [(8, 8), (9, 7)], ["central", "forward"], (1e-2, 1e-3, 1e-2), **lists)
    assert len(tasks) == len(set(tasks)) == 2 * (2 * 2 * 1 * 2) * 2 * 2
    assert tasks[:2] == [Task(Scene(field="sine", ku=2, kv=3, beta=0.1), central(eps), 8, 8) for eps in (1e-2, 1e-3)]
    assert tasks[-1] == Task(Scene(field="rings", ku=4, kv=3, beta=-0.1), GradientMethod("forward", 1e-3), 9, 7)


OTHER = {"ball": False, "floor": False, "lights": (Light((5, 5, 10), None),), "model": "phong", "field": "rings"}


def test_a_key_is_of_the_content():
    """Of every number, choice and light of the scene, and of the rest of the task."""
    task = Task(Scene(), central(1e-3), 8, 8)
    values = {field.name: 0.9 * np.array(field.default) for field in fields(Scene) if field.name not in OTHER} | OTHER
    scenes = [Scene(**{name: value}) for name, value in values.items()]
    tasks = [task, *(replace(task, scene=scene) for scene in scenes), replace(task, width=9), replace(task, height=9)]
    tasks += [replace(task, method=central(1e-4)), replace(task, method=GradientMethod("forward", 1e-3))]
    assert len({key_of(each) for each in tasks}) == len(tasks) == len(fields(Scene)) + 5
    assert key_of(Task(Scene(beta=0.35, ku=8), central(0.001), 8, 8)) == key_of(task)


@pytest.mark.parametrize("edited", ["renderer/kernels.py", "renderer/machines/traced.py", "proofs/formulas/ranges.py"])
def test_a_key_is_of_the_sources_and_the_machine_too(edited, tmp_path, monkeypatch):
    for folder in ("renderer", "proofs"):
        shutil.copytree(ROOT / folder, tmp_path / folder, ignore=shutil.ignore_patterns("__pycache__"))
    own, key = grid.version(), key_of(Task(Scene(), central(1e-3), 8, 8))
    monkeypatch.setattr(grid, "__file__", str(tmp_path / "renderer" / "command_line" / "grid.py"))
    assert grid.version.__wrapped__() == own
    with open(tmp_path / edited, "a") as file:
        file.write("\n")
    changed = grid.version.__wrapped__()
    monkeypatch.setattr(grid, "machine", lambda: numpy_rows)
    assert len({own, changed, grid.version.__wrapped__()}) == 3
    monkeypatch.setattr(grid, "version", lambda: changed)
    assert key_of(Task(Scene(), central(1e-3), 8, 8)) != key


def test_a_batch_shares_its_chambers():
    tasks = grid.grid(Scene(), [(8, 8), (9, 8)], ["central"], (1e-2, 1e-3), field=["sine", "rings"], beta=range(9))
    tasks += grid.grid(Scene(ball=False), [(8, 8)], ["central"], (1e-2,), ku=range(1, 7))
    batches = grid.batches(tasks)
    assert sorted(map(len, batches)) == [4, 4, 6, 16, 16, 16, 16]
    assert [task for batch in batches for task in batch] == tasks
    for batch in batches:
        first = batch[0]
        stage = stage_of(first.scene, first.width, first.height)
        assert all(stage.serves(task.scene, Raster(task.width, task.height)) for task in batch)
    large = grid.grid(Scene(), [(2**10, 2**10), (2**13, 2**13)], ["central"], (1e-2, 1e-3), beta=range(8))
    assert [len(batch) for batch in grid.batches(large)] == [8, 8, 4, 4, 4, 4]


def test_the_rows_are_those_of_a_sweep():
    scene = Scene(lights=(Light((5, 5, 10)), Light((1, 1, 9), None)))
    tasks = grid.grid(
        scene, [SIZE, (9, 9)], ["central4", "forward"], (1e-1, 1e-4), field=["sine", "ridges"], kv=[3, 4.5]
    )
    rows = grid.run(tasks, Inline())
    assert list(rows) == tasks
    for task, row in rows.items():
        assert sweep(task.scene, task.width, task.height, (task.method.eps,), task.method.name, 1)[0] == row
    assert len(set(rows.values())) == len(tasks)


def test_a_batch_draws_the_exact_frame_once_a_scene(monkeypatch):
    drawn = []
    seen = lambda *a, **o: drawn.append((a[3].name, o.get("stage") is None)) or render(*a, **o)  # noqa: E731
    monkeypatch.setattr("renderer.picture.sweep.render", seen)
    tasks = grid.grid(Scene(), [SIZE], ["central"], (1e-2, 1e-3, 1e-4), beta=[0.1, 0.2])
    grid.compare_batch(tasks, grid.version())
    of_scene = [("central", True)] * 3  # whole: flips are counted
    assert drawn == [("exact", True), *of_scene, ("exact", False), *of_scene]


def test_flips_are_counted(monkeypatch):
    made = []

    def flipping(*arguments, **options):
        frame = render(*arguments, **options)
        if frame.method.eps:
            made.append(frame)
            frame.stage.chambers = frame.chambers.copy()
            frame.stage.chambers[0, : len(made)] ^= 128
        return frame

    monkeypatch.setattr("renderer.picture.sweep.render", flipping)
    tasks = grid.grid(Scene(), [SIZE], ["central"], (1e-2, 1e-3), beta=[0.1, 0.2])
    assert [row.flips for row in grid.compare_batch(tasks, grid.version()).values()] == [1, 2, 3, 4]


def test_a_worker_of_another_version_is_refused():
    with pytest.raises(ValueError, match="a worker's renderer is not allowed"):
        grid.compare_batch(MANY[:1], "another")


def test_what_is_kept_is_not_computed_again(many, tmp_path):
    asked, executors = (MANY[20:40], MANY, MANY), (Inline(), Inline(), Inline())
    for tasks, executor in zip(asked, executors, strict=True):
        with Checkpoint(tmp_path / "a.jsonl") as kept:
            assert grid.run(tasks, executor, kept) == {task: many[task] for task in tasks}
    assert [executor.tasks for executor in executors] == [MANY[20:40], MANY[:20] + MANY[40:], []]
    with ThreadPoolExecutor(3) as executor:  # which finishes batches in any order
        assert grid.run(MANY, executor) == many


def test_a_failure_keeps_what_was_finished_and_cancels_the_rest(many, tmp_path, monkeypatch):
    def failing(batch, *arguments):
        if MANY[32] in batch:
            raise ArithmeticError("the third batch")
        return {task: many[task] for task in batch}

    monkeypatch.setattr(grid, "compare_batch", failing)
    failure = pytest.raises(ArithmeticError, match="the third batch")
    with failure, ThreadPoolExecutor(1) as executor, Checkpoint(tmp_path / "a.jsonl") as kept:
        grid.run(MANY, executor, kept)
    assert set(kept.rows) == {key_of(task) for task in MANY[:32]}


def lines(path):
    return path.read_bytes().splitlines() if path.exists() else []


def test_a_sweep_that_is_killed_goes_on(long, tmp_path, capsys):
    """The same command computes what is missing, nothing twice."""
    kept = tmp_path / "a.jsonl"
    options = ["sweep", "--size", "200", "--eps", "1e-2,1e-3", "--beta", ",".join(map(str, BETAS))]
    options += ["--checkpoint", str(kept), "--workers", "1"]
    with started("-m", "renderer", *options) as child:
        wait_until(lambda: len(lines(kept)) >= 16, child)
        child.kill()
    before = lines(kept)
    assert 16 <= len(before) < len(LONG)
    assert main(options) == 0
    assert capsys.readouterr().out == table(long) + "\n"
    after = lines(kept)
    assert after[: len(before) - 1] == before[:-1]  # the last line may have been torn
    keys = [json.loads(line)["key"] for line in after]
    assert sorted(keys) == sorted(key_of(task) for task in LONG)  # every one, and none twice


def test_a_dask_worker_that_is_killed(long, tmp_path):
    """A real local cluster; one of its two worker processes is killed while it has work."""
    cluster = LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs="CRITICAL")
    for nanny in cluster.workers.values():
        nanny.auto_restart = False
    with cluster, Client(cluster, set_as_default=False) as client:
        workers = client.run(os.getpid)
        with Checkpoint(tmp_path / "a.jsonl") as kept:
            finished = grid.finished(LONG, client.get_executor(), kept)
            results = [next(finished)]
            victim = next(worker for worker, work in client.processing().items() if work)
            killed = workers[victim]
            os.kill(killed, signal.SIGKILL)
            results += finished
        assert killed not in client.run(os.getpid).values()
    assert len(results) == len(LONG)
    assert dict(results) == long
    assert len(lines(kept.path)) == len(LONG)


def test_a_dask_cluster_from_the_command_line(many, tmp_path, capsys):
    target = tmp_path / "a.csv"
    command = ["sweep", "--width", "24", "--height", "16", "--eps", "1e-2,1e-3", "--beta", "0.01,0.02", "--csv"]
    with LocalCluster(n_workers=1, processes=False, dashboard_address=None) as cluster:
        assert main([*command, str(target), "--dask", cluster.scheduler_address]) == 0
    assert capsys.readouterr().out.startswith(table({task: many[task] for task in MANY[:4]}) + "\nwrote ")
    upper = np.genfromtxt(target, delimiter=",", names=True, dtype=None, encoding="utf-8")["rms_upper"]
    assert list(upper) == [many[task].rms_upper for task in MANY[:4]]


KEPT_TASKS = grid.grid(Scene(), [(8, 8)], ["central"], (1e-2, 1e-3, 1e-4))
ROWS = [
    SweepRow(task.method.eps, 0.1 + 0.2, 1e-300, 0, number, 0.3, 0.4, 0.0, 1e-299)
    for number, task in enumerate(KEPT_TASKS)
]
RESULTS = dict(zip(KEPT_TASKS, ROWS, strict=True))


@pytest.fixture
def full(tmp_path):
    """A file with the three results."""
    with Checkpoint(tmp_path / "a.jsonl") as checkpoint:
        assert checkpoint.rows == {}
    assert list(tmp_path.iterdir()) == []
    with Checkpoint(checkpoint.path) as checkpoint:
        checkpoint.append({task: RESULTS[task] for task in KEPT_TASKS[:2]})
        checkpoint.append({KEPT_TASKS[2]: ROWS[2]})
    assert checkpoint.rows == {key_of(task): row for task, row in RESULTS.items()}
    assert checkpoint.kept([*KEPT_TASKS, *grid.grid(Scene(), [(9, 9)], ["central"], (1e-2,))]) == RESULTS
    return checkpoint.path


def test_a_line_says_what_it_is_the_result_of(full):
    record = json.loads(full.read_text().splitlines()[1])
    assert record["task"]["scene"]["field"] == "ridges"
    assert record["task"]["method"] == {"name": "central", "eps": 1e-3, "form": "auto"}
    assert (record["task"]["width"], record["row"]["straddling"]) == (8, 1)


def test_wherever_the_writer_was_killed_the_whole_lines_are_kept(full):
    content = full.read_bytes()
    last = content.rindex(b"\n", 0, -1) + 1
    for size in [*range(last, len(content), 17), *range(last, last + 12), len(content) - 1]:
        full.write_bytes(content[:size])
        with Checkpoint(full) as checkpoint:
            assert checkpoint.rows == {key_of(task): RESULTS[task] for task in KEPT_TASKS[:2]}
        assert full.read_bytes() == content[:last]
    with Checkpoint(full) as checkpoint:
        checkpoint.append({KEPT_TASKS[2]: ROWS[2]})
    assert full.read_bytes() == content


def test_one_sweep_at_a_time_writes_to_a_checkpoint(full, capsys):
    """Of this process or another: what computes it is there when the other begins."""
    options = ["sweep", "--size", "8", "--eps", "1e-2", "--checkpoint", str(full), "--no-facts"]
    with Checkpoint(full):
        refused = f"checkpoint = {str(full)!r} is not allowed: one that no other sweep is writing"
        assert rejection(Checkpoint, full) == refused
        assert python("-m", "renderer", *options, status=2) == ("", f"python -m renderer sweep: error: {refused}\n")
    assert main(options) == 0


@pytest.mark.parametrize(
    ("content", "line"),
    [
        ("dear diary", 1),
        ("dear diary\n", 1),
        ('{"key": "a", "row": {"eps": 1}}\n', 1),
        ("[]\n", 1),
        ('WHOLE{"key": "a", "row": nothing}\nWHOLE', 2),
        ("WHOLEdear diary", 2),
    ],
)
def test_a_file_of_something_else_is_refused_and_kept(content, line, full):
    whole = full.read_text().splitlines(keepends=True)[0]
    full.write_text(content.replace("WHOLE", whole))
    before = full.read_bytes()
    allowed = f"a file of results, and its line {line} is none"
    assert rejection(Checkpoint, full) == f"checkpoint = {str(full)!r} is not allowed: {allowed}"
    assert full.read_bytes() == before
