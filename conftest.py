"""Fixtures of every test: compiled shaders are kept in pytest's cache folder, and what takes longest begins first."""

import os
from unittest.mock import patch

import pytest

from renderer.machines import numpy_rows
from renderer.picture import stage

# Files that take most of a minute, or prepare for as long what their tests share, begin. A file has one worker.
LONGEST = (
    "test_browser.py",
    "test_own_page.py",
    "test_own_field.py",
    "test_wheel.py",
    "test_contributing.py",
    "test_simulator.py",
    "test_simulator_numbers.py",
    "test_notebooks.py",
    "test_single.py",
    "test_releases.py",
    "test_book_figures.py",
    "test_ideas.py",
    "test_machines.py",
    "test_render.py",
    "test_book_theorems.py",
    "test_theorems.py",
)


@pytest.hookimpl(trylast=True)
def pytest_configure(config):
    """Keep machine code for the other workers and processes: a rendering test's time is mostly the compiler's."""
    if hasattr(config, "cache"):
        os.environ.setdefault("SYMBOLIC_RENDERING_CODE", str(config.cache.mkdir("compiled") / "code"))


@pytest.fixture(scope="module")
def by_numpy():
    """Let NumPy draw, so that nothing is compiled: LLVM's bits are the same (`tests/test_machines.py`)."""
    with patch.object(stage, "machine", lambda: numpy_rows):
        yield


def pytest_collection_modifyitems(items):
    """Begin with LONGEST, in its order, lest one worker work alone at the end."""
    order = {name: place for place, name in enumerate(LONGEST)}
    items.sort(key=lambda item: order.get(item.path.name, len(order)))
