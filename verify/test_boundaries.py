"""Theorem bump_moves_no_boundary, counted: no pixel changes its chamber, whatever the field, β, ε and model."""

from dataclasses import replace

import numpy as np
import pytest

from renderer import Scene, central, exact, forward, render
from renderer.kernels import FIELDS

SIZE = 72
PLAIN = render(Scene(beta=0.0), SIZE, SIZE).chambers


@pytest.mark.parametrize("field", FIELDS)
@pytest.mark.parametrize("model", ["blinn", "phong"])
def test_no_pixel_flips(field, model):
    for beta in (-2.0, 0.35, 50.0):
        for method in (exact(), central(1e-1), central(1e-6), forward(1e-3)):
            scene = Scene(field=field, model=model, beta=beta)
            assert np.count_nonzero(render(scene, SIZE, SIZE, gradient=method).chambers != PLAIN) == 0


def test_the_count_sees_a_moved_boundary():
    """The same count is not zero when a boundary does move: B a little larger."""
    moved = replace(Scene(), ball_radius=0.35)
    assert np.count_nonzero(render(moved, SIZE, SIZE).chambers != PLAIN) > 0
