"""The figures: what one may return, what is kept of it, by what key, and what is drawn again and why."""

import json
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure
from PIL import Image

from book.assembly import stamps
from book.drawing import draw, save, style
from book.drawing.registry import Drawing, Registered, certified, plain_numbers
from book.drawing.style import plot
from renderer import Scene, central, exact, render
from renderer.intervals import Interval
from tests.pictures import contents
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


def curve():
    """A falling curve."""
    fig, ax = plot(height=2)
    steps = np.array([1e-6, 1e-3, 1.0])
    style.curve(ax, steps, steps**2, "numeric", label="error")
    return Drawing(fig, numbers={"count": np.int64(3), "least": np.float32(0.5)})


def saved(folder, id, function):
    """Save a figure; the names of its files."""
    return save.save(Registered(id, function), folder, "x.py", "key")


def test_a_number_is_kept_with_its_ends_and_one_that_says_nothing_is_refused_by_name():
    numbers = plain_numbers("f", {"sine": {"rms": Interval(0.5, 0.4, 0.6)}})
    assert numbers == {"sine_rms": 0.5, "sine_rms_lower": 0.4, "sine_rms_upper": 0.6}
    for value in (np.nan, np.inf, None, [1], 1j):
        with pytest.raises(ValueError, match="figure 'f': number 'rms'"):
            plain_numbers("f", {"rms": value})


def test_what_is_certain_of_the_frames_that_a_picture_shows():
    frames = [render(Scene(ball=False), 24, 24, method, bounds=True) for method in (exact(), central(1e-3))]
    most = max(frame.bounds.max() for frame in frames)
    assert certified(()) is None
    assert most <= certified(frames)["within"] < 1.1 * most and certified(frames)["undecided"] == 0


def test_plot_is_saved_light_and_dark_and_the_same_each_time(tmp_path):
    names = saved(tmp_path, "curve", curve)
    before = contents(tmp_path)
    assert sorted(before) == sorted(names)
    assert before["curve.svg"] != before["curve.dark.svg"]
    description = json.loads(before["curve.json"])
    assert (description["numbers"], description["about"]) == ({"count": 3, "least": 0.5}, "A falling curve.")
    saved(tmp_path, "curve", curve)
    assert contents(tmp_path) == before


def test_render_is_saved_at_its_own_pixels_numbers_need_no_picture_and_others_are_refused(tmp_path):
    pixels = np.arange(4 * 5 * 3, dtype=np.uint8).reshape(4, 5, 3)
    saved(tmp_path, "render", lambda: Drawing(pixels))
    assert np.array_equal(np.asarray(Image.open(tmp_path / "render.png")), pixels)
    assert saved(tmp_path, "table", lambda: Drawing(numbers={"n": 1})) == ["table.json"]
    for picture in (pixels / 255, pixels[0]):
        with pytest.raises(TypeError, match="uint8"):
            saved(tmp_path, "odd", lambda picture=picture: Drawing(picture))
    assert not [*tmp_path.glob("odd.*")]


def test_reason_to_draw_again(stamped, monkeypatch):
    monkeypatch.setattr(draw, "GENERATED", stamped)
    entry, before = Registered("curve", curve), {"book/drawing/style.py": "0", "python": "3.11"}
    assert draw.why_redraw(entry, before) == "new"
    stamps.write("figures/curve", {})
    assert draw.why_redraw(entry, before) == "interrupted"
    path = stamped / "curve.svg"
    path.write_text("<svg>")
    stamps.write("figures/curve", {"files": draw.files_of([path.name]), "sources": before})
    assert draw.why_redraw(entry, before) is None
    assert draw.why_redraw(entry, before | {"book/new.py": "1"}) == "book/new.py changed"
    path.write_text("<sv")
    assert draw.why_redraw(entry, before) == "curve.svg changed"


INTERRUPTED = """
import os, signal, sys
from pathlib import Path
from book.__main__ import main, stamps
from book.drawing import draw

stamps.STAMPS = draw.GENERATED = Path(sys.argv[1])
draw.zip = lambda *lists, strict: os.killpg(0, signal.SIGINT) or zip(*lists, strict=strict)
sys.exit(main(["figures", "crease", "edited_formulas"]))
"""


