"""Streamed pictures: the same numbers as `render`, in bounded memory, whole or not there at all."""

import math
import os
import signal
from functools import partial
from pathlib import Path

import pytest
import tifffile

from renderer import Scene, central, render
from renderer.command_line.verbs import main
from renderer.picture import stream
from renderer.scene.raster import MAX_SIDE
from tests.folders import contents
from tests.pictures import shows
from tests.processes import python
from tests.refusals import rejection


@pytest.fixture
def small_blocks(monkeypatch):
    """Blocks so small that a little picture has many, and that a row of it is cut."""
    monkeypatch.setattr(stream, "BLOCK_PIXELS", 300)


def test_blocks_are_bounded():
    for width, rows in ((2**24, 1), (2**24, 256), (1001, 1047)):
        assert all(w * h <= stream.BLOCK_PIXELS for *_, w, h in stream.blocks((0, 0, width, 3 * rows), rows))


PICTURES = [("a.npy", size, None) for size in ((37, 53), (701, 5), (1, 1), (300, 4))]
PICTURES += [("a.tif", size, None) for size in ((600, 300), (40, 257), (256, 256))]
PICTURES += [(name, (MAX_SIDE, MAX_SIDE), (2**23, 2**23 - 3, 40, 7)) for name in ("a.npy", "a.tiff")]


@pytest.mark.parametrize("name, size, crop", PICTURES)
def test_a_streamed_picture_is_that_of_render(name, size, crop, small_blocks, tmp_path):
    """And its progress sees every block."""
    path, method, seen = tmp_path / name, central(1e-3), []
    shape = stream.stream(Scene(), *size, path, method, crop, progress=lambda blocks: seen.extend(blocks) or blocks)
    frame = render(Scene(), *size, method, crop)
    assert shape == frame.raster.shape and shows(path, frame)
    assert sum(wide * high for *_, wide, high in seen) == math.prod(shape)
    assert [*contents(tmp_path)] == [name]


def test_a_tiff_is_large_and_tiled(tmp_path):
    stream.stream(Scene(), 600, 300, tmp_path / "a.tif")
    with tifffile.TiffFile(tmp_path / "a.tif") as file:
        (page,) = file.pages
        assert file.is_bigtiff and page.tile == (256, 256) and page.photometric == tifffile.PHOTOMETRIC.RGB


def test_what_is_larger_than_the_disk_is_refused_at_once(tmp_path):
    with pytest.raises(OSError, match=r"the picture takes 6\.76e\+06 GB, and the disk has .* GB left"):
        stream.stream(Scene(), MAX_SIDE, MAX_SIDE, tmp_path / "a.npy")
    assert rejection(stream.stream, Scene(), 8, 8, tmp_path / "a.png").endswith("ends in .npy or .tif or .tiff")
    whole = partial(stream.stream, Scene(), 8, 8, tmp_path / "a.npy")
    for other in (lambda blocks: [], lambda blocks: None, lambda blocks: blocks * 2):
        assert rejection(whole, progress=other).startswith("progress = <function")
    assert contents(tmp_path) == {}


SIGNALS = pytest.mark.parametrize("number, status, said", [(2, 130, "interrupted"), (15, 143, "terminated")])


@pytest.mark.parametrize("moment", range(10))
@pytest.mark.parametrize("name, height", [("a.npy", "9"), ("a.tif", "2304")])
@SIGNALS
def test_a_signal_leaves_the_old_file(
    number, status, said, name, height, moment, small_blocks, tmp_path, monkeypatch, capsys
):
    """Sent to this process before a block is drawn, or at the last moment before the file gets its name."""
    steps, before = iter(range(10)), signal.getsignal(signal.SIGTERM)

    def told(*arguments, then, **options):
        if next(steps) == moment:
            os.kill(os.getpid(), number)
        return then(*arguments, **options)

    monkeypatch.setattr(stream, "render", partial(told, then=render))
    monkeypatch.setattr("os.replace", partial(told, then=os.replace))
    (tmp_path / name).write_bytes(b"old")
    assert main(["image", "--width", "200", "--height", height, "--out", str(tmp_path / name)]) == status
    assert capsys.readouterr() == ("", f"symbolic-rendering image: {said}\n")
    assert contents(tmp_path) == {name: b"old"}
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
def test_the_first_signal_stops_the_imports_too_and_no_other_the_end(number, status, said):
    assert python("-c", STOPPED, number, 17 - number, status=status) == ("", f"symbolic-rendering: {said}\n")


MEMORY = """
import sys
from pathlib import Path
from renderer import Scene, render
from renderer.picture import stream
def peak():
    lines = Path("/proc/self/status").read_text().splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith("VmHWM")) / 1024
stream.BLOCK_PIXELS = 2**16
targets = sys.argv[1:]
for target in targets:
    stream.stream(Scene(), 300, 300, target)
before = peak()
for target in targets:
    stream.stream(Scene(), 2048, 2048, target)
print(peak() - before)
render(Scene(), 2048, 2048)
print(peak() - before)
"""


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="the peak of the resident memory is read from /proc")
def test_memory_does_not_grow_with_the_picture(tmp_path):
    """The peak of a child's resident memory, mapped pages included: the picture's planes alone are 96 MiB."""
    printed, _ = python("-c", MEMORY, tmp_path / "a.npy", tmp_path / "a.tif")
    streamed, whole = map(float, printed.split())
    assert streamed < 32
    assert whole > 64  # what it has given back may be used again
