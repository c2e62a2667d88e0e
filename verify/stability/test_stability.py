"""Every stress sweep stays under its bounds, and these are not far too large; facts that maps show."""

from dataclasses import replace

import numpy as np
import pytest

from proofs.formulas.certified import GENERAL_GRADIENT
from proofs.formulas.seed_hit import seed_normal
from renderer.machines.enclosing import UNIT
from verify.evaluate.arrays import distance, in_balls
from verify.stability.geometry import image_points, our_normal
from verify.stability.rows import SWEEPS, sweep

ALLOWED = 8 * UNIT


@pytest.mark.parametrize("name", SWEEPS)
def test_no_point_escapes_its_bound(name):
    """Nor are bounds far too large: errors add up like a random walk, bounds like a sum: some tens lie between."""
    measured = sweep(name)
    assert measured.escaped == 0
    assert measured.points >= 500
    assert 1 < measured.sharpness < 100
    assert measured.in_responses() <= 30
    assert measured.errors.max() <= GENERAL_GRADIENT * UNIT or not name.startswith("wave_numbers")


def test_formulas_that_cancel_are_above_30_responses():
    """The seed's formula cancels, though it is the same in exact arithmetic."""
    for name in ("pole", "near_to_far"):
        assert sweep(name).in_responses("seed") > 30
    at = image_points(np.linspace(0.1, 1, 9), 5, 1) | {"radius": 1.25}
    seed, ours = (in_balls(program, at) for program in (seed_normal, our_normal))
    assert max(distance(seed[name], ours[name]).max() for name in seed) < 1e-40


@pytest.mark.parametrize("name", ["pole", "near_to_far", "wave_numbers_sine"])
def test_the_seeds_form_escapes(name):
    """The check can fail: other formulas for the same numbers do not pass it."""
    ours = sweep(name)
    for errors in ours.others.values():
        assert replace(ours, errors=errors).escaped > 100


def test_the_silhouette_costs_a_square_root():
    """|ΔN| √s is bounded by a few roundings: half of the digits at s = 2⁻⁵³, none in the middle."""
    ours = sweep("silhouette")
    assert (ours.worst() * np.sqrt(ours.parameter)).max() <= ALLOWED
