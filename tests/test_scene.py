"""Scenes and lights: what they accept, what they reject and how they say so, their defaults."""

import dataclasses

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


@pytest.mark.parametrize("array", [np.array([1, 2]), np.zeros((2, 2))])
@pytest.mark.parametrize("name", ["model", "ball", "kd"])
def test_an_array_is_refused_in_one_line(name, array):
    assert rejection(Scene, **{name: array}).startswith(f"{name} = array(")


def test_what_is_absent_forbids_no_light():
    Scene(floor=False, lights=(Light((3, 0, 0)),))
    Scene(ball=False, lights=(Light(INSIDE_B),))


def test_numbers_are_converted():
    scene = Scene(ku=np.int64(3), ball_center=np.array(INSIDE_B), lights=[Light([5, 5, 5], [1, 1, 1])])
    assert (scene.ku, scene.ball_center, scene.lights) == (3.0, INSIDE_B, (Light((5.0, 5.0, 5.0)),))
