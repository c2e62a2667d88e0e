"""Files are whole or not there at all."""

import os
import stat
import zlib
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from renderer import Scene, central, render
from renderer.files import pictures as files
from renderer.picture import views
from renderer.whole_files import checked_target, whole_file
from tests.folders import contents
from tests.refusals import rejection

FRAME = render(Scene(), 24, 16, central(1e-3))
PICTURE = views.image_view(FRAME)


class Interruption(BaseException):
    """What happens in the middle of a file: an error, or Ctrl-C."""


@pytest.mark.parametrize("old", [[], [b"old"]])
@pytest.mark.parametrize("name", ["png", "npz", "npy", "tif"])
def test_a_failure_leaves_nothing_or_the_old_file(name, old, tmp_path, monkeypatch):
    """In the renaming, which is last: the content has been written elsewhere."""

    def stop(*arguments):
        raise Interruption

    monkeypatch.setattr("os.replace", stop)
    for text in old:
        (tmp_path / f"a.{name}").write_bytes(text)
    with pytest.raises(Interruption):
        FRAME.save(tmp_path / f"a.{name}")
    assert [path.read_bytes() for path in tmp_path.iterdir()] == old


@pytest.mark.parametrize("noise", [1, 256])
@pytest.mark.parametrize("shape", [(1, 1, 3), (3, 5, 4), (40, 30, 1), (311, 997, 3), (7, 90_001, 3), (700, 1, 1)])
def test_a_png_has_every_pixel(shape, noise):
    """As another program reads it, by one thread or several: bands that do not divide it, and rows of one band each."""
    random, (rows, columns, _) = np.random.default_rng(1), shape
    smooth = np.add.outer(np.arange(rows), np.arange(columns))[..., None] // 7
    picture = ((smooth + random.integers(0, noise, shape)) % 256).astype(np.uint8)
    written = files.png_of(picture, "told", threads=1)
    assert {files.png_of(picture, "told", threads) for threads in (2, 5, None)} == {written}
    with Image.open(BytesIO(written)) as read:
        assert read.mode == {1: "L", 3: "RGB", 4: "RGBA"}[shape[2]]
        assert read.info["srgb"] == 0 and read.info["symbolic-rendering"] == "told"
        np.testing.assert_array_equal(np.asarray(read).reshape(shape), picture)


@pytest.mark.parametrize("kind", ["drawn", "noisy", "random", "repeating"])
def test_a_png_is_hardly_larger_than_by_level_six(kind):
    """Than rows of differences to the row above, searched as zlib does where nobody says how."""
    random, picture = np.random.default_rng(28), views.image_view(render(Scene(), 512, 512))
    if kind == "noisy":
        picture = views.to_bytes(random.normal(picture / 255, 0.05))
    elif kind != "drawn":
        side = 512 if kind == "random" else 16
        picture = np.tile(random.integers(0, 256, (side, side, 3), np.uint8), (512 // side, 512 // side, 1))
    rows = np.diff(picture.reshape(512, -1), axis=0, prepend=np.uint8(0))
    assert len(files.png_of(picture)) < (1.5 if kind == "repeating" else 1.15) * len(zlib.compress(rows, 6))


def test_checksums_are_combined():
    """Beyond where either half of one is reduced."""
    whole = bytes(np.random.default_rng(1).integers(200, 256, 10**5, np.uint8))
    for cut in (0, 1, 5552, 65521, 99_999, 10**5):
        one, other = zlib.adler32(whole[:cut]), zlib.adler32(whole[cut:])
        assert files.adler32_combined(one, other, 10**5 - cut) == zlib.adler32(whole)


@pytest.mark.parametrize("name", ["a.png", "A.PNG", "a.Npy", "a.npz", "a.TIF", "a.tiff"])
def test_a_frame_saves_itself(name, tmp_path):
    FRAME.save(tmp_path / name)
    if name.lower().endswith(("npy", "npz")):
        kept, expected = np.load(tmp_path / name), FRAME.rgb
    else:
        kept, expected = np.asarray(Image.open(tmp_path / name)), PICTURE
    assert np.array_equal(kept["rgb"] if name.endswith("npz") else kept, expected)
    assert [path.name for path in tmp_path.iterdir()] == [name]


def test_a_frame_is_an_array_and_says_what_it_is():
    assert np.asarray(FRAME).dtype == np.float64 and np.shares_memory(np.asarray(FRAME), FRAME.planes)
    assert not np.shares_memory(np.array(FRAME), FRAME.planes)
    np.testing.assert_array_equal(np.asarray(FRAME, np.float32), FRAME.rgb.astype(np.float32))
    with pytest.raises(ValueError, match="copy"):
        np.asarray(FRAME, np.float32, copy=False)
    np.testing.assert_array_equal(np.asarray(Image.open(BytesIO(FRAME._repr_png_()))), PICTURE)
    scene = "Scene(field='sine', beta=0.1)"
    frame = render(eval(scene), 24, 16, central(1e-3), (0, 0, 9, 8))
    assert repr(frame) == f"Frame({frame.raster}, {frame.method}, {scene})"
    assert repr(frame.stage).startswith(f"Stage({frame.raster}, Geometry(eye=4.0, ") and "\n" not in repr(frame.stage)


def test_files_of_the_same_process_are_left_alone(tmp_path):
    with whole_file(tmp_path / "a.csv") as one, whole_file(tmp_path / "a.csv") as other:
        assert one != other
        Path(one).write_text("one")
        Path(other).write_text("other")
    assert contents(tmp_path) == {"a.csv": b"one"}


def test_a_file_has_the_permissions_of_any_other(tmp_path):
    files.write_png(tmp_path / "a.png", PICTURE)
    (tmp_path / "b").write_text("")
    assert stat.S_IMODE((tmp_path / "a.png").stat().st_mode) == stat.S_IMODE((tmp_path / "b").stat().st_mode)


@pytest.mark.parametrize(
    ("name", "allowed"),
    [
        ("a.jpg", "a file name that ends in .png or .npz"),
        (".png", "a file name that ends in .png or .npz"),
        ("folder.png", "a file in a folder that exists"),
        ("file/a.png", "a file in a folder that exists"),
        ("a" * 300 + ".png", "a file that can be written (File name too long)"),
        ("a\0.png", "a name without the character 0"),
    ],
)
def test_a_target_that_is_rejected(name, allowed, tmp_path):
    (tmp_path / "folder.png").mkdir()
    (tmp_path / "file").write_text("")
    said = rejection(checked_target, tmp_path / name, files.PICTURE_SUFFIXES)
    assert said == f"out = {str(tmp_path / name)!r} is not allowed: {allowed}"


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
def test_a_folder_that_is_read_only(tmp_path):
    tmp_path.chmod(0o500)
    said = rejection(checked_target, tmp_path / "a.png", files.PICTURE_SUFFIXES)
    assert said.endswith("is not allowed: a file that can be written (Permission denied)")


def test_checking_a_target_leaves_nothing_and_the_old_file(tmp_path):
    (tmp_path / "a.png").write_bytes(b"old")
    assert checked_target(tmp_path / "a.png", files.PICTURE_SUFFIXES) == tmp_path / "a.png"
    assert checked_target(str(tmp_path / "b.npz"), files.PICTURE_SUFFIXES) == tmp_path / "b.npz"
    assert contents(tmp_path) == {"a.png": b"old"}
