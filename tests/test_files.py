"""Files are whole or not there at all."""

import os
import signal
import zlib
from io import BytesIO
from pathlib import Path
from unittest.mock import Mock
from zipfile import ZIP_STORED

import numpy as np
import pytest
import tifffile
from PIL import Image

from renderer import Scene, central, render, whole_files
from renderer.command_line.verbs import main
from renderer.files import pictures as files
from renderer.machines import numpy_rows
from renderer.picture import views
from renderer.whole_files import whole_file
from tests.folders import contents
from tests.pictures import shows
from tests.processes import started
from tests.refusals import rejection

FRAME = render(Scene(), 24, 16, central(1e-3))
PICTURE = views.image_view(FRAME)


@pytest.mark.parametrize("name", ["A.PNG", "a.npz", "a.Npy", "a.TIF", "a.tiff"])
def test_a_frame_saves_itself_or_leaves_nothing_or_the_old_file(name, tmp_path, monkeypatch):
    """It fails in the renaming, which is last; then it does not, and has the permissions of any other file."""
    path, other = tmp_path / name, tmp_path / "other"
    with monkeypatch.context() as patched:
        patched.setattr("os.replace", Mock(side_effect=KeyboardInterrupt))
        for before in ({}, {name: b"old"}):
            for text in before.values():
                path.write_bytes(text)
            with pytest.raises(KeyboardInterrupt):
                FRAME.save(path)
            assert contents(tmp_path) == before
    FRAME.save(path)
    other.write_text("")
    assert path.stat().st_mode == other.stat().st_mode
    assert {*tmp_path.iterdir()} == {path, other}
    assert shows(path, FRAME)
    if name == "a.npz":
        arrays = np.load(path)
        assert (arrays["chambers"] == FRAME.chambers).all()
        assert (arrays["u"] == FRAME.surface_data["u"][arrays["chambers"] & 3 == 1]).all()
        assert {member.compress_type for member in arrays.zip.infolist()} == {ZIP_STORED}


@pytest.mark.parametrize("library", [files.zlib, zlib])
@pytest.mark.parametrize("noise", [1, 256])
@pytest.mark.parametrize("shape", [(1, 1, 3), (3, 5, 4), (40, 30, 1), (311, 997, 3), (7, 90_001, 3)])
def test_a_png_has_every_pixel(shape, noise, library, monkeypatch):
    """Read it by another program, written by one thread or several, in bands that do not divide it or of one row."""
    monkeypatch.setattr(files, "zlib", library)
    smooth = np.indices(shape[:2]).sum(axis=0)[..., None] // 7
    picture = ((smooth + np.random.default_rng(1).integers(0, noise, shape)) % 256).astype(np.uint8)
    written = files.png_of(picture, "told", threads=1)
    assert files.png_of(picture, "told", threads=5) == written
    monkeypatch.setattr(files, "machine", lambda: numpy_rows)
    assert files.png_of(picture, "told") == written
    with Image.open(BytesIO(written)) as read:
        assert read.info["symbolic-rendering"] == "told"
        np.testing.assert_array_equal(np.asarray(read).reshape(shape), picture)


def test_a_frame_is_an_array_and_says_what_it_is():
    assert np.asarray(FRAME).dtype == np.float64 and np.shares_memory(np.asarray(FRAME), FRAME.planes)
    assert not np.shares_memory(np.array(FRAME), FRAME.planes)
    assert (np.asarray(Image.open(BytesIO(FRAME.to_png()))) == PICTURE).all()
    assert FRAME.srgb.dtype == np.uint8 and (FRAME.srgb == PICTURE).all()
    assert FRAME.shape == FRAME.rgb.shape == (16, 24, 3)
    other = render(Scene(), 24, 16)
    assert ((FRAME - other == FRAME.rgb - other.rgb) & (other - FRAME == other.rgb - FRAME.rgb)).all()
    assert repr(FRAME) == f"Frame({FRAME.raster}, {FRAME.method}, Scene())"


