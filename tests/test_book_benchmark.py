"""The benchmark's page: its plots show every case that is timed."""

from book.figures import benchmark as figures
from verify.benchmark.frames import SIDES
from verify.records import read


def test_every_renderer_is_drawn():
    numbers = read("frames")["numbers"]
    assert figures.RENDERERS.keys() == SIDES.keys() - {"seed_central"}
    for renderer, (*_, threads) in figures.RENDERERS.items():
        pixels, times = figures.curve(numbers, renderer, threads)
        assert len(pixels) > 2 and (times > 0).all()


def test_every_method_has_its_place():
    rows = read("work_precision")["gradients"]
    assert figures.METHODS.keys() <= {row["method"] for row in rows}
