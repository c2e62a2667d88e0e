"""Files are whole or not there at all, streamed ones too; and what the eye sees of a frame."""

import os
import signal
import zlib
from functools import partial
from io import BytesIO
from pathlib import Path
from unittest.mock import Mock
from zipfile import ZIP_STORED

import matplotlib
import numpy as np
import pytest
import tifffile
from PIL import Image

from renderer import Scene, central, render, whole_files
from renderer.command_line.verbs import main
from renderer.files import pictures as files, srgb
from renderer.machines import numpy_rows
from renderer.picture import stream, views
from renderer.scene.raster import MAX_SIDE
from renderer.whole_files import whole_file
from tests.pictures import contents, shows
from tests.processes import python, started
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


# Streamed pictures: the same numbers as `render`, in bounded memory; and signals

PICTURES = [((37, 53), None), ((701, 5), None), ((1, 1), None), ((MAX_SIDE, MAX_SIDE), (2**23, 2**23 - 3, 40, 7))]


@pytest.mark.parametrize("size, crop", PICTURES)
def test_a_streamed_picture_is_that_of_render(size, crop, tmp_path, monkeypatch):
    """The progress wrapper sees every band."""
    monkeypatch.setattr(stream, "BAND_PIXELS", 300)
    path, method, bands_drawn = tmp_path / "a.npy", central(1e-3), []
    shape = stream.stream(Scene(), *size, path, method, crop, progress=lambda bands: bands_drawn.extend(bands) or bands)
    frame = render(Scene(), *size, method, crop)
    assert shape == frame.raster.shape and shows(path, frame)
    assert len(bands_drawn) == -(-shape[0] // max(1, 300 // shape[1])) and [*contents(tmp_path)] == ["a.npy"]


def test_a_streamed_slope_and_a_mean_of_samples_are_those_of_render(tmp_path, monkeypatch):
    monkeypatch.setattr(stream, "BAND_PIXELS", 300)
    path, drawn = tmp_path / "a.npy", {"width": 37, "height": 53, "derivatives": ["beta"], "samples": 2}
    stream.stream(Scene(), path=path, **drawn)
    assert (np.load(path) == render(Scene(), **drawn).derivatives["beta"]).all()


def test_what_is_larger_than_the_disk_is_refused_at_once(tmp_path):
    with pytest.raises(OSError, match=r"the picture takes 6\.76e\+06 GB, and the disk has .* GB left"):
        stream.stream(Scene(), MAX_SIDE, MAX_SIDE, tmp_path / "a.npy")
    assert rejection(stream.stream, Scene(), 8, 8, tmp_path / "a.png").endswith("ends in .npy")
    assert contents(tmp_path) == {}


SIGNALS = pytest.mark.parametrize("number, status, message", [(2, 130, "interrupted"), (15, 143, "terminated")])


@pytest.mark.parametrize("moment", (0, 4, 9))
@SIGNALS
def test_a_signal_leaves_the_old_file(number, status, message, moment, tmp_path, monkeypatch, capsys):
    """Sent to this process before a band is drawn, or at the last moment before the file gets its name."""
    steps, before = iter(range(10)), signal.getsignal(signal.SIGTERM)

    def told(*arguments, then, **options):
        if next(steps) == moment:
            os.kill(os.getpid(), number)
        return then(*arguments, **options)

    monkeypatch.setattr(stream, "BAND_PIXELS", 200)
    monkeypatch.setattr(stream, "render", partial(told, then=render))
    monkeypatch.setattr("os.replace", partial(told, then=os.replace))
    (tmp_path / "a.npy").write_bytes(b"old")
    assert main(["image", "--width", "200", "--height", "9", "--out", str(tmp_path / "a.npy")]) == status
    assert capsys.readouterr() == ("", f"symbolic-rendering image: {message}\n")
    assert contents(tmp_path) == {"a.npy": b"old"}
    assert signal.getsignal(signal.SIGTERM) == before


STOPPED = """
import atexit, os, signal, sys
class Stops:
    def find_spec(name, *_):
        if name == "numpy":
            try:
                os.kill(os.getpid(), int(sys.argv[1]))
            finally:
                os.kill(os.getpid(), int(sys.argv[2]))
signal.signal(signal.SIGINT, signal.default_int_handler)
sys.meta_path.insert(0, Stops)
atexit.register(os.kill, os.getpid(), signal.SIGINT)
from renderer.__main__ import main
sys.exit(main())
"""


@SIGNALS
def test_the_first_signal_stops_the_imports_too_and_no_other_the_end(number, status, message):
    assert python("-c", STOPPED, number, 17 - number, status=status) == ("", f"symbolic-rendering: {message}\n")


MEMORY = """
import sys
from pathlib import Path
from renderer import Scene, render
from renderer.picture import stream
def peak():
    lines = Path("/proc/self/status").read_text().splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith("VmHWM")) / 1024
stream.BAND_PIXELS = 2**16
stream.stream(Scene(), 300, 300, sys.argv[1])
before = peak()
stream.stream(Scene(), 2048, 2048, sys.argv[1])
print(peak() - before)
render(Scene(), 2048, 2048)
print(peak() - before)
"""


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="the peak of the resident memory is read from /proc")
def test_memory_does_not_grow_with_the_picture(tmp_path):
    """The peak of a child's resident memory, mapped pages included: the picture's planes alone are 96 MiB."""
    streamed, in_memory = map(float, python("-c", MEMORY, tmp_path / "a.npy")[0].split())
    assert streamed < 32
    assert in_memory > 64  # memory that was given back may be used again


# What the eye sees: sRGB is its formula; views that `tests/test_simulator_numbers.py` does not compare


def test_srgb_is_the_formula_everywhere(monkeypatch):
    """Next to where bytes begin, and where the table's cells do, as well as anywhere else; what is outside is cut."""
    begins = srgb.tables()[0][:-1]
    ends = np.concatenate([begins, (np.arange(srgb.CELLS) + 0.5) / srgb.CELLS])
    near = np.concatenate([ends, np.nextafter(ends, 0), np.nextafter(ends, 1), [-1.0, 0.0, 1.0, 2.0]])
    numbers = np.random.default_rng(1).random((3000, 333, 3))
    numbers.reshape(-1)[: near.size] = near
    inside = np.clip(numbers, 0, 1)
    formula = np.where(inside <= 0.0031308, 12.92 * inside, 1.055 * inside ** (1 / 2.4) - 0.055)
    for written in (views.to_bytes(numbers, threads=2), views.to_bytes(numbers[::-1].copy(order="F"))[::-1]):
        np.testing.assert_array_equal(written, np.rint(255 * formula))
    monkeypatch.setattr(srgb, "machine", lambda: numpy_rows)
    np.testing.assert_array_equal(views.to_bytes(numbers), np.rint(255 * formula))


def test_the_logarithmic_difference_is_black_at_zero_and_nowhere_else():
    """Of a pixel's channels the largest counts."""
    delta = np.array([[0.0, -0.0, np.nan, 5e-324, 1e-30, 1e-16, 1e-8, 1.0, 10.0]])
    low, middle, high = (matplotlib.colormaps["inferno"](n, bytes=True)[:3] for n in (0.0, 0.5, 1.0))
    expected = [[*[(0, 0, 0)] * 3, *[low] * 3, middle, high, high]]
    np.testing.assert_array_equal(views.difference_logarithmic(np.stack([-delta, 0 * delta], axis=2)), expected)
