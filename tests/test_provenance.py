"""Where a figure comes from: the numbers beside it, the key that it is kept by, what is drawn again and why."""

import json
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure

from book.assembly import stamps
from book.drawing import draw, keys, save
from book.drawing.draw import all_figures
from book.drawing.registry import Drawing, Registered
from book.drawing.save import MOST_BYTES, data_file, read_data
from tests.processes import python

NARROW = ("verify/stability/maps.py", "renderer/picture/facts.py")  # what only some figures may reach
MODULES = sorted(path.stem for path in (stamps.ROOT / "book" / "figures").glob("*.py") if path.stem != "__init__")
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


def ours(files) -> set[str]:
    """Those of the files that are the repository's, by path from its root."""
    names = (Path(file).relative_to(stamps.ROOT).as_posix() for file in files)
    return {name for name in names if name.startswith(stamps.PACKAGES)}


@pytest.fixture(scope="module")
def imported() -> dict[str, set[str]]:
    """Module of figures → the repository's files that Python itself imports with it."""
    printed, _ = python("-c", TRACE, stamps.ROOT, *MODULES)
    return {name: ours(files) for name, files in map(json.loads, printed.splitlines())}


@pytest.fixture(scope="module")
def hashes_of_figures() -> dict[str, dict[str, str]]:
    """Figure → the hashes of its files, while no file looks edited."""
    return {id: keys.figure_hashes(entry) for id, entry in all_figures().items()}


def module_of(entry) -> str:
    return keys.source_file(entry).stem


def test_keys_have_every_module_that_python_imports(imported, hashes_of_figures):
    for entry in all_figures().values():
        python = imported[module_of(entry)]
        assert f"book/figures/{module_of(entry)}.py" in python and len(python) > 3
        assert python <= hashes_of_figures[entry.id].keys(), entry.id


def test_keys_have_records_style_and_lock(hashes_of_figures):
    for entry in all_figures().values():
        now = hashes_of_figures[entry.id].keys()
        assert {"requirements.lock", "book/drawing/matplotlibrc", "python", *entry.reads} <= now


def edited(monkeypatch, name):
    """Let a file of the repository look edited."""
    hashes = stamps.hashes
    monkeypatch.setattr(
        stamps, "hashes", lambda paths: {k: "edited" if k == name else v for k, v in hashes(paths).items()}
    )


@pytest.fixture
def drawn(hashes_of_figures, stamped, monkeypatch):
    """Every figure, as if it had just been drawn; what is drawn now."""
    monkeypatch.setattr(keys, "GENERATED", stamped / "generated")
    monkeypatch.setattr(draw, "PROCESSES", 1)
    drawings = []
    monkeypatch.setattr(save, "save", lambda entry, *rest: drawings.append(entry.id) or [])
    for id, now in hashes_of_figures.items():
        stamps.write(f"figures/{id}", {"files": [], "sources": now})
    return drawings


@pytest.mark.parametrize(
    "name",
    ["verify/stability/maps.py", "renderer/picture/facts.py", "renderer/machines/traced.py", "book/drawing/style.py",
     "book/drawing/save.py", "proofs/formulas/symbols.py", "verify/results/work_precision.json", "requirements.lock",
     "book/drawing/matplotlibrc"],
)  # fmt: skip
def test_editing_one_file_draws_all_that_reach_it_and_says_why(name, hashes_of_figures, drawn, monkeypatch, capsys):
    assert draw.draw() == 0 and drawn == []
    reach = {id for id, now in hashes_of_figures.items() if name in now}
    edited(monkeypatch, name)
    capsys.readouterr()
    assert draw.draw() == len(reach) > 0
    assert sorted(drawn) == sorted(reach)
    assert len(reach) < len(hashes_of_figures) or name not in NARROW, f"figures import too widely: {name}"
    said = capsys.readouterr().out
    assert said.count(f"({name} changed") == len(reach)
    assert f"  {len(reach)} drawn, {len(hashes_of_figures) - len(reach)} up to date" in said
    drawn.clear()
    assert draw.draw() == 0 and drawn == []  # and once is enough


def broken() -> Drawing:
    """A figure that cannot be drawn."""
    raise ZeroDivisionError("no such slope")


def test_two_processes_draw_what_one_draws(stamped, monkeypatch):
    ids, files = ("kink_loci", "views"), {}
    for processes in (1, 2):
        monkeypatch.setattr(draw, "PROCESSES", processes)
        monkeypatch.setattr(keys, "GENERATED", stamped / f"by_{processes}")
        assert draw.draw(ids, force=True) == len(ids)
        files[processes] = {path.name: path.read_bytes() for path in keys.GENERATED.iterdir()}
    assert files[1] == files[2] and len(files[1]) > len(ids)


def test_what_a_figure_raises_in_another_process_names_it(stamped, monkeypatch):
    monkeypatch.setattr(keys, "GENERATED", stamped / "generated")
    figures = {"accepted_scenes": all_figures()["accepted_scenes"], "broken": Registered("broken", broken)}
    monkeypatch.setattr(draw, "all_figures", lambda: figures)
    with pytest.raises(ZeroDivisionError, match="no such slope") as caught:
        draw.draw(force=True)
    assert caught.value.__notes__ == ["while the figure 'broken' was drawn"]
    assert stamps.read("figures/broken") is None


def line(heights) -> Figure:
    fig = Figure()
    fig.subplots().plot(range(len(heights)), heights)
    return fig


def test_columns_of_one_length_are_a_table_and_read_back_to_the_last_bit():
    third = np.array([1 / 3, 2e-308, np.nan, -0.0])
    content = data_file("f", Drawing(line(third), data={"k": [1, 2, 3, 4], "third": third, "word": list("abcd")}))
    assert list(content) == [".csv"]
    assert content[".csv"].decode().splitlines()[:2] == ["k,third,word", "1,0.3333333333333333,a"]
    back = read_data("f.csv", content[".csv"])
    assert np.array_equal(back["third"].view(np.int64), third.view(np.int64))
    assert back["word"].tolist() == list("abcd")


@pytest.mark.parametrize(
    ("heights", "data", "message"),
    [
        ([1.0], {}, "needs data="),
        (np.arange(5.0) + 0.5, {"a": np.arange(5)}, "draws a curve that is not in its data: 0.5"),
        ([1.0], {"a": [None]}, "'a' is object"),
        ([1.0], {"a": 1.0}, r"'a' is float64 of shape \(\)"),
        ([1.0], {"a": np.random.default_rng(0).random(MOST_BYTES // 8)}, "at most"),
    ],
)
def test_data_that_are_missing_or_odd_are_refused_by_the_figures_name(heights, data, message):
    with pytest.raises(ValueError, match=rf"figure 'f'.*{message}"):
        data_file("f", Drawing(line(heights), data=data))


def test_every_drawn_figure_says_where_it_comes_from(site):
    for id, entry in all_figures().items():
        description = json.loads((keys.GENERATED / f"{id}.json").read_text())
        assert (description["id"], description["function"]) == (id, entry.draw.__name__)
        assert description["key"] == stamps.key(keys.figure_hashes(entry)), f"{id} was drawn from other sources"
        if description["kind"] != "numbers":
            assert description["data"] in {f"{id}.csv", f"{id}.npz"}
            assert read_data(description["data"], (keys.GENERATED / description["data"]).read_bytes())
