"""Whole frames of the default scene, kernels warm. Run by `python -m verify.benchmark`, not by `pytest verify`."""

import pytest

from renderer import Scene, central, exact, render, stage_of

SCENE = Scene()
METHODS = {"exact": exact(), "general": exact("general"), "central": central(1e-3)}


@pytest.mark.parametrize("size", [256, 1024])
@pytest.mark.parametrize("method", METHODS)
def bench_frame_with_stage(benchmark, method, size):
    """A frame whose chambers are given."""
    stage = stage_of(SCENE, size, size)
    benchmark(render, SCENE, size, size, METHODS[method], stage=stage)


@pytest.mark.parametrize("size", [256, 1024])
@pytest.mark.parametrize("method", ["exact", "central"])
def bench_whole_frame(benchmark, method, size):
    """A frame from nothing, chambers included."""
    benchmark(render, SCENE, size, size, METHODS[method])
