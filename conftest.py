"""What every test shares: compiled shaders are kept in pytest's cache folder, and what takes longest begins first."""

import os

import pytest


@pytest.hookimpl(trylast=True)
def pytest_configure(config):
    """Keep machine code for the other workers and processes: a rendering test's time is mostly the compiler's."""
    if hasattr(config, "cache"):
        os.environ.setdefault("SYMBOLIC_RENDERING_CODE", str(config.cache.mkdir("compiled")))


def pytest_collection_modifyitems(items):
    """Begin with what is marked `begin_first`, lest one worker work alone at the end."""
    items.sort(key=lambda item: item.get_closest_marker("begin_first") is None)
