"""Scenes and lights: what they accept, what they reject and how they say so, their defaults."""

import dataclasses
import math

import numpy as np
import pytest
from hypothesis import given

from renderer import Light, Scene
from renderer.kernels import FIELDS
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


@pytest.mark.parametrize(
    ("fields", "text"),
    [
        ({"radius": 4.0}, "eye = 4.0 is not allowed: radius/eye from 1e-6 to 1 - 1e-9, and radius = 4"),
        ({"eye": -4.0}, "eye = -4.0 is not allowed: radius/eye from 1e-6 to 1 - 1e-9, and radius = 1"),
        ({"radius": 0.0}, "radius = 0.0 is not allowed: a finite number from 1e-60 to 1e+60"),
        ({"field": "foo"}, f"field = 'foo' is not allowed: one of {', '.join(map(repr, FIELDS))}"),
        ({"model": "gouraud"}, "model = 'gouraud' is not allowed: one of 'blinn', 'phong'"),
        ({"model": np.array([1, 2])}, "model = array([1, 2]) is not allowed: one of 'blinn', 'phong'"),
        ({"ball": np.array([True])}, "ball = array([ True]) is not allowed: one of True, False"),
        ({"field": ["sine"]}, "field = ['sine'] is not allowed: one of"),
        ({"kd": np.zeros((2, 2))}, "kd = array([[0., 0.], [0., 0.]]) is not allowed: a finite number"),
        ({"ku": 2.0**20 + 1}, "ku = 1048577.0 is not allowed: a finite number from -1.04858e+06 to 1.04858e+06"),
        ({"beta": 1e101}, "beta = 1e+101 is not allowed: a finite number from -1e+100 to 1e+100"),
        ({"shininess": 0.0}, "shininess = 0.0 is not allowed: a finite number from 0.001 to 1e+06"),
        ({"kd": -0.1}, "kd = -0.1 is not allowed: a finite number from 0 to 1e+06"),
        ({"floor_tint": 1.5}, "floor_tint = 1.5 is not allowed: a finite number from 0 to 1"),
        ({"albedo_a": (0, 0, 2)}, "albedo_a[2] = 2 is not allowed: a finite number from 0 to 1"),
        ({"ambient": (0, -1, 0)}, "ambient[1] = -1 is not allowed: a finite number from 0 to 1e+06"),
        ({"ball_radius": 0.0}, "ball_radius = 0.0 is not allowed: a finite number from 1e-09 to 1e+09"),
        ({"ball_center": (0, 0, 4)}, "ball_center = (0.0, 0.0, 4.0) is not allowed: B clear of the eye"),
        ({"ball_center": (0, 2e9, 0)}, "ball_center[1] = 2000000000.0 is not allowed: a finite number from -1e+09 to"),
        ({"lights": (Light((5, 5, 5)),) * 6}, "lights = 6 lights is not allowed: a sequence of at most 5 Light"),
        ({"lights": (Light((0, 0, 0.5)),)}, "lights[0].position = (0.0, 0.0, 0.5) is not allowed: outside sphere A"),
        ({"lights": (Light(INSIDE_B),)}, "lights[0].position = (0.5, 0.5, 1.3) is not allowed: outside sphere B"),
        ({"lights": (Light((5, 5, 5)), Light((3, 0, 0)))}, "lights[1].position = (3.0, 0.0, 0.0) is not allowed: off"),
        ({"lights": (Light((3, 0, 1e-200)),)}, "lights[0].position = (3.0, 0.0, 1e-200) is not allowed: off the floor"),
        ({"lights": (Light((3e9, 0, 1)),)}, "lights[0].position[0] = 3000000000.0 is not allowed: a finite number"),
    ],
)
def test_a_rejection_says_what_is_allowed(fields, text):
    assert rejection(Scene, **fields).startswith(text)


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        (((1, 2),), "light.position = (1, 2) is not allowed: three finite numbers from -inf to inf"),
        (((1, 2, math.nan),), "light.position[2] = nan is not allowed: a finite number from -inf to inf"),
        (("123",), "light.position = '123' is not allowed: three finite numbers from -inf to inf"),
        (((1, 2, 3), (1, 1)), "light.color = (1, 1) is not allowed: three finite numbers from 0 to 1e+06"),
        (((1, 2, 3), (-1, 1, 1)), "light.color[0] = -1 is not allowed: a finite number from 0 to 1e+06"),
    ],
)
def test_a_light_says_what_is_allowed(arguments, text):
    assert rejection(Light, *arguments).startswith(text)


@pytest.mark.parametrize(("absent", "place"), [("floor", (3, 0, 0)), ("ball", INSIDE_B)])
def test_what_is_absent_forbids_no_light(absent, place):
    scene = Scene(**{absent: False}, lights=(Light(place),))
    assert (getattr(scene, absent), scene.lights) == (False, (Light(place),))


def test_numbers_are_converted():
    scene = Scene(ku=np.int64(3), ball_center=np.array([0.5, 0.5, 1.3]), lights=[Light([5, 5, 5], [1, 1, 1])])
    assert (scene.ku, scene.ball_center, scene.lights) == (3.0, (0.5, 0.5, 1.3), (Light((5.0, 5.0, 5.0)),))
