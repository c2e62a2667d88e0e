"""The figures' machinery: what a figure may return, what is kept, and when it is drawn again."""

import json
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

from book.assembly import stamps
from book.drawing import draw, registry, save
from book.drawing.registry import Drawing, Registered, certified, plain_numbers
from book.drawing.style import colour_of, plot
from renderer import Scene, central, exact, render
from renderer.picture.differences import Interval
from tests.folders import contents


def curve():
    """A falling curve."""
    fig, ax = plot(height=2)
    steps = np.array([1e-6, 1e-3, 1.0])
    ax.plot(steps, steps**2, color=colour_of("numeric"))
    numbers = {"count": np.int64(3), "least": np.float32(0.5)}
    return Drawing(fig, numbers=numbers, data={"step": steps, "error": steps**2})


def saved(folder, id, function):
    """Save a figure; the names of its files."""
    return save.save(Registered(id, function), folder, "x.py", "key")


def test_figures_have_unique_ids_and_a_docstring(monkeypatch):
    monkeypatch.setattr(registry, "FIGURES", {})
    registry.figure("curve")(curve)
    for id, drawn, why in (("curve", curve, "taken"), ("plain", lambda: Drawing(), "docstring")):
        with pytest.raises(ValueError, match=why):
            registry.figure(id)(drawn)


def test_a_number_is_kept_with_its_ends_and_one_that_says_nothing_is_refused_by_name():
    numbers = plain_numbers("f", {"sine": {"rms": Interval(0.5, 0.4, 0.6)}})
    assert numbers == {"sine_rms": 0.5, "sine_rms_lower": 0.4, "sine_rms_upper": 0.6}
    for value in (np.nan, np.inf, -np.inf, None, [1], 1j, np.zeros(2)):
        with pytest.raises(ValueError, match="figure 'f': number 'rms'"):
            plain_numbers("f", {"rms": value})


def test_what_is_certain_of_the_frames_that_a_picture_shows():
    frames = [render(Scene(ball=False), 24, 24, method, bounds=True) for method in (exact(), central(1e-3))]
    most = max(frame.bounds.max() for frame in frames)
    assert certified(()) is None
    assert most <= certified(frames)["within"] < 1.1 * most and certified(frames)["undecided"] == 0
    some = SimpleNamespace(bounds=frames[0].bounds, open=np.arange(576).reshape(24, 24) < 5)
    assert certified((some,))["undecided"] == 5


def test_plot_is_saved_light_and_dark_and_the_same_each_time(tmp_path):
    names = saved(tmp_path, "curve", curve)
    before = contents(tmp_path)
    assert sorted(before) == sorted(names)
    assert before["curve.svg"] != before["curve.dark.svg"]
    assert b'width="480pt"' in before["curve.svg"]  # 640 CSS pixels: the text column
    description = json.loads(before["curve.json"])
    assert description["numbers"] == {"count": 3, "least": 0.5}
    assert (description["size"], description["about"]) == ([640, 192], "A falling curve.")
    saved(tmp_path, "curve", curve)
    assert contents(tmp_path) == before


def test_render_is_saved_at_its_own_pixels_numbers_need_no_picture_and_others_are_refused(tmp_path):
    pixels = np.arange(4 * 5 * 3, dtype=np.uint8).reshape(4, 5, 3)
    saved(tmp_path, "render", lambda: Drawing(pixels))
    assert np.array_equal(np.asarray(Image.open(tmp_path / "render.png")), pixels)
    assert saved(tmp_path, "table", lambda: Drawing(numbers={"n": 1})) == ["table.json"]
    before = contents(tmp_path)
    for picture in (pixels / 255, pixels[0], "a.png"):
        with pytest.raises((TypeError, AttributeError), match="uint8"):
            saved(tmp_path, "odd", lambda picture=picture: Drawing(picture))
    assert contents(tmp_path) == before


def test_reason_to_draw_again(stamped, monkeypatch):
    monkeypatch.setattr(draw, "GENERATED", stamped)
    entry, before = Registered("curve", curve), {"book/drawing/style.py": "0", "python": "3.11"}
    assert draw.why_redraw(entry, before) == "new"
    stamps.write("figures/curve", {"files": ["curve.svg"], "sources": before})
    assert draw.why_redraw(entry, before) == "curve.svg is missing"
    (stamped / "curve.svg").touch()
    assert draw.why_redraw(entry, before) is None
    assert draw.why_redraw(entry, before | {"book/new.py": "1", "python": "3.12"}) == "book/new.py changed and 1 more"