@pytest.mark.parametrize("numbers", ["float32", "float64"])
def test_a_tiff_of_linear_light_has_its_numbers(numbers, tmp_path):
    FRAME.save(tmp_path / "a.tif", linear=numbers)
    command = ["image", "--width", "24", "--height", "16", "--gradient", "central", "--linear", numbers]
    assert main([*command, "--out", str(tmp_path / "b.tif")]) == 0
    for name in ("a.tif", "b.tif"):
        read = tifffile.imread(tmp_path / name)
        assert read.dtype == numbers and (read == FRAME.rgb.astype(numbers)).all()


def test_saving_over_a_file_keeps_its_links_and_mode_and_asks_whether_it_may_be_written(tmp_path):
    place, link, pipe = (tmp_path / name for name in ("new.png", "link.png", "pipe.png"))
    link.symlink_to(place)
    FRAME.save(link)  # which leads to nothing yet
    place.write_bytes(b"")
    place.chmod(0o606)
    (tmp_path / "other").hardlink_to(place)
    with pytest.warns(UserWarning, match="other names"):
        FRAME.save(link)
    assert link.is_symlink() and shows(place, FRAME) and place.stat().st_mode & 0o777 == 0o606
    place.chmod(0o440)
    os.mkfifo(pipe)
    for path in (link, pipe):
        assert "it is read-only, or no regular file" in rejection(FRAME.save, path)
        with pytest.raises(OSError, match="read-only"):
            whole_files.write_whole(path)


WRITE_FOR_EVER = """
import sys, time
from renderer.whole_files import whole_file
with whole_file(sys.argv[1]) as name:
    with open(name, "w") as file:
        file.write("half")
    print(name, flush=True)
    time.sleep(60)
"""


def test_what_a_killed_writer_left_is_removed_by_the_next_one(tmp_path):
    """Leave alone a file that somebody else named, and one that another process or this one is writing."""
    others = [tmp_path / name for name in (".a-12345678.npy", ".hidden", "a-12345678-unfinished.npy")]
    for path in others:
        path.write_text("somebody's")
    with started("-c", WRITE_FOR_EVER, tmp_path / "a.npy") as child:
        left = Path(child.stdout.readline().strip())
        with whole_file(tmp_path / "b.png") as first, whole_file(tmp_path / "b.png") as other:
            Path(first).write_text("one")
            Path(other).write_text("other")
        assert left.read_text() == "half"  # its writer lives
        child.send_signal(signal.SIGKILL)
    assert left.exists()
    files.write_png(tmp_path / "c.png", PICTURE)
    assert {*tmp_path.iterdir()} == {*others, tmp_path / "b.png", tmp_path / "c.png"}
    assert (tmp_path / "b.png").read_text() == "one"


def test_a_file_that_is_removed_before_it_is_locked_is_made_again(tmp_path, monkeypatch):
    lock, locked = whole_files.fcntl.flock, []

    def slow(file, kind):
        if not locked:
            Path(file.name).unlink()
        locked.append(file.name)
        lock(file, kind)

    monkeypatch.setattr(whole_files.fcntl, "flock", slow)
    with whole_file(tmp_path / "a.csv") as name:
        assert Path(name).exists()
    assert len(set(locked)) == 2
    assert [*contents(tmp_path)] == ["a.csv"]


REFUSING = Mock(side_effect=OSError("no locks available"))


@pytest.mark.parametrize("place, name, value", [(whole_files, "fcntl", None), (whole_files.fcntl, "flock", REFUSING)])
def test_without_locks_a_file_is_written_all_the_same(place, name, value, tmp_path, monkeypatch):
    """Keep an unfinished file that no lock can be had of: it may be somebody's. Without locks on the system it goes."""
    monkeypatch.setattr(place, name, value)
    left = tmp_path / ".b-12345678-unfinished.csv"
    left.write_text("half")
    FRAME.save(tmp_path / "a.npy")
    assert shows(tmp_path / "a.npy", FRAME)
    assert left.exists() is (name == "flock")
