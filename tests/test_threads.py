"""It never hangs: pictures after a fork, from threads, at exit, after an interrupt or an error; one pool for all."""

import os
import threading
import weakref
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from renderer import Scene, central, render, stage_of, threads
from renderer.threads import available_cores, run_bands
from tests.processes import python

SIZE = (300, 200)
DRAW = """
import os, signal, sys, threading, time
from concurrent.futures import ThreadPoolExecutor
import numpy as np
from renderer import Scene, exact, render
from renderer import threads
from renderer.threads import run_bands

def draw(field="ridges"):
    return render(Scene(field=field), 300, 200, threads=2).rgb

def child(drawn):
    number = os.fork()
    if number == 0:
        os._exit(0 if np.array_equal(drawn(), expected) and threading.active_count() > 1 else 1)
    assert os.waitstatus_to_exitcode(os.waitpid(number, 0)[1]) == 0

expected = draw()
"""
WHEN = {
    "after a fork": "child(draw)",
    "in a child's child": "child(lambda: [child(draw), draw()][1])",
    "in a child that is forked while another thread draws": """
busy = threading.Thread(target=lambda: [render(Scene(), 300, 200, threads=2) for _ in range(40)])
busy.start()
for _ in range(10):
    child(draw)
busy.join()""",
    "in a child that is forked while another thread compiles": """
from renderer.machines import native
other, optimized = draw("sine"), native.optimized
native.compiled.cache_clear()
begun = threading.Event()
native.optimized = lambda *a: begun.set() or time.sleep(0.2) or optimized(*a)
os.environ["SYMBOLIC_RENDERING_CODE"] = ""
busy = threading.Thread(target=draw)
busy.start()
begun.wait()
expected = other
child(lambda: draw("sine"))
busy.join()""",
    "in a child that is forked while another thread chooses its code": """
from renderer.picture import drawing
from renderer.shader import numbers
drawing._same_shot.cache_clear()
begun, scene_numbers = threading.Event(), numbers.scene_numbers
numbers.scene_numbers = lambda shot: begun.set() or time.sleep(0.2) or scene_numbers(shot)
busy = threading.Thread(target=draw)
busy.start()
begun.wait()
child(draw)
busy.join()""",
    "in a child that is forked while another thread imports": """
from renderer import machines
begun = threading.Event()
class Slow:
    def find_spec(*_):
        begun.set()
        time.sleep(0.2)
sys.meta_path.insert(0, Slow)
machines.machine.cache_clear()
del machines.native, sys.modules["renderer.machines.native"]
busy = threading.Thread(target=draw)
busy.start()
begun.wait()
child(draw)
busy.join()""",
    "from many threads": """
with ThreadPoolExecutor(8) as several:
    assert all(np.array_equal(found, expected) for found in several.map(lambda _: draw(), range(40)))""",
    "at exit": """
import atexit
atexit.register(lambda: os._exit(7 if np.array_equal(draw(), expected) else 1))""",
    "in a thread that outlives the main one": """
def later():
    threading.main_thread().join()
    os._exit(7 if np.array_equal(draw(), expected) else 1)
threading.Thread(target=later).start()""",
    "after Ctrl-C": """
def interrupt(band):
    if band.start == 1:
        os.kill(os.getpid(), signal.SIGINT)
    time.sleep(0.01)
signal.signal(signal.SIGINT, signal.default_int_handler)
try:
    run_bands(interrupt, 16, 1, 2)
    sys.exit("no interrupt")
except KeyboardInterrupt:
    assert np.array_equal(draw(), expected)""",
    "where the system has no more threads": """
def none(thread):
    raise RuntimeError("can't start new thread")
threads._pool.cache_clear()
threading.Thread.start = none
assert np.array_equal(draw(), expected)""",
}


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system does not fork")
@pytest.mark.parametrize("when", WHEN)
def test_a_picture_is_drawn(when):
    """In a process of its own, which has to end; 7 is said by what runs when the main thread has ended."""
    status = 7 if "os._exit(7" in WHEN[when] else 0
    python("-c", DRAW + WHEN[when], status=status, timeout=60)


def test_one_pool_whatever_is_asked_for():
    before = threading.active_count()
    pictures = [render(Scene(), *SIZE, threads=count).rgb for count in range(1, 201, 10)]
    assert all(np.array_equal(pictures[0], picture) for picture in pictures)
    assert threading.active_count() <= before + available_cores()


@pytest.mark.parametrize("count", [1, 2, 16])
def test_an_error_of_a_band_is_raised_and_the_next_picture_drawn(count):
    def fail(band):
        if band.stop == count:
            raise ArithmeticError(band.start)

    for _ in range(3):
        with pytest.raises(ArithmeticError, match=str(count - 1)):
            run_bands(fail, count, 1, 3)
        assert run_bands(lambda band: band.start, count, 1, 3) == list(range(count))


def test_a_helper_that_comes_late_is_not_waited_for_and_keeps_nothing(monkeypatch):
    """Its only thread is busy until this picture is drawn, and what it was to write is gone."""
    drawn, written = threading.Event(), np.zeros(7)
    memory = weakref.ref(written)
    with ThreadPoolExecutor(1) as pool:
        pool.submit(drawn.wait, 60)
        monkeypatch.setattr(threads, "_pool", lambda: pool)
        assert run_bands(lambda band, into=written: into[band].size, 7, 2, 4) == [2, 2, 2, 1]
        del written
        assert memory() is None
        drawn.set()


def test_what_frames_share_cannot_be_written():
    stage = stage_of(Scene(), 40, 30)
    frame = render(Scene(), 40, 30, central(1e-3), stage=stage)
    for array in (stage.chambers, stage.x, frame.chambers, frame.planes_on_a, *frame.surface_data.values()):
        with pytest.raises(ValueError, match="read-only"):
            array[...] = 0
    frame.rgb[:] = 0.0  # its own
    assert render(Scene(), 40, 30, stage=stage).rgb.any()