def test_drawing_that_is_interrupted_ends_in_one_line_and_says_so_next_time(tmp_path):
    """Ctrl-C reaches every process, when the others have begun."""
    _, told = python("-c", INTERRUPTED, tmp_path, status=130, start_new_session=True)
    assert told == "book: interrupted\n"
    assert (tmp_path / "figures" / "crease.json").read_text() == "{}\n"


# Where a figure comes from


@pytest.fixture(scope="module")
def hashes_of_figures():
    """Figure → the hashes of its files, while no file looks edited."""
    return {id: draw.figure_hashes(entry) for id, entry in draw.all_figures().items()}


def test_a_key_has_what_python_imports_and_the_record_that_is_read(hashes_of_figures):
    modules = {draw.source_file(entry).stem for entry in draw.all_figures().values()}
    printed, _ = python("-c", TRACE, stamps.ROOT, *modules)
    imported = dict(map(json.loads, printed.splitlines()))
    for id, entry in draw.all_figures().items():
        source = draw.source_file(entry)
        names = [Path(file).relative_to(stamps.ROOT).as_posix() for file in imported[source.stem]]
        ours = {name for name in names if name.startswith(stamps.PACKAGES)}
        assert source.relative_to(stamps.ROOT).as_posix() in ours and len(ours) > 3
        ours |= {"requirements.lock", "book/drawing/matplotlibrc", "python", *entry.reads}
        assert ours <= hashes_of_figures[id].keys(), id


def broken():
    """A figure that cannot be drawn."""
    raise ZeroDivisionError("no such slope")


def test_two_processes_name_the_figure_that_raises(stamped, monkeypatch):
    figures = {"edited_formulas": draw.all_figures()["edited_formulas"], "broken": Registered("broken", broken)}
    monkeypatch.setattr(draw, "GENERATED", stamped)
    monkeypatch.setattr(draw, "all_figures", lambda: figures)
    with pytest.raises(ZeroDivisionError, match="no such slope") as caught:
        draw.draw()
    assert caught.value.__notes__ == ["while the figure 'broken' was drawn"]
    assert not stamps.read("figures/broken")


def line(heights, label):
    fig = Figure()
    fig.subplots().plot(range(len(heights)), heights, label=label)
    return fig


def test_curves_are_a_table_that_reads_back_to_the_last_bit_and_arrays_have_them_beside_them():
    third = np.array([1 / 3, 2e-308, np.nan, -0.0, 1.0])
    content = save.data_file("f", Drawing(line(third, "a\nthird")))[".csv"].decode()
    assert content.splitlines()[:2] == ["curve,x,y", "a third,0.0,0.3333333333333333"]
    assert b"curve 1,4.0,1.0" in save.data_file("f", Drawing(line(third, None)))[".csv"]
    back = np.array([float(row.split(",")[-1]) for row in content.splitlines()[1:]])
    assert np.array_equal(back.view(np.int64), third.view(np.int64))
    with np.load(
        BytesIO(save.data_file("f", Drawing(line(third, "b"), data={"word": list("abcd")}))[".npz"])
    ) as arrays:
        assert arrays["b"][1, :2].tolist() == [1 / 3, 2e-308] and arrays["word"].tolist() == list("abcd")


def test_data_that_are_missing_or_odd_are_refused_by_the_figures_name():
    for drawing, message in (
        (Drawing(line([1.0], "_")), "needs data="),
        (Drawing(line([1.0], "a"), data={"a": [None]}), "'a' is object"),
        (Drawing(line([1.0], "a"), data={"b": 1.0}), r"'b' is float64 of shape \(\)"),
        (Drawing(line(np.random.default_rng(0).random(save.MOST_BYTES // 8), "a")), "at most"),
    ):
        with pytest.raises(ValueError, match=rf"figure 'f'.*{message}"):
            save.data_file("f", drawing)
    twice = line(np.arange(5.0), "a")
    twice.axes[0].plot(range(5), range(5), label="a")
    with pytest.raises(ValueError, match="figure 'f': two curves are called 'a'"):
        save.data_file("f", Drawing(twice))
