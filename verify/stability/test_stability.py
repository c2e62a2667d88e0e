"""Every stress sweep stays under its bounds, and the bounds say something."""

import numpy as np
import pytest

from proofs.formulas.seed_hit import seed_normal
from renderer.machines.enclosing import UNIT
from verify.evaluate.arrays import distance, in_balls, in_float64
from verify.stability import symmetry
from verify.stability.geometry import image_points
from verify.stability.pipelines import our_normal, tangent_vector
from verify.stability.rows import SWEEPS, sweep
from verify.stability.sweep import Sweep

ALLOWED = 8 * UNIT


@pytest.mark.parametrize("name", SWEEPS)
def test_no_point_escapes_its_bound(name):
    """And the bounds say something: errors add up like a random walk, bounds like a sum, some tens lie between them."""
    seen = sweep(name)
    assert seen.escaped == 0
    assert seen.undecided <= seen.points // 100 > 4
    assert 1 < seen.sharpness < 100


def test_the_seeds_normal_is_the_same_in_exact_arithmetic():
    at = image_points(np.linspace(0.1, 1, 9), 5, 1)
    exact = [in_balls(program, at) for program in (seed_normal, our_normal)]
    assert max(distance(*(balls[n.name] for balls in exact)).max() for n in seed_normal.outputs) < 1e-40


@pytest.mark.parametrize("name", ["pole", "near_to_far", "wave_numbers"])
def test_the_seeds_form_escapes(name):
    """The check can fail: other formulas for the same numbers do not pass it."""
    ours = sweep(name)
    for errors in ours.others.values():
        assert Sweep(ours.parameter, errors, ours.bounds).escaped > 100


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
    """Each picture is within 5·10⁻¹⁴ of the exact one, so that two of them are within 10⁻¹³ of each other."""
    largest, creased, flips = symmetry.difference(symmetry.SCENES[name], move)
    assert largest <= 1e-13
    assert flips == 0
    assert creased <= 121


def test_what_has_no_symmetry_is_seen():
    odd = symmetry.replace(symmetry.SCENES["ridges"], ku=7.0)
    assert symmetry.difference(odd, "mirrored in x")[0] > 1e-2


def test_the_order_of_the_lights_rounds_and_does_no_more():
    """Five terms that are not negative, each added with one rounding of a sum below 4: 5 · 4 · 2⁻⁵³."""
    assert symmetry.permuted_lights(symmetry.FIVE_LIGHTS) <= 20 * UNIT
