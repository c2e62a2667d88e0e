"""Bodies and lights that almost touch are drawn without NaN; just past that a ValueError names the field.

The ends of single numbers, and of ε, are drawn by tests/test_properties.py.
"""

import numpy as np
import pytest

from renderer import Light, Scene, central, exact, render

pytestmark = pytest.mark.usefixtures("by_numpy")


def lit(*position, ball=False):
    """Return the fields of a scene with one light there."""
    return {"lights": (Light(position),), "ball": ball}


def with_b(height, radius):
    """Return the fields of a scene with that sphere B above A's middle, or below it, and no light."""
    return {"ball_center": (0.0, 0.0, height), "ball_radius": radius, "lights": ()}


EDGES = [  # fields at the edge, fields just past it, what the message names
    (lit(0.0, 0.0, 1.0 + 2e-9), lit(0.0, 0.0, 1.0 + 0.5e-9), "outside sphere A"),
    (lit(3.0, 0.0, 1.01e-9), lit(3.0, 0.0, 1e-9), "off the floor"),
    (lit(0.5, 0.5, 1.62 + 1e-9, ball=True), lit(0.5, 0.5, 1.62, ball=True), "outside sphere B"),
    (with_b(2.0, 1e-9), with_b(2.0, 0.999e-9), "ball"),
    (with_b(3.0, 0.999), with_b(3.0, 1.0), "ball"),
]


@pytest.mark.parametrize("edge, past, named", EDGES)
def test_an_edge(edge, past, named):
    """Both forms of the exact gradient and a difference draw colours from 0 to 1."""
    for method in (exact(), exact("general"), central(1e-3)):
        with np.errstate(all="raise"):
            frame = render(Scene(**edge), 24, 20, method)
        assert ((frame.rgb >= 0) & (frame.rgb <= 1)).all()
        assert all((np.isfinite(plane) == frame.stage.on_a).all() for plane in frame.surface_data.values())
    with pytest.raises(ValueError, match=named):
        Scene(**past)
