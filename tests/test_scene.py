"""Scenes and lights: what they accept, what they reject and how they say so, their defaults."""

import dataclasses
import math

import numpy as np
import pytest
from hypothesis import given

from renderer import Light, Scene
from tests.refusals import rejection
from tests.strategies import rejected_fields, scenes

INSIDE_B = (0.5, 0.5, 1.3)


@given(rejected_fields)
def test_a_rejection_names_field_and_value(rejected):
    name, value = rejected
    text = rejection(Scene, **{name: value})
    assert text.startswith(name)
    shown = text.partition(" = ")[2].rpartition(" is not allowed: ")[0]
    assert shown in {repr(value), *(repr(item) for item in (value if isinstance(value, tuple) else ()))}


@given(scenes())
def test_a_scene_that_is_accepted_is_accepted_again_and_equal(scene):
    assert dataclasses.replace(scene) == scene
    assert all(type(getattr(scene, f.name)) is float for f in dataclasses.fields(Scene) if f.type is float)


REFUSED = {
    "radius = 0.0 is not allowed: a finite number from 1e-60 to 1e+60": {"radius": 0.0},
    "model = array([1, 2]) is not allowed: one of 'blinn', 'phong'": {"model": np.array([1, 2])},
    "kd = array([[0., 0.], [0., 0.]])": {"kd": np.zeros((2, 2))},
    "kd = -0.1": {"kd": -0.1},
    "ku = 1048577.0": {"ku": 2.0**20 + 1},
    "beta = 1e+101": {"beta": 1e101},
    "shininess = 0.0": {"shininess": 0.0},
    "floor_tint = 1.5": {"floor_tint": 1.5},
    "ambient[1] = -1": {"ambient": (0, -1, 0)},
    "ball_radius = 0.0": {"ball_radius": 0.0},
    "ball_center[1] = 2000000000.0": {"ball_center": (0, 2e9, 0)},
    "lights[0].position = (0.5, 0.5, 1.3) is not allowed: outside sphere B": {"lights": (Light(INSIDE_B),)},
    "lights[1].position = (3.0, 0.0, 0.0)": {"lights": (Light((5, 5, 5)), Light((3, 0, 0)))},
    "lights[0].position = (3.0, 0.0, 1e-200)": {"lights": (Light((3, 0, 1e-200)),)},
    "lights[0].position[0] = 3000000000.0": {"lights": (Light((3e9, 0, 1)),)},
}
"""{how it is said: fields}, beside those that tests/test_command_line.py gives as options."""


@pytest.mark.parametrize("text", REFUSED)
def test_a_rejection_says_what_is_allowed(text):
    assert rejection(Scene, **REFUSED[text]).startswith(text)


def test_a_light_is_checked():
    assert rejection(Light, (1, 2, math.nan)).startswith("light.position[2] = nan")
    assert rejection(Light, (1, 2, 3), (-1, 1, 1)).startswith("light.color[0] = -1")


def test_what_is_absent_forbids_no_light():
    Scene(floor=False, lights=(Light((3, 0, 0)),))
    Scene(ball=False, lights=(Light(INSIDE_B),))


def test_numbers_are_converted():
    scene = Scene(ku=np.int64(3), ball_center=np.array(INSIDE_B), lights=[Light([5, 5, 5], [1, 1, 1])])
    assert (scene.ku, scene.ball_center, scene.lights) == (3.0, INSIDE_B, (Light((5.0, 5.0, 5.0)),))
