"""Streamed pictures: the same numbers as `render`, in bounded memory, whole or not there at all; and signals."""

import os
import signal
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from renderer import Scene, central, render
from renderer.command_line.verbs import main
from renderer.picture import stream
from renderer.scene.raster import MAX_SIDE
from tests.folders import contents
from tests.pictures import shows
from tests.processes import python
from tests.refusals import rejection

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
