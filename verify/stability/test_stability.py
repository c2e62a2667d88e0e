"""Every stress sweep stays under its bounds, and the bounds say something."""

from dataclasses import replace

import numpy as np
import pytest

from proofs.formulas.seed_hit import seed_normal
from proofs.formulas.symbols import normal
from renderer.machines.enclosing import UNIT
from verify.evaluate.arrays import distance, in_balls, in_float64
from verify.stability import symmetry
from verify.stability.geometry import image_points, our_normal, smaller_and_smaller_b, tangent_vector
from verify.stability.rows import SWEEPS, sweep
from verify.test_bounds import cancelling_normal_of_b

ALLOWED = 8 * UNIT


@pytest.mark.parametrize("name", SWEEPS)
def test_no_point_escapes_its_bound(name):
    """And the bounds say something: errors add up like a random walk, bounds like a sum, some tens lie between them."""
    seen = sweep(name)
    assert seen.escaped == 0
    assert seen.points >= 500
    assert 1 < seen.sharpness < 100
    assert seen.in_responses() <= 30


def test_formulas_that_cancel_are_above_30_responses():
    """The seed's, and P − C of the hit for the normal of B."""
    assert sweep("pole").in_responses("seed") > 30
    assert sweep("near_to_far").in_responses("seed") > 30
    assert smaller_and_smaller_b(normal, cancelling_normal_of_b()).in_responses() > 30


def test_the_seeds_normal_is_the_same_in_exact_arithmetic():
    at = image_points(np.linspace(0.1, 1, 9), 5, 1)
    exact = [in_balls(program, at) for program in (seed_normal, our_normal)]
    assert max(distance(*(balls[n.name] for balls in exact)).max() for n in seed_normal.outputs) < 1e-40


@pytest.mark.parametrize("name", ["pole", "near_to_far", "wave_numbers"])
def test_the_seeds_form_escapes(name):
    """The check can fail: other formulas for the same numbers do not pass it."""
    ours = sweep(name)
    for errors in ours.others.values():
        assert replace(ours, errors=errors).escaped > 100


def test_toward_the_pole_nothing_is_lost():
    ours = sweep("pole")
    assert ours.worst().max() <= np.pi * 8 * 9 * ALLOWED  # 8(1 + k) 2⁻⁵³ of π k, k = 8
    assert np.nanmax(ours.worst("seed")) > 1e-3
    assert np.nanmax(ours.worst("seed with fallback")) > 20


@pytest.mark.parametrize("form", ["general", "algebraic"])
def test_the_pole_itself_has_no_bump(form):
    """Below 10⁻¹⁵⁰ of the eye's height it is the pole: the frame is zero, so g is, and N' = N."""
    x, y = np.transpose([(0.0, 0.0), (-0.0, 0.0), (3.9e-150, 0.0), (-2e-150, 2e-150), (0.0, -5e-324)])
    at = {"x": x, "y": y, "eye": 4.0, "radius": 1.0, "k_u": 8.0, "k_v": 4.0}
    assert not np.any([*in_float64(tangent_vector("sine", form), at).values()])


def test_the_silhouette_costs_a_square_root():
    """|ΔN| √s is bounded by a few roundings: half of the digits at s = 2⁻⁵³, none in the middle."""
    ours = sweep("silhouette")
    assert (ours.worst() * np.sqrt(ours.parameter)).max() <= ALLOWED


def test_the_bump_never_costs_a_digit():
    assert sweep("amplitude").worst().max() <= ALLOWED


@pytest.mark.parametrize("name", symmetry.SCENES)
@pytest.mark.parametrize("move", symmetry.MOVES)
def test_symmetric_scenes_have_one_picture(name, move):
    """Each picture is within its bounds of the exact one, so that two of them are within both of each other."""
    largest, above, open_, flips = symmetry.difference(symmetry.SCENES[name], move)
    assert largest <= 1e-13
    assert (above, flips) == (0, 0)
    assert open_ <= 121


def test_what_has_no_symmetry_is_seen():
    odd = symmetry.replace(symmetry.SCENES["ridges"], ku=7.0)
    largest, above, *_ = symmetry.difference(odd, "mirrored in x")
    assert largest > 1e-2
    assert above > 1000


def test_the_order_of_the_lights_rounds_and_does_no_more():
    """Five terms that are not negative, each added with one rounding of a sum below 4: 5 · 4 · 2⁻⁵³."""
    assert symmetry.permuted_lights(symmetry.FIVE_LIGHTS) <= 20 * UNIT
