"""The renderer's spans, boxes and kernels against the strict reference, which skips nothing."""

from dataclasses import replace

import numpy as np
import pytest

from renderer import Light, Scene, exact, render, stage_of
from verify.strict import random_scene, strict_chambers, strict_rgb

SCENES = 300  # 10⁴ in `make bench`


def test_chambers_are_the_same_to_the_last_bit():
    rng, codes = np.random.default_rng(2), set()
    for _ in range(SCENES):
        scene, width, height = random_scene(rng)
        strict = strict_chambers(scene, width, height)
        np.testing.assert_array_equal(stage_of(scene, width, height).chambers, strict, err_msg=f"{scene}")
        codes |= set(np.unique(strict).tolist())
    assert {0, 1, 2, 3, 5, 6, 7, 131, 135} <= codes  # the scenes do show every surface, and shadows on each


def test_a_light_that_is_off_casts_no_shadow():
    scene = Scene(lights=(Light((5, 5, 10), None), Light((-6, 2, 8))))
    strict = strict_chambers(scene, 64, 64)
    np.testing.assert_array_equal(render(scene, 64, 64).chambers, strict)
    assert not (strict & 4).any() and (strict & 8).any()


@pytest.mark.parametrize("form", ["algebraic", "general"])
@pytest.mark.parametrize(("field", "model"), [("sine", "phong"), ("ridges", "blinn"), ("rings", "blinn")])
def test_the_image_agrees(field, model, form):
    scene = Scene(field=field, model=model)
    assert np.abs(render(scene, 96, 96, exact(form)).rgb - strict_rgb(scene, 96, 96)).max() <= 1e-13


def test_another_scene_is_told_apart():
    scene = Scene()
    assert (strict_chambers(scene, 64, 64) != stage_of(replace(scene, ball_radius=0.3), 64, 64).chambers).any()
    assert np.abs(strict_rgb(scene, 64, 64) - render(replace(scene, beta=0.3500001), 64, 64).rgb).max() > 1e-13
