"""The benchmark's page: its plots show every case that is timed, and its table every target."""

from pathlib import Path

from book.figures import benchmark as figures
from verify.benchmark.frames import SIDES
from verify.benchmark.targets import TARGETS

PAGE = Path(__file__).parent.parent / "book" / "checked" / "benchmark.md"


def test_every_renderer_is_drawn():
    numbers = figures.committed(figures.FRAMES)["numbers"]
    assert figures.RENDERERS.keys() == SIDES.keys() - {"seed_central"}
    for renderer, (*_, threads) in figures.RENDERERS.items():
        pixels, times = figures.curve(numbers, renderer, threads)
        assert pixels.tolist() == [side**2 for side in SIDES[renderer]]
        assert (times > 0).all()


def test_every_method_has_its_place():
    rows = figures.committed(figures.GRADIENTS)["gradients"]
    assert figures.METHODS.keys() <= {row["method"] for row in rows}


def test_the_table_has_every_target():
    page = PAGE.read_text(encoding="utf-8")
    for target in TARGETS:
        row = next((line for line in page.splitlines() if f".{target.key}_target`" in line), "")
        assert f".{target.key} " in row or f".{target.key}`" in row, target.key
        assert f".{target.key}_verdict`" in row, target.key
