"""Skipped work: the counts hold that a scene computes only its own, not the clock."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from renderer import HeightField, Light, Scene, central, central4, cospi, exact, forward, k_u, render, stage_of, u

pytestmark = pytest.mark.usefixtures("by_numpy")
DEFAULT = Scene()
SIZE = (64, 64)
METHODS = [(exact(), 0, 0), (forward(1e-3), 3, 2), (central(1e-3), 4, 2), (central4(1e-3), 8, 4)]


def work_of(method=None, options=None, **fields):
    """Return what was computed for the default scene, with other fields."""
    return SimpleNamespace(**render(replace(DEFAULT, **fields), *SIZE, method, **options or {}).work)


@pytest.mark.parametrize("method, heights, of_rings", METHODS)
def test_height_evaluations(method, heights, of_rings):
    """There are none without a bump; rings have no difference in u."""
    work = work_of(method)
    assert work.pixels_a > 1000
    assert work.height_evaluations == heights * work.pixels_a
    assert work.gradient_evaluations == (work.pixels_a if method == exact() else 0)
    assert work_of(method, field="rings").height_evaluations == of_rings * work.pixels_a
    flat = work_of(method, beta=0.0)
    assert (flat.gradient_evaluations, flat.height_evaluations, flat.algebraic_gradients) == (0, 0, 0)


def test_what_is_counted_in_a_picture():
    """An occluded light costs no light term; shadows are tested where they can fall."""
    frame = render(DEFAULT, *SIZE)
    work, surface = SimpleNamespace(**frame.work), frame.chambers & 3
    codes, counts = np.unique(frame.chambers, return_counts=True)
    assert work.pixels == dict(zip(codes.tolist(), counts.tolist(), strict=True))
    lit = sum(int(((frame.chambers & bit == 0) & (surface > 0)).sum()) for bit in (4, 8))
    assert work.light_terms == work.specular_powers == lit
    occluded = 2 * (surface > 0).sum() - lit
    assert occluded < work.shadow_tests < work.pixels_a + work.pixels_b + 2 * work.pixels_floor


def test_what_is_not_there_is_not_computed():
    """Without ball, floor, highlight or lights, or with a light that is off or black, their counts are 0."""
    (first, second), scene = DEFAULT.lights, work_of()
    one, black = work_of(lights=(first,)), work_of(lights=(first, replace(second, color=(0.0, 0.0, 0.0))))
    assert work_of(lights=(first, replace(second, color=None))) == one
    none, without_ball, diffuse = (work_of(**fields) for fields in ({"lights": ()}, {"ball": False}, {"ks": 0.0}))
    assert none.light_terms == none.shadow_tests == none.specular_powers == diffuse.specular_powers == 0
    assert work_of(ball=False, floor=False).shadow_tests == 0 < without_ball.shadow_tests
    assert without_ball.shadow_tests <= 2 * without_ball.pixels_floor
    assert diffuse.light_terms == scene.light_terms > black.light_terms == one.light_terms > 0


def test_a_body_that_clears_the_cone_of_light():
    """A cannot shade B in the chapter's scene; it can once a light stands so low that A is between them.

    A body that is out of a light's reach shades nothing.
    """
    alone = work_of(floor=False)
    assert 0 < alone.shadow_tests <= 2 * alone.pixels_a
    low = work_of(floor=False, lights=(Light((-3.0, -3.0, -1.0)),))
    assert low.shadow_tests >= low.pixels_b > 0
    below = {"ball_center": (0.0, 0.0, -9.0), "lights": (Light((5.0, 5.0, 10.0)),)}
    assert work_of(**below).shadow_tests == work_of(**below, ball=False).shadow_tests


def test_a_stage_leaves_sphere_a_alone_to_be_drawn():
    """The colours off A are drawn once for a shading."""
    staged = {"stage": stage_of(DEFAULT, *SIZE)}
    terms, first = work_of().light_terms, work_of(options=staged)
    assert (first.shadow_tests, first.light_terms) == (0, terms)
    on_a = sum(n for code, n in first.pixels.items() for bit in (4, 8) if code & 3 == 1 and not code & bit)
    assert work_of(central(1e-3), staged).light_terms == on_a
    assert work_of(options=staged, beta=2.0, field="sine", ku=3.0).light_terms == on_a
    assert work_of(options=staged, ka=0.2).light_terms == terms


BLACK = tuple(Light(light.position, (0.0, 0.0, 0.0)) for light in DEFAULT.lights)
WAVES = HeightField("waves", cospi(k_u * u))


@pytest.mark.parametrize("method", [exact(), central(1e-3)])
@pytest.mark.parametrize("fields, same_as", [
    ({"ku": 0.0, "field": WAVES}, {"beta": 0.0}),
    ({"kv": 0.0, "bump": "surface"}, {"beta": 0.0}),
    ({"kd": 0.0, "ks": 0.0}, {"lights": BLACK}),
    ({"lights": BLACK}, {"lights": ()}),
])  # fmt: skip
def test_a_bump_that_is_not_seen_costs_no_gradient(fields, same_as, method):
    """Nor a light term where nothing scatters; the field's slopes stay. Rings have theirs in v alone."""
    frame = render(replace(DEFAULT, **fields, floor=False), *SIZE, method)
    np.testing.assert_array_equal(frame.rgb, render(replace(DEFAULT, **same_as, floor=False), *SIZE, method).rgb)
    level = "beta" in same_as
    counted = [frame.work[kind] > 0 for kind in ("gradient_evaluations", "height_evaluations", "light_terms")]
    assert counted == [False, False, level] and frame.slope.any() != level
    rings = work_of(method, field="rings", ku=0.0)
    assert rings.gradient_evaluations + rings.height_evaluations > 0


@pytest.mark.parametrize("scene", [Scene(field="sine", ku=0.0), Scene(field="sine", kd=0.0, ks=0.0)])
def test_a_bump_that_is_not_seen_costs_none_where_its_slopes_are_not_asked(scene):
    works = [render(scene, 16, 16, derivatives=[name]).work["gradient_evaluations"] for name in ("ka", "beta", "kd")]
    assert works[:2] == [0, 0] and (scene.ku == 0.0 or works[2] > 0)
