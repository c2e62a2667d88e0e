"""Streamed pictures: the same numbers as `render`, in bounded memory, whole or not there at all."""

import os
import signal
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import tifffile

from renderer import Scene, central, render
from renderer.command_line.verbs import main
from renderer.machines import machine
from renderer.picture import stream, views
from renderer.scene.raster import MAX_SIDE
from tests.folders import contents
from tests.processes import python, started, wait_until


@pytest.fixture
def small_blocks(monkeypatch):
    """Blocks so small that a little picture has many, and that a row of it is cut."""
    monkeypatch.setattr(stream, "BLOCK_PIXELS", 300)


@pytest.mark.parametrize(
    ("width", "rows"), [(2**24, 1), (2**24, 256), (16384, 64), (16384, 256), (1001, 1047), (2**20 + 1, 1), (1, 2**20)]
)
def test_blocks_are_bounded(width, rows):
    blocks = stream.blocks((0, 0, width, 3 * rows), rows)
    assert all(wide * high <= stream.BLOCK_PIXELS for _, _, wide, high in blocks)


@pytest.mark.parametrize("size", [(37, 53), (701, 5), (1, 1), (300, 4)])
def test_npy_has_the_numbers_of_render(size, small_blocks, tmp_path):
    shape = stream.stream(Scene(), *size, tmp_path / "a.npy", central(1e-3))
    stored = np.load(tmp_path / "a.npy", mmap_mode="r")
    assert isinstance(stored, np.memmap)
    assert (stored.dtype, stored.shape, shape) == (np.float64, (size[1], size[0], 3), (size[1], size[0]))
    np.testing.assert_array_equal(stored, render(Scene(), *size, central(1e-3)).rgb)
    assert [path.name for path in tmp_path.iterdir()] == ["a.npy"]


@pytest.mark.parametrize(("suffix", "size"), [(".tif", (600, 300)), (".tiff", (40, 257)), (".tif", (256, 256))])
def test_tiff_has_the_bytes_of_a_png(suffix, size, small_blocks, tmp_path):
    path = tmp_path / f"a{suffix}"
    stream.stream(Scene(), *size, path)
    np.testing.assert_array_equal(tifffile.imread(path), views.image_view(render(Scene(), *size)))
    with tifffile.TiffFile(path) as file:
        (page,) = file.pages
        assert file.is_bigtiff
        assert (page.is_tiled, page.tile, page.dtype) == (True, (256, 256), np.uint8)
        assert page.photometric == tifffile.PHOTOMETRIC.RGB


@pytest.mark.parametrize("name", ["a.npy", "a.tif"])
def test_a_crop(name, tmp_path):
    crop = (2**23, 2**23 - 3, 40, 7)
    assert stream.stream(Scene(), MAX_SIDE, MAX_SIDE, tmp_path / name, crop=crop) == (7, 40)
    frame = render(Scene(), MAX_SIDE, MAX_SIDE, crop=crop)
    stored = np.load(tmp_path / name) if name == "a.npy" else tifffile.imread(tmp_path / name)
    np.testing.assert_array_equal(stored, frame.rgb if name == "a.npy" else views.image_view(frame))


def test_another_suffix_is_refused(tmp_path):
    with pytest.raises(ValueError, match=r"is not allowed: a file name that ends in \.npy or \.tif or \.tiff"):
        stream.stream(Scene(), 8, 8, tmp_path / "a.png")


def test_a_picture_larger_than_the_disk_is_refused_at_once(tmp_path):
    with pytest.raises(OSError, match=r"the picture takes 6\.76e\+06 GB, and the disk has .* GB left"):
        stream.stream(Scene(), MAX_SIDE, MAX_SIDE, tmp_path / "a.npy")
    assert list(tmp_path.iterdir()) == []


def test_progress_sees_every_block(small_blocks, tmp_path):
    seen = []
    stream.stream(Scene(), 100, 10, tmp_path / "a.npy", progress=lambda blocks: seen.extend(blocks) or blocks)
    assert seen == [(0, 0, 100, 3), (0, 3, 100, 3), (0, 6, 100, 3), (0, 9, 100, 1)]


@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("name", ["a.npy", "a.tif"])
def test_an_error_of_a_band_reaches_the_caller_and_leaves_the_old_file(name, threads, tmp_path, monkeypatch):
    """The last band of the second block fails, on whichever thread draws it."""
    drawn = []

    def drawer(want, job):
        draw = machine().drawer(want, job)

        def failing(rows):
            if rows.stop == len(job["y"]) and len(drawn) > 0:
                raise ArithmeticError("a band")
            drawn.extend([rows] if rows.stop == len(job["y"]) else [])
            return draw(rows)

        return failing

    monkeypatch.setattr("renderer.picture.stage.machine", lambda: SimpleNamespace(drawer=drawer))
    monkeypatch.setattr(stream, "BLOCK_PIXELS", 300 * 200)
    (tmp_path / name).write_bytes(b"old")
    with pytest.raises(ArithmeticError, match="a band"):
        stream.stream(Scene(), 300, 600, tmp_path / name, threads=threads)
    assert len(drawn) == 1
    assert contents(tmp_path) == {name: b"old"}


def heed_interrupts():
    """Undo what a shell does to its background jobs, and these hand on: that they ignore Ctrl-C."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.mark.parametrize(("number", "status", "told"), [(2, 130, "interrupted"), (15, 143, "terminated")])
def test_a_signal_in_the_middle_of_a_big_picture(number, status, told, tmp_path):
    (tmp_path / "a.tif").write_bytes(b"old")
    command = ["-m", "renderer", "image", "--size", "16384", "--out", tmp_path / "a.tif"]
    with started(*command, preexec_fn=heed_interrupts) as child:
        wait_until(lambda: any(path.stat().st_size > 10**5 for path in tmp_path.glob(".a-*")), child)
        child.send_signal(number)
        out, err = child.communicate(timeout=60)
    assert (child.returncode, out, err) == (status, "", f"python -m renderer image: {told}\n")
    assert contents(tmp_path) == {"a.tif": b"old"}


@pytest.mark.parametrize("moment", range(10))
@pytest.mark.parametrize(("name", "height"), [("a.npy", "9"), ("a.tif", "2304")])
def test_sigterm_leaves_the_old_file(name, height, moment, small_blocks, tmp_path, monkeypatch, capsys):
    """Sent to this process before a block is drawn, or at the last moment before the file gets its name."""
    steps, before = iter(range(10)), signal.getsignal(signal.SIGTERM)

    def told(*arguments, then, **options):
        if next(steps) == moment:
            os.kill(os.getpid(), signal.SIGTERM)
        return then(*arguments, **options)

    monkeypatch.setattr(stream, "render", partial(told, then=render))
    monkeypatch.setattr("os.replace", partial(told, then=os.replace))
    (tmp_path / name).write_bytes(b"old")
    assert main(["image", "--width", "200", "--height", height, "--out", str(tmp_path / name)]) == 143
    assert capsys.readouterr() == ("", "symbolic-rendering image: terminated\n")
    assert contents(tmp_path) == {name: b"old"}
    assert signal.getsignal(signal.SIGTERM) == before


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
