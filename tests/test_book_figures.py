"""The figures' machinery: what a figure may return, what is kept, and when it is drawn again."""

import io
import json
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

from book.assembly import stamps
from book.drawing import keys, registry, save
from book.drawing.registry import Drawing, Registered, certified, plain_numbers
from book.drawing.style import colour_of, decades, label_line_end, panels, plot, slope_triangle, styled
from book.figures.chapter_scene import averaged
from renderer import Scene, central, exact, render
from renderer.picture.differences import Interval


def curve() -> Drawing:
    """A falling curve."""
    fig, ax = plot(height=2)
    steps = np.array([1e-6, 1e-3, 1.0])
    ax.plot(steps, steps**2, color=colour_of("numeric"))
    decades(ax)
    label_line_end(ax, 1.0, 1.0, "error", colour_of("numeric"))
    slope_triangle(ax, 1e-4, 1e-9, 2, "2")
    numbers = {"count": np.int64(3), "least": np.float32(0.5), "wins": np.bool_(True)}
    return Drawing(fig, numbers=numbers, data={"step": steps, "error": steps**2})


def test_figures_have_unique_ids_and_a_docstring(monkeypatch):
    monkeypatch.setattr(registry, "FIGURES", {})
    registry.figure("curve")(curve)
    with pytest.raises(ValueError, match="taken"):
        registry.figure("curve")(curve)
    with pytest.raises(ValueError, match="docstring"):
        registry.figure("plain")(lambda: Drawing())


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, None, [1], 1j, np.zeros(2)])
def test_numbers_that_say_nothing_are_refused_by_name(value):
    with pytest.raises(ValueError, match="figure 'f': number 'rms'"):
        plain_numbers("f", {"rms": value})


def test_a_number_is_kept_with_its_ends():
    numbers = plain_numbers("f", {"sine": {"rms": Interval(0.5, 0.4, 0.6)}})
    assert numbers == {"sine_rms": 0.5, "sine_rms_lower": 0.4, "sine_rms_upper": 0.6}


def test_what_is_certain_of_the_frames_that_a_picture_shows():
    scene = Scene(ball=False)
    one, other = (render(scene, 24, 24, method, bounds=True) for method in (exact(), central(1e-3)))
    assert certified(()) is None
    found = certified((one, other))
    assert found["within"] >= max(one.bounds.max(), other.bounds.max()) > 0.9 * found["within"]
    assert found["undecided"] == 0
    some = SimpleNamespace(bounds=one.bounds, open=np.arange(576).reshape(24, 24) < 5)
    assert certified((some,))["undecided"] == 5
    with pytest.raises(ValueError, match="bounds = None is not allowed: a frame drawn by render"):
        certified((render(scene, 24, 24),))


def test_plot_is_saved_light_and_dark_and_the_same_each_time(tmp_path):
    entry = Registered("curve", curve)
    names = save.save(entry, tmp_path, "book/figures/x.py", "key")
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(names)
    light, dark = (tmp_path / f"curve{suffix}" for suffix in (".svg", ".dark.svg"))
    assert light.read_bytes() != dark.read_bytes()
    assert 'width="480pt"' in light.read_text()  # 640 CSS pixels: the text column
    description = json.loads((tmp_path / "curve.json").read_text())
    assert description["numbers"] == {"count": 3, "least": 0.5, "wins": True}
    assert (description["size"], description["about"]) == ([640, 192], "A falling curve.")
    before = light.read_bytes()
    save.save(entry, tmp_path, "book/figures/x.py", "key")
    assert light.read_bytes() == before


def test_render_is_saved_at_its_own_pixels_and_numbers_need_no_picture(tmp_path):
    pixels = np.arange(4 * 5 * 3, dtype=np.uint8).reshape(4, 5, 3)
    save.save(Registered("render", lambda: Drawing(pixels)), tmp_path, "x.py", "key")
    assert np.array_equal(np.asarray(Image.open(tmp_path / "render.png")), pixels)
    assert save.save(Registered("table", lambda: Drawing(numbers={"n": 1})), tmp_path, "x.py", "key") == ["table.json"]


@pytest.mark.parametrize("picture", [np.zeros((2, 2, 3)), np.zeros((2, 2), np.uint8), "a.png"])
def test_other_pictures_are_refused(tmp_path, picture):
    with pytest.raises((TypeError, AttributeError), match="uint8"):
        save.save(Registered("odd", lambda: Drawing(picture)), tmp_path, "x.py", "key")
    assert list(tmp_path.iterdir()) == []


def test_panels_show_every_pixel_once_at_the_size_of_a_css_pixel():
    rng = np.random.default_rng(0)
    image = rng.integers(0, 256, (32, 48, 3), dtype=np.uint8)
    with styled():
        fig = panels([image, image], ["numeric", "symbolic"])
    buffer = io.BytesIO()
    fig.savefig(buffer, format="png", dpi=96)
    shown = np.asarray(Image.open(buffer).convert("RGB"))
    assert np.array_equal(shown[24 : 24 + 32, :48], image)
    assert np.array_equal(shown[24 : 24 + 32, 60 : 60 + 48], image)


def test_computed_import_reaches_the_whole_package():
    reached = stamps.reachable(stamps.ROOT / "book" / "drawing" / "draw.py")
    assert {path for path in stamps.files_in(stamps.ROOT / "book") if path.suffix == ".py"} <= reached


def test_reason_to_draw_again(stamped, monkeypatch):
    monkeypatch.setattr(keys, "GENERATED", stamped)
    entry, before = Registered("curve", curve), {"book/drawing/style.py": "0", "python": "3.11"}
    assert keys.why_redraw(entry, before) == "new"
    stamps.write("figures/curve", {"files": ["curve.svg"], "sources": before})
    assert keys.why_redraw(entry, before) == "curve.svg is missing"
    (stamped / "curve.svg").touch()
    assert keys.why_redraw(entry, before) is None
    assert keys.why_redraw(entry, before | {"book/new.py": "1", "python": "3.12"}) == "book/new.py changed and 1 more"


def test_an_averaged_picture_has_smooth_edges_and_the_same_light():
    picture = np.zeros((6, 6, 3), np.uint8)
    picture[:, 4:] = 240
    small = averaged(picture, 3)
    assert small.shape == (2, 2, 3) and (small[:, 0] == 0).all() and (small[:, 1] == 160).all()
    assert small.mean() == picture.mean()
