"""Every edge of the accepted domain is drawn without NaN; just past it there is a ValueError that names the field."""

import math
from dataclasses import replace

import numpy as np
import pytest

from renderer import Light, Scene, central, exact, render

BARE = Scene(ball=False, lights=(Light((5.0, 5.0, 10.0)),))
NUMBERS = [
    ("radius", 1e-60, 1e60),
    ("ka", 0.0, 1e6),
    ("kd", 0.0, 1e6),
    ("ks", 0.0, 1e6),
    ("shininess", 1e-3, 1e6),
    ("floor_tint", 0.0, 1.0),
    ("ku", -(2.0**20), 2.0**20),
    ("kv", -(2.0**20), 2.0**20),
    ("beta", -1e100, 1e100),
]
TRIPLES = [("ambient", 1e6), ("albedo_a", 1.0), ("albedo_b", 1.0)]
ENDS = [(name, edge, past) for name, low, high in NUMBERS for edge, past in ((low, -math.inf), (high, math.inf))]


def with_number(name, value):
    """Return the fields of a scene in which one number has that value, all else allowed."""
    fields = {"ball": False, "lights": (), name: value}
    return fields | ({"eye": 4.0 * value} if name == "radius" else {})


def draws(scene):
    """Assert that a scene is drawn, by both forms of the exact gradient and by a difference, in numbers from 0 to 1."""
    with np.errstate(all="raise"):
        for method in (exact(), exact("general"), central(1e-3)):
            frame = render(scene, 24, 20, method)
            assert ((frame.rgb >= 0) & (frame.rgb <= 1)).all()
            on_a = frame.stage.on_a
            for name, plane in frame.surface_data.items():
                assert (np.isfinite(plane) == on_a).all(), name


@pytest.mark.parametrize(("name", "edge", "past"), ENDS)
def test_numbers(name, edge, past):
    draws(Scene(**with_number(name, edge)))
    with pytest.raises(ValueError, match=name if name != "radius" else "radius|eye"):
        Scene(**with_number(name, math.nextafter(edge, past)))


@pytest.mark.parametrize(("name", "high"), TRIPLES)
@pytest.mark.parametrize("channel", range(3))
def test_colours(name, high, channel):
    for edge, past in ((0.0, -math.inf), (high, math.inf)):
        triple = [0.5] * 3
        triple[channel] = edge
        draws(replace(BARE, **{name: tuple(triple)}))
        triple[channel] = math.nextafter(edge, past)
        with pytest.raises(ValueError, match=name):
            replace(BARE, **{name: tuple(triple)})


@pytest.mark.parametrize(("edge", "past"), [(0.999999e6, 1.000001e6), (1 / (1 - 1.001e-9), 1 + 0.99e-9)])
def test_the_eye(edge, past):
    draws(replace(BARE, eye=edge, lights=(Light((0.5, 0.0, 1.2)),)))
    for wrong in (past, 0.0, -4.0, 1.0, 0.5):
        with pytest.raises(ValueError, match="eye"):
            replace(BARE, eye=wrong)


LIGHTS = [  # position at the edge, position just past it, what the message names
    ((0.0, 0.0, 1.0 + 2e-9), (0.0, 0.0, 1.0 + 0.5e-9), "outside sphere A"),
    ((3.0, 0.0, 1.01e-9), (3.0, 0.0, 1e-9), "off the floor"),
    ((3.0, 0.0, -1.01e-9), (3.0, 0.0, 0.0), "off the floor"),
    ((1e9, -1e9, 1e9), (math.nextafter(1e9, math.inf), 0.0, 5.0), "position"),
]


@pytest.mark.parametrize(("edge", "past", "named"), LIGHTS)
def test_lights(edge, past, named):
    draws(replace(BARE, lights=(Light(edge),)))
    with pytest.raises(ValueError, match=named):
        replace(BARE, lights=(Light(past),))


def test_a_light_almost_on_b():
    ball = {"ball_center": (0.5, 0.5, 1.3), "ball_radius": 0.32}
    draws(Scene(**ball, lights=(Light((0.5, 0.5, 1.62 + 1e-9)),)))
    with pytest.raises(ValueError, match="outside sphere B"):
        Scene(**ball, lights=(Light((0.5, 0.5, 1.62)),))


BALLS = [  # (centre, radius) at the edge, then just past it
    (((0.0, 0.0, 2.0), 1e-9), ((0.0, 0.0, 2.0), 0.999e-9)),
    (((0.0, 0.0, -1e9), 0.9e9), ((0.0, 0.0, -1.001e9), 0.9e9)),
    (((0.0, 0.0, 3.0), 0.999), ((0.0, 0.0, 3.0), 1.0)),
]


@pytest.mark.parametrize(("edge", "past"), BALLS)
def test_sphere_b(edge, past):
    draws(Scene(ball_center=edge[0], ball_radius=edge[1], lights=()))
    with pytest.raises(ValueError, match="ball"):
        Scene(ball_center=past[0], ball_radius=past[1], lights=())


def test_how_many_lights():
    five = BARE.lights * 5
    draws(replace(BARE, lights=five))
    with pytest.raises(ValueError, match="lights"):
        replace(BARE, lights=five + BARE.lights)


@pytest.mark.parametrize("eps", [1e-40, 0.5])
def test_steps(eps):
    frame = render(replace(BARE, beta=1e100, ku=2.0**20), 24, 20, central(eps))
    assert np.isfinite(frame.rgb).all()
    with pytest.raises(ValueError, match="eps"):
        central(eps / 2 if eps < 0.1 else math.nextafter(0.5, 1))
