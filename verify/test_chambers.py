"""Boxes and the reach of A leave no pixel out: chambers are those of a picture that tests every pixel for everything.

`test_bounds` holds chambers and colours to 256-bit balls.
"""

import numpy as np
import pytest

from proofs.formulas.camera import discriminant_a, hit_of_a
from renderer import Light, Scene, stage_of
from renderer.generate.kernels import function_of
from renderer.scene import bounds
from renderer.scene.bounds import EVERYWHERE
from renderer.shader import numbers
from verify.enclosed_pixels import random_raster, random_scene


def chambers(scene, *raster):
    """Return the chambers of a scene, whose boxes are made anew."""
    for cached in (bounds.ball_box, bounds.shadow_boxes):
        cached.cache_clear()
    return stage_of(scene, *raster, threads=1).chambers


def everywhere_tested(scene, *raster):
    """Return the chambers where every pixel is tested for B and for each body's shadow."""
    with pytest.MonkeyPatch.context() as patch:
        for name in ("box", "_shadow_box"):
            patch.setattr(bounds, name, lambda *arguments: EVERYWHERE * 2)
        return chambers(scene, *raster)


def test_random_scenes():
    """The codes are equal to the last bit, and the scenes show every surface, with shadows on each."""
    random, codes = np.random.default_rng(20), set()
    for _ in range(400):
        scene, raster = random_scene(random), random_raster(random)
        codes_here = chambers(scene, *raster)
        np.testing.assert_array_equal(codes_here, everywhere_tested(scene, *raster), f"{scene}, {raster}")
        codes |= {*codes_here.flat}
    assert {0, 1, 2, 3, 5, 6, 7, 131, 135} <= codes


@pytest.mark.parametrize("changes", [
    {"ball_center": (1.5, 0.0, 0.25), "ball_radius": 0.25},  # B touches the floor
    {"ball_center": (0.0, 0.0, 1.5), "ball_radius": 0.5},  # A from outside
    {"ball_center": (0.0, 0.0, 0.0), "ball_radius": 1.0},  # is A
    {"ball_center": (2.0, 0.0, 4.0), "ball_radius": 1.0},  # is level with the eye
    {"lights": (Light((3.0, 0.0, 1.0)),)},  # level with A's top
])  # fmt: skip
def test_bodies_that_touch_or_are_level(changes):
    scene = Scene(**changes)
    np.testing.assert_array_equal(chambers(scene, 61, 64), everywhere_tested(scene, 61, 64))


DISCRIMINANT = function_of(hit_of_a.keep(discriminant_a))
RANDOM = np.random.default_rng(21)
LENSES = list(zip(10 ** RANDOM.uniform(-60, 60, 400), 10 ** RANDOM.uniform(-6, -1e-9, 400), strict=True))
"""(radius, its share of the eye's height): scales and ratios up to the ends of what a scene accepts."""


def misjudged(radius, ratio):
    """Return how many points x² + y² ≤ reach judges otherwise than the sign of the discriminant.

    They are the last points that are on A at some heights, and their neighbours in float64.
    """
    eye = radius / ratio
    reach = numbers.reach_of_a(eye, radius)
    y = np.sqrt(reach) * np.append(RANDOM.uniform(-1, 1, 199), 0.0)
    edge = np.sqrt(np.maximum(0.0, reach - y * y))
    x = edge + np.arange(-4, 5)[:, None] * np.spacing(edge)
    on_a = DISCRIMINANT(x, y, eye, radius) >= 0
    assert 0 < on_a.sum() < on_a.size
    return np.count_nonzero(on_a != (x * x + y * y <= reach))


def test_the_reach_of_a_has_the_sign_of_its_discriminant():
    assert not any(misjudged(*lens) for lens in LENSES)
