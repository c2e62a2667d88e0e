"""Kept results: every one once, a torn last line dropped, nobody else's file touched."""

import json

import pytest

from renderer import Scene
from renderer.grid import Checkpoint, grid, key_of
from renderer.sweep import SweepRow

TASKS = grid(Scene(), [(8, 8)], ["central"], (1e-2, 1e-3, 1e-4))
ROWS = [SweepRow(task.method.eps, 0.1 + 0.2, 1e-300, 0, number) for number, task in enumerate(TASKS)]
RESULTS = dict(zip(TASKS, ROWS, strict=True))
KEPT = {key_of(task): row for task, row in RESULTS.items()}


@pytest.fixture
def full(tmp_path):
    """A file with the three results."""
    checkpoint = Checkpoint(tmp_path / "a.jsonl")
    assert (checkpoint.rows, list(tmp_path.iterdir())) == ({}, [])
    checkpoint.append({task: RESULTS[task] for task in TASKS[:2]})
    checkpoint.append({TASKS[2]: ROWS[2]})
    assert checkpoint.rows == KEPT
    assert checkpoint.kept([*TASKS, *grid(Scene(), [(9, 9)], ["central"], (1e-2,))]) == RESULTS
    return checkpoint.path


def test_results_come_back_to_the_last_bit(full):
    assert Checkpoint(full).rows == KEPT


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
        checkpoint = Checkpoint(full)
        assert checkpoint.rows == {key_of(task): RESULTS[task] for task in TASKS[:2]}
        assert full.read_bytes() == content[:last]
    checkpoint.append({TASKS[2]: ROWS[2]})
    assert full.read_bytes() == content


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
    with pytest.raises(ValueError) as error:
        Checkpoint(full)
    allowed = f"a file of results, and its line {line} is none"
    assert str(error.value) == f"checkpoint = {str(full)!r} is not allowed: {allowed}"
    assert full.read_bytes() == before
