"""Where a figure comes from: the numbers beside it, the key that it is kept by, what is drawn again and why."""

import json
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure

from book.assembly import stamps
from book.drawing import draw, save
from book.drawing.draw import all_figures
from book.drawing.registry import Drawing, Registered
from book.drawing.save import MOST_BYTES, data_file, read_data
from tests.folders import contents
from tests.processes import python

# In a process that has none of the repository's modules, and for each figure module a child of it that has not either.
TRACE = """
import json, os, sys
import flint, llvmlite, matplotlib.figure, mpmath, numpy, PIL.Image, sympy, tqdm
root, *names = sys.argv[1:]
assert not any(str(getattr(m, "__file__", "")).startswith(root + "/book") for m in sys.modules.values())
for name in names:
    if os.fork() == 0:
        __import__(f"book.figures.{name}")
        files = {getattr(m, "__file__", None) or "" for m in list(sys.modules.values())}
        print(json.dumps([name, sorted(f for f in files if f.startswith(root + "/"))]), flush=True)
        os._exit(0)
    assert os.wait()[1] == 0
"""


@pytest.fixture(scope="module")
def hashes_of_figures():
    """Figure → the hashes of its files, while no file looks edited."""
    return {id: draw.figure_hashes(entry) for id, entry in all_figures().items()}


def test_a_key_has_what_python_imports_and_the_record_that_is_read(hashes_of_figures):
    modules = {draw.source_file(entry).stem for entry in all_figures().values()}
    printed, _ = python("-c", TRACE, stamps.ROOT, *modules)
    imported = dict(map(json.loads, printed.splitlines()))
    for id, entry in all_figures().items():
        own = draw.source_file(entry)
        names = [Path(file).relative_to(stamps.ROOT).as_posix() for file in imported[own.stem]]
        ours = {name for name in names if name.startswith(stamps.PACKAGES)}
        assert own.relative_to(stamps.ROOT).as_posix() in ours and len(ours) > 3
        ours |= {"requirements.lock", "book/drawing/matplotlibrc", "python", *entry.reads}
        assert ours <= hashes_of_figures[id].keys(), id


def test_editing_one_file_draws_all_that_reach_it_and_says_why(hashes_of_figures, stamped, monkeypatch, capsys):
    drawn, edited, hashes = [], set(), stamps.hashes
    monkeypatch.setattr(draw, "GENERATED", stamped / "generated")
    monkeypatch.setattr(draw, "PROCESSES", 1)
    monkeypatch.setattr(save, "save", lambda entry, *rest: drawn.append(entry.id) or [])
    monkeypatch.setattr(
        stamps, "hashes", lambda paths: {k: "edited" if k in edited else v for k, v in hashes(paths).items()}
    )
    for id, now in hashes_of_figures.items():
        stamps.write(f"figures/{id}", {"files": [], "sources": now})
    narrow = ("verify/stability/maps.py", "renderer/picture/facts.py")  # what only some figures may reach
    for name in (*narrow, "verify/results/work_precision.json", "book/drawing/matplotlibrc"):
        assert draw.draw() == 0 and drawn == []  # once is enough
        reach = {id for id, now in hashes_of_figures.items() if name in now}
        assert len(reach) < len(hashes_of_figures) or name not in narrow, f"figures import too widely: {name}"
        edited.add(name)
        capsys.readouterr()
        assert draw.draw() == len(reach) > 0
        assert sorted(drawn) == sorted(reach)
        drawn.clear()
        assert capsys.readouterr().out.count(f"({name} changed") == len(reach)


def broken():
    """A figure that cannot be drawn."""
    raise ZeroDivisionError("no such slope")


def test_two_processes_draw_what_one_draws_and_name_the_figure_that_raises(stamped, monkeypatch):
    figures = {id: all_figures()[id] for id in ("accepted_scenes", "crease")}

    def drawn(processes):
        monkeypatch.setattr(draw, "PROCESSES", processes)
        monkeypatch.setattr(draw, "GENERATED", stamped / f"by_{processes}")
        draw.draw(force=True)

    monkeypatch.setattr(draw, "all_figures", lambda: figures)
    drawn(1)
    figures["broken"] = Registered("broken", broken)
    with pytest.raises(ZeroDivisionError, match="no such slope") as caught:
        drawn(2)
    assert caught.value.__notes__ == ["while the figure 'broken' was drawn"]
    assert stamps.read("figures/broken") is None
    one, two = (contents(stamped / f"by_{processes}") for processes in (1, 2))
    assert one == two and len(one) > 2


def line(heights):
    fig = Figure()
    fig.subplots().plot(range(len(heights)), heights)
    return fig


def test_columns_of_one_length_are_a_table_and_read_back_to_the_last_bit():
    third = np.array([1 / 3, 2e-308, np.nan, -0.0])
    content = data_file("f", Drawing(line(third), data={"third": third, "word": list("abcd")}))
    assert content[".csv"].decode().splitlines()[:2] == ["third,word", "0.3333333333333333,a"]
    back = read_data("f.csv", content[".csv"])
    assert np.array_equal(back["third"].view(np.int64), third.view(np.int64))
    assert back["word"].tolist() == list("abcd")


def test_data_that_are_missing_or_odd_are_refused_by_the_figures_name():
    for data, message in (
        ({}, "needs data="),
        ({"a": np.arange(5)}, "draws a curve that is not in its data: 0.5"),
        ({"a": [None]}, "'a' is object"),
        ({"a": 1.0}, r"'a' is float64 of shape \(\)"),
        ({"a": np.random.default_rng(0).random(MOST_BYTES // 8)}, "at most"),
    ):
        with pytest.raises(ValueError, match=rf"figure 'f'.*{message}"):
            data_file("f", Drawing(line(np.arange(5.0) + 0.5 if "curve" in message else [1.0]), data=data))
