"""Sweeps over a grid: the same rows by any executor, what is shared, and nothing lost or repeated by a kill."""

import json
import os
import signal
from dataclasses import replace
from itertools import product

import pytest
from distributed import Client, LocalCluster

from renderer import HeightField, Light, Scene, k_u, render, sinpi, u, v
from renderer.command_line import grid
from renderer.command_line.grid import Checkpoint, key_of
from renderer.command_line.verbs import main
from renderer.machines import numpy_rows
from renderer.picture.sweep import Task, compared, sweep, table
from renderer.scene.methods import GradientMethod, central
from renderer.whole_files import write_whole
from tests.processes import python, started, wait_until
from tests.refusals import rejection

SIZE = (24, 16)
TASK = Task(Scene(), central(1e-3), *SIZE)
BETAS = [0.01 * n for n in range(1, 41)]
OWN = Scene(field=HeightField("swept", v * sinpi(k_u * u)))
MANY = grid.grid(OWN, [(200, 200)], ["central"], (1e-2, 1e-3), beta=BETAS)  # there is time to kill it


@pytest.fixture(scope="module")
def many():
    return dict(zip(MANY, compared(MANY), strict=True))


def test_a_key_is_of_the_content_the_sources_and_the_machine(tmp_path, monkeypatch):
    others = {"method": central(1e-4)}, {"width": 9}, {"height": 9}, {"scene": Scene(beta=0.1)}
    keys = {key_of(TASK), *(key_of(replace(TASK, **other)) for other in others)}
    assert key_of(Task(Scene(beta=0.35), central(0.001), *SIZE)) in keys and len(keys) == 5
    monkeypatch.setattr(grid, "__file__", str(tmp_path / "renderer" / "command_line" / "grid.py"))
    version, versions = grid.version.__wrapped__, []
    for name, text in (("renderer/kernels.py", b""), ("renderer/kernels.py", b"#"), ("proofs/formulas/ranges.py", b"")):
        write_whole(tmp_path / name, text)
        versions.append(version())
    monkeypatch.setattr(grid, "machine", lambda: numpy_rows)
    assert len({*versions, version()}) == 4
    monkeypatch.setattr(grid, "version", lambda: "another")
    assert key_of(TASK) not in keys


def test_a_batch_shares_its_chambers_and_has_no_task_twice():
    """The larger the picture, the fewer."""
    assert grid.grid(Scene(), [SIZE] * 2, ["central"] * 2, [1e-3] * 2, beta=[0.35] * 2) == [TASK]
    sizes = (8, 8), (2**10, 2**10), (2**13, 2**13)
    tasks = MANY + grid.grid(Scene(ball=False), sizes, ["central"], (1e-2,), ku=range(1, 11))
    batches = grid.batches(tasks)
    assert [*map(len, batches)] == [16, 16, 16, 16, 16, 10, 8, 2, 4, 4, 2]
    assert [task for batch in batches for task in batch] == tasks


def test_a_batch_draws_the_exact_frame_once_a_scene_and_counts_flips(monkeypatch):
    drawn = []

    def flipping(*arguments, **options):
        frame = render(*arguments, **options)
        drawn.append((frame.method.name, options.get("stage") is None))
        if frame.method.eps:
            frame.stage.chambers = frame.chambers.copy()
            frame.stage.chambers[0, : len(drawn)] ^= 128
        return frame

    monkeypatch.setattr("renderer.picture.sweep.render", flipping)
    tasks = grid.grid(Scene(), [SIZE], ["central"], (1e-2, 1e-3), beta=[0.1, 0.2])
    assert [row.flips for row in grid.compare_batch(tasks, grid.version()).values()] == [2, 3, 5, 6]
    of_scene = [("central", True)] * 2  # whole: flips are counted
    assert drawn == [("exact", True), *of_scene, ("exact", False), *of_scene]


def test_a_worker_of_another_version_is_refused():
    with pytest.raises(ValueError, match="a worker's renderer is not allowed"):
        grid.compare_batch(MANY[:1], "another")


def lines(path):
    return path.read_bytes().splitlines() if path.exists() else []


def test_a_sweep_that_is_killed_goes_on(many, tmp_path, capsys):
    """The same command computes what is missing, nothing twice; what is kept says of which scene it is."""
    kept, scene = tmp_path / "a.jsonl", tmp_path / "a.toml"
    OWN.to_file(scene)
    options = ["sweep", "--size", "200", "--eps", "1e-2,1e-3", "--beta", ",".join(map(str, BETAS))]
    options += ["--scene", str(scene), "--checkpoint", str(kept), "--workers", "1"]
    with started("-m", "renderer", *options) as child:
        wait_until(lambda: len(lines(kept)) >= 16, child)
        child.kill()
    before = lines(kept)
    assert 16 <= len(before) < len(MANY)
    assert main(options) == 0
    assert capsys.readouterr().out == table(many) + "\n"
    after = lines(kept)
    assert after[: len(before) - 1] == before[:-1]  # the last line may have been torn
    found = [json.loads(line) for line in after]
    assert sorted(line["key"] for line in found) == sorted(key_of(task) for task in MANY)  # every one, and none twice
    assert {Scene.from_record(line["task"]["scene"]) for line in found} == {task.scene for task in MANY}


