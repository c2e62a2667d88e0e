"""What a scene does not need is not computed: the counts hold it, not the clock."""

from dataclasses import replace

import numpy as np
import pytest

from renderer import Light, Scene, central, central4, exact, forward, render, stage_of

DEFAULT = Scene()
SIZE = (64, 64)
METHODS = [(exact(), 0, 0), (forward(1e-3), 3, 2), (central(1e-3), 4, 2), (central4(1e-3), 8, 4)]


def work_of(scene=DEFAULT, method=None, **options):
    return render(scene, *SIZE, method, **options).work


@pytest.mark.parametrize(("method", "heights", "of_rings"), METHODS)
def test_height_evaluations(method, heights, of_rings):
    work = work_of(method=method)
    assert work["pixels_a"] > 1000
    assert work["height_evaluations"] == heights * work["pixels_a"]
    assert work["gradient_evaluations"] == (work["pixels_a"] if method == exact() else 0)
    rings = work_of(replace(DEFAULT, field="rings"), method)  # no difference in u
    assert rings["height_evaluations"] == of_rings * rings["pixels_a"]


@pytest.mark.parametrize("method", [exact(), exact("general"), central(1e-3)])
def test_no_bump_no_gradient(method):
    work = work_of(replace(DEFAULT, beta=0.0), method)
    assert (work["gradient_evaluations"], work["height_evaluations"], work["algebraic_gradients"]) == (0, 0, 0)


def test_pixels_of_every_chamber():
    frame = render(DEFAULT, *SIZE)
    codes, counts = np.unique(frame.chambers, return_counts=True)
    assert frame.work["pixels"] == dict(zip(codes.tolist(), counts.tolist(), strict=True))
    counted = [int((frame.chambers & 3 == surface).sum()) for surface in (1, 2, 3)]
    assert [frame.work[name] for name in ("pixels_a", "pixels_b", "pixels_floor")] == counted


def test_shadows_are_tested_where_they_can_fall():
    work = work_of()
    everywhere = 2 * (work["pixels_a"] + work["pixels_b"] + 2 * work["pixels_floor"])
    occluded = sum(pixels for code, pixels in work["pixels"].items() for bit in (4, 8) if code & bit)
    assert occluded < work["shadow_tests"] < everywhere / 2


def test_no_ball_no_floor():
    alone = work_of(replace(DEFAULT, ball=False, floor=False))
    assert alone["shadow_tests"] == 0 == alone["pixels_b"] == alone["pixels_floor"]
    without_ball = work_of(replace(DEFAULT, ball=False))
    assert 0 < without_ball["shadow_tests"] <= 2 * without_ball["pixels_floor"]


def test_a_light_that_is_off_or_black():
    first, second = DEFAULT.lights
    one = work_of(replace(DEFAULT, lights=(first,)))
    off = work_of(replace(DEFAULT, lights=(first, replace(second, color=None))))
    assert {**off, "pixels": None} == {**one, "pixels": None}
    black = work_of(replace(DEFAULT, lights=(first, replace(second, color=(0.0, 0.0, 0.0)))))
    assert black["light_terms"] == one["light_terms"] > 0
    assert black["shadow_tests"] > one["shadow_tests"]  # its shadows are chambers, though nothing shows them
    none = work_of(replace(DEFAULT, lights=()))
    assert (none["light_terms"], none["shadow_tests"], none["specular_powers"]) == (0, 0, 0)


def test_a_body_out_of_the_lights_reach():
    below = replace(DEFAULT, ball_center=(0.0, 0.0, -9.0), lights=(Light((5.0, 5.0, 10.0)),))
    assert work_of(below)["shadow_tests"] == work_of(replace(below, ball=False))["shadow_tests"]


def test_a_body_that_clears_the_cone_of_light():
    """A cannot shade B in the chapter's scene; it can once a light stands so low that A is between them."""
    alone = work_of(replace(DEFAULT, floor=False))
    assert 0 < alone["shadow_tests"] <= 2 * alone["pixels_a"]
    low = replace(DEFAULT, floor=False, lights=(Light((-3.0, -3.0, -1.0)),))
    assert work_of(low)["shadow_tests"] >= work_of(low)["pixels_b"] > 0


def test_an_occluded_light_is_not_computed():
    frame = render(DEFAULT, *SIZE)
    lit = sum(int(((frame.chambers & bit == 0) & (frame.chambers & 3 > 0)).sum()) for bit in (4, 8))
    assert frame.work["light_terms"] == frame.work["specular_powers"] == lit


def test_no_highlight_where_its_weight_is_zero():
    diffuse = work_of(replace(DEFAULT, ks=0.0))
    assert diffuse["specular_powers"] == 0
    assert diffuse["light_terms"] == work_of()["light_terms"]


def test_a_crop_computes_its_pixels_alone():
    work = work_of(crop=(20, 30, 7, 5))
    assert sum(work["pixels"].values()) == 35
    assert work["gradient_evaluations"] == work["pixels_a"] <= 35


def test_views_are_made_when_asked_for():
    frame = render(DEFAULT, *SIZE)
    assert not {"work", "planes_on_a", "surface_data"} & set(vars(frame))
    _ = frame.slope
    assert "planes_on_a" in vars(frame)


def test_a_stage_leaves_sphere_a_alone_to_be_drawn():
    stage = stage_of(DEFAULT, *SIZE)
    first = work_of(stage=stage)
    assert first["shadow_tests"] == 0
    assert first["light_terms"] == work_of()["light_terms"]  # the colours off A are drawn once
    for scene, method in ((DEFAULT, central(1e-3)), (replace(DEFAULT, beta=2.0, field="sine", ku=3.0), exact())):
        work = work_of(scene, method, stage=stage)
        on_a = sum(n for code, n in work["pixels"].items() for bit in (4, 8) if code & 3 == 1 and not code & bit)
        assert work["light_terms"] == on_a
    into = work_of(stage=stage, into=render(DEFAULT, *SIZE, stage=stage))
    assert into["light_terms"] == work["light_terms"]
    darker = work_of(replace(DEFAULT, ka=0.2), stage=stage)
    assert darker["light_terms"] == first["light_terms"]  # another shading off A
