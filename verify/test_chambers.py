"""Boxes and the reach of A leave no pixel out: chambers are those of the whole program at every pixel.

That colours are, too, `test_bounds` holds to 256-bit balls.
"""

import os
from itertools import product

import numpy as np
import pytest

from proofs.formulas.camera import discriminant_a, hit_of_a
from renderer import Light, Scene, render, stage_of
from renderer.generate.kernels import function_of
from renderer.scene import bounds
from renderer.shader import numbers
from verify.strict import differing_pixels, random_raster, random_scene, strict_chambers

SCENES = 10_000 if os.environ.get("HYPOTHESIS_PROFILE") == "long" else 400


def test_random_scenes():
    """To the last bit; and the scenes do show every surface, and shadows on each."""
    random, codes = np.random.default_rng(20), set()
    for _ in range(SCENES):
        scene, raster = random_scene(random), random_raster(random)
        assert differing_pixels(scene, *raster) == 0, (scene, raster)
        codes |= {*stage_of(scene, *raster).chambers.flat}
    assert {0, 1, 2, 3, 5, 6, 7, 131, 135} <= codes


def test_the_count_sees_a_moved_boundary():
    """That of pixels whose chamber is another is not zero when a boundary does move: B a little larger."""
    assert np.count_nonzero(render(Scene(ball_radius=0.35), 72, 72).chambers != strict_chambers(Scene(), 72, 72)) > 0


TOUCHING = {
    "B touches the floor": {"ball_center": (1.5, 0.0, 0.25), "ball_radius": 0.25},
    "B touches A from outside": {"ball_center": (0.0, 0.0, 1.5), "ball_radius": 0.5},
    "B equal to A": {"ball_center": (0.0, 0.0, 0.0), "ball_radius": 1.0},
    "B level with the eye": {"ball_center": (2.0, 0.0, 4.0), "ball_radius": 1.0},
    "a light level with A's top": {"lights": (Light((3.0, 0.0, 1.0)),)},
}
"""What random scenes do not have: bodies that touch, or are level with one another."""


@pytest.mark.parametrize("case", TOUCHING)
@pytest.mark.parametrize("size", [(61, 64), (64, 61), (1, 33), (33, 1)])
def test_degenerate_scenes(case, size):
    assert differing_pixels(Scene(**TOUCHING[case]), *size) == 0


@pytest.mark.parametrize("name, value, light", [
    ("_casts", lambda *where: False, (-3.0, -3.0, -1.0)),  # as if A cleared every cone of light: it shades B here
    ("GUARD", -0.05, (5.0, 5.0, 10.0)),
])  # fmt: skip
def test_boxes_that_leave_pixels_out_are_noticed(name, value, light, monkeypatch):
    """By a scene that nobody else draws: what is known of one is kept."""
    monkeypatch.setattr(bounds, name, value)
    assert differing_pixels(Scene(eye=4.02, lights=(Light(light),)), 64, 64) > 0


DISCRIMINANT = function_of(hit_of_a.keep(discriminant_a))
RANDOM = np.random.default_rng(21)
RATIOS = 10.0 ** RANDOM.uniform(-6, -1e-9, 300)
LENSES = [
    *product((1e-60, 0.37, 1.0, 1e60), (1e-6, 0.01, 0.25, 0.9, 1 - 1e-9)),
    *zip(10 ** RANDOM.uniform(-60, 60, 300), RATIOS, strict=True),
]
"""(radius, its share of the eye's height): scales and ratios up to the ends of what a scene accepts."""


def misjudged(radius, ratio, towards=None):
    """Return how many points x² + y² ≤ reach judges otherwise than the sign of the discriminant.

    They are the last points that are on A at some heights, and their neighbours in float64; towards: what the reach is
    moved to by one unit.
    """
    eye = radius / ratio
    reach = numbers.reach_of_a(eye, radius)
    y = np.sqrt(reach) * np.append(RANDOM.uniform(-1, 1, 199), 0.0)
    edge = np.sqrt(np.maximum(0.0, reach - y * y))
    x = edge + np.arange(-4, 5)[:, None] * np.spacing(edge)
    on_a = DISCRIMINANT(x, y, eye, radius) >= 0
    assert 0 < on_a.sum() < on_a.size
    judged = reach if towards is None else np.nextafter(reach, towards)
    return np.count_nonzero(on_a != (x * x + y * y <= judged))


def test_the_reach_of_a_has_the_sign_of_its_discriminant():
    assert not any(misjudged(*lens) for lens in LENSES)


def test_a_reach_that_is_off_by_one_unit_is_noticed():
    for towards in (0.0, np.inf):
        assert any(misjudged(*lens, towards) for lens in LENSES)