def test_a_dask_worker_that_is_killed(many, tmp_path):
    """A real local cluster; one of its two worker processes is killed while it has work."""
    cluster = LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs="CRITICAL")
    for nanny in cluster.workers.values():
        nanny.auto_restart = False
    with cluster, Client(cluster, set_as_default=False) as client, Checkpoint(tmp_path / "a.jsonl") as kept:
        workers = client.run(os.getpid)
        finished = grid.finished(MANY, client.get_executor(), kept)
        results = [next(finished)]
        killed = workers[next(worker for worker, work in client.processing().items() if work)]
        os.kill(killed, signal.SIGKILL)
        results += finished
        assert killed not in client.run(os.getpid).values()
    assert len(results) == len(MANY) == len(lines(kept.path))
    assert dict(results) == many


def test_a_grid_from_the_command_line_on_a_dask_cluster(tmp_path, capsys):
    """Every combination; the rows are those of a sweep."""
    target, scene = tmp_path / "a.csv", Scene(lights=(Light((5, 5, 10)), Light((1, 1, 9), None)))
    fields, betas, methods, steps = ["sine", "rings"], [-0.1, 0.35], ["forward", "central"], [1e-2, 1e-3, 0.1]
    scenes = [replace(scene, field=field, beta=beta) for field in fields for beta in betas]
    rows = {
        Task(each, GradientMethod(method, eps), side, side): sweep(each, side, side, (eps,), method)[0]
        for side, each, method, eps in product((16, 24), scenes, methods, steps)
    }
    scene.to_file(tmp_path / "a.toml")
    lists = ["--field", "sine,rings", "--beta", "-0.1,.35", "--size", "16,24", "--eps", "1e-2,1e-3", ".1"]
    command = ["sweep", *lists, "--gradient", "forward,central", "--scene", tmp_path / "a.toml", "--csv", target]
    with LocalCluster(n_workers=1, processes=False, dashboard_address=None) as cluster:
        assert main([*map(str, command), "--dask", cluster.scheduler_address]) == 0
    assert capsys.readouterr().out == f"{table(rows)}\nwrote {target}\n"
    names, *records = lines(target)
    assert names.startswith(b"field,ku,kv,beta,gradient,width,height,eps,largest,rms,flips,straddling,largest_lower,")
    assert len(records) == len(rows)


@pytest.fixture
def full(many, tmp_path):
    """A file with three results."""
    with Checkpoint(tmp_path / "a.jsonl") as checkpoint:
        assert checkpoint.rows == {}
    assert list(tmp_path.iterdir()) == []
    with Checkpoint(checkpoint.path) as checkpoint:
        for tasks in (MANY[:2], MANY[2:3]):
            checkpoint.append({task: many[task] for task in tasks})
        assert checkpoint.kept(MANY) == {task: many[task] for task in MANY[:3]}
    return checkpoint.path


def test_wherever_the_writer_was_killed_the_whole_lines_are_kept(many, full):
    content = full.read_bytes()
    last = content.rindex(b"\n", 0, -1) + 1
    for size in [*range(last, len(content), 17), *range(last, last + 12), len(content) - 1]:
        full.write_bytes(content[:size])
        with Checkpoint(full) as checkpoint:
            assert checkpoint.rows == {key_of(task): many[task] for task in MANY[:2]}
        assert full.read_bytes() == content[:last]
    with Checkpoint(full) as checkpoint:
        checkpoint.append({MANY[2]: many[MANY[2]]})
    assert full.read_bytes() == content


def test_one_sweep_at_a_time_writes_to_a_checkpoint(full, capsys):
    """Of this process or another: what computes it is there when the other begins."""
    options = ["sweep", "--size", "8", "--eps", "1e-2", "--checkpoint", str(full), "--no-facts"]
    with Checkpoint(full):
        refused = f"checkpoint = {str(full)!r} is not allowed: one that no other sweep is writing"
        assert rejection(Checkpoint, full) == refused
        assert python("-m", "renderer", *options, status=2) == ("", f"python -m renderer sweep: error: {refused}\n")
    assert main(options) == 0


@pytest.mark.parametrize("wrong", ["dear diary", "dear diary\n", '{"key": "a", "row": {"eps": 1}}\n', "[]\n"])
@pytest.mark.parametrize("line", [1, 2])
def test_a_file_of_something_else_is_refused_and_kept(wrong, line, full):
    before = b"".join(full.read_bytes().splitlines(keepends=True)[: line - 1]) + wrong.encode()
    full.write_bytes(before)
    allowed = f"a file of results, and its line {line} is none"
    assert rejection(Checkpoint, full) == f"checkpoint = {str(full)!r} is not allowed: {allowed}"
    assert full.read_bytes() == before
