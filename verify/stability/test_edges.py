"""Where bodies and lights almost touch is drawn without NaN; just past that is a ValueError that names the field.

The ends of single numbers, and of ε, are drawn by tests/accepted_scenes.py.
"""

import math
from dataclasses import replace

import numpy as np
import pytest

from renderer import Light, Scene, central, exact, render

LIGHTS = (Light((5.0, 5.0, 10.0)),)
BARE = Scene(ball=False, lights=LIGHTS)
NEAR_B = {"ball": True, "ball_center": (0.5, 0.5, 1.3), "ball_radius": 0.32}


def lit(*position):
    """Return the fields of a scene with one light there."""
    return {"lights": (Light(position),)}


def with_b(center, radius):
    """Return the fields of a scene with that sphere B."""
    return {"ball": True, "ball_center": center, "ball_radius": radius, "lights": ()}


EDGES = [  # fields at the edge, fields just past it, what the message names
    ({"eye": 0.999999e6} | lit(0.5, 0.0, 1.2), {"eye": 1.000001e6}, "eye"),
    ({"eye": 1 / (1 - 1.001e-9)} | lit(0.5, 0.0, 1.2), {"eye": 1 + 0.99e-9}, "eye"),
    (lit(0.0, 0.0, 1.0 + 2e-9), lit(0.0, 0.0, 1.0 + 0.5e-9), "outside sphere A"),
    (lit(3.0, 0.0, 1.01e-9), lit(3.0, 0.0, 1e-9), "off the floor"),
    (lit(3.0, 0.0, -1.01e-9), lit(3.0, 0.0, 0.0), "off the floor"),
    (lit(1e9, -1e9, 1e9), lit(math.nextafter(1e9, math.inf), 0.0, 5.0), "position"),
    (NEAR_B | lit(0.5, 0.5, 1.62 + 1e-9), NEAR_B | lit(0.5, 0.5, 1.62), "outside sphere B"),
    (with_b((0.0, 0.0, 2.0), 1e-9), with_b((0.0, 0.0, 2.0), 0.999e-9), "ball"),
    (with_b((0.0, 0.0, -1e9), 0.9e9), with_b((0.0, 0.0, -1.001e9), 0.9e9), "ball"),
    (with_b((0.0, 0.0, 3.0), 0.999), with_b((0.0, 0.0, 3.0), 1.0), "ball"),
    ({"lights": LIGHTS * 5}, {"lights": LIGHTS * 6}, "lights"),
]  # fmt: skip


@pytest.mark.parametrize(("edge", "past", "named"), EDGES)
def test_an_edge(edge, past, named):
    """By both forms of the exact gradient and by a difference, in numbers from 0 to 1."""
    scene = replace(BARE, **edge)
    with np.errstate(all="raise"):
        for method in (exact(), exact("general"), central(1e-3)):
            frame = render(scene, 24, 20, method)
            assert ((frame.rgb >= 0) & (frame.rgb <= 1)).all()
            for name, plane in frame.surface_data.items():
                assert (np.isfinite(plane) == frame.stage.on_a).all(), name
    with pytest.raises(ValueError, match=named):
        replace(BARE, **past)
