"""The gradient alone, a million chart points of ridges, one thread."""

import numpy as np
import pytest

from renderer import Scene, central, central4, exact, forward, gradient_at

POINTS = 10**6
METHODS = {"exact": exact(), "forward": forward(1e-3), "central": central(1e-3), "central4": central4(1e-3)}


@pytest.mark.parametrize("method", METHODS)
def bench_gradient(benchmark, method):
    """h_u and h_v at POINTS random chart points."""
    random = np.random.default_rng(1)
    u, v = random.uniform(0, 1, POINTS), random.uniform(0, 1, POINTS)
    benchmark(gradient_at, Scene(), u, v, METHODS[method])
