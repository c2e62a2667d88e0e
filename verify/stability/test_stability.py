"""Every stress sweep stays under its bounds, and the bounds say something; what maps show is so."""

from dataclasses import replace

import numpy as np
import pytest

from proofs.engine.program import chain
from proofs.formulas.camera import point_on_b
from proofs.formulas.seed_hit import seed_normal
from proofs.formulas.symbols import ball_center, ball_radius, normal, point
from renderer.machines.enclosing import UNIT
from verify.evaluate.arrays import distance, in_balls
from verify.stability import maps, symmetry
from verify.stability.geometry import image_points, our_normal, smaller_and_smaller_b
from verify.stability.rows import SWEEPS, sweep

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
    """The seed's, though it is the same in exact arithmetic, and P − C of the hit for the normal of B."""
    outward = {n: (p - c) / ball_radius for n, p, c in zip(normal, point, ball_center, strict=True)}
    cancelling = chain("normal_of_b", point_on_b, outward, outputs=normal)
    assert smaller_and_smaller_b(normal, cancelling).in_responses() > 30
    for name in ("pole", "near_to_far"):
        assert sweep(name).in_responses("seed") > 30
    at = image_points(np.linspace(0.1, 1, 9), 5, 1) | {"radius": 1.25}
    seed, ours = (in_balls(program, at) for program in (seed_normal, our_normal))
    assert max(distance(seed[name], ours[name]).max() for name in seed) < 1e-40


@pytest.mark.parametrize("name", ["pole", "near_to_far", "wave_numbers"])
def test_the_seeds_form_escapes(name):
    """The check can fail: other formulas for the same numbers do not pass it."""
    ours = sweep(name)
    for errors in ours.others.values():
        assert replace(ours, errors=errors).escaped > 100


def test_the_silhouette_costs_a_square_root():
    """|ΔN| √s is bounded by a few roundings: half of the digits at s = 2⁻⁵³, none in the middle."""
    ours = sweep("silhouette")
    assert (ours.worst() * np.sqrt(ours.parameter)).max() <= ALLOWED


def test_the_bump_never_costs_a_digit():
    assert sweep("amplitude").worst().max() <= ALLOWED


def test_what_has_no_symmetry_is_seen():
    odd = replace(symmetry.SCENES["ridges"], ku=7.0)
    largest, above, *_ = symmetry.difference(odd, "mirrored in x")
    assert largest > 1e-2 and above > 1000


def test_the_order_of_the_lights_rounds_and_does_no_more():
    """Five terms that are not negative, each added with one rounding of a sum below 4: 5 · 4 · 2⁻⁵³."""
    assert symmetry.permuted_lights(symmetry.FIVE_LIGHTS) <= 20 * UNIT


def test_over_the_chart_ours_is_right_to_the_last_places():
    """Ours ≤ 16 roundings of h_u itself, wherever, and 0 on a crease; the seed's form misses those zeros altogether."""
    found = maps.over_the_chart(side=64)
    assert found["ours"].max() <= 16 and found["seed"].max() == maps.MISSED_ZERO
