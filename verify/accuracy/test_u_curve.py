"""The U-curve taken apart: the three parts make the whole, a point above its bound is seen, and the best step is.

That every point lies below its bound is the theorem `difference_bounds`, run with the others.
"""

import numpy as np
import pytest
from flint import arb, ctx

from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from renderer import central, exact, gradient_at
from verify.accuracy import best_step, u_curve
from verify.accuracy.difference_bounds import Bounds, bounds, escapes
from verify.accuracy.differences import CASES, STEPS, by_the_kernel, parts, taken_apart
from verify.accuracy.ridge_law import SCENE, predicted, quadrature
from verify.evaluate.arrays import in_balls
from verify.evaluate.balls import ball_of

STEEP = CASES[0]
SOME = STEPS[::20]


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_the_differences_are_the_renderers(case):
    at = {name: np.full(len(SOME), value) for name, value in case.inputs.items()} | {"epsilon": SOME}
    one_by_one = [gradient_at(case.scene, case.u, case.v, central(float(step))) for step in SOME]
    assert by_the_kernel(case.field, at)[case.component].tolist() == [
        float(found[case.component == "h_v"]) for found in one_by_one
    ]


def test_mpmath_and_the_balls_measure_the_same():
    """The slope to 48 digits; errors and truncation to the last places of float64; a wrong reference is seen."""
    at = {"u": STEEP.u, "v": STEEP.v}
    ball, slope = in_balls(gradient(HEIGHT_FIELDS["sine"]), STEEP.inputs)["h_u"].item(), u_curve.exact_slope(**at)
    with ctx.workprec(300):
        assert ball.rad() < 1e-60 and abs(ball - ball_of(slope)) < arb(10) ** -48
    found = parts(STEEP, SOME)
    np.testing.assert_allclose(u_curve.errors(**at, steps=SOME), np.abs(found.total), rtol=1e-14)
    np.testing.assert_allclose(u_curve.truncation(**at, steps=SOME), np.abs(found.truncation), rtol=1e-14)
    assert np.abs(u_curve.truncation(0.6100001, STEEP.v, SOME) - np.abs(found.truncation)).max() > 1e-7


@pytest.mark.parametrize("eps", [3e-2, 1e-5, 1e-8, 1e-12])
@pytest.mark.parametrize("field", ["ridges", "sine", "rings"])
def test_the_parts_make_the_whole_over_points(field, eps):
    u, v = np.random.default_rng(12).uniform(0.02, 0.98, (2, 150))
    for *three, whole in taken_apart(field, {"u": u, "v": v, "k_u": 8.0, "k_v": 4.0}, eps).values():
        np.testing.assert_allclose(np.sum(three, axis=0), whole, rtol=1e-6, atol=1e-14)


def test_truncation_has_its_closed_form():
    """For a sine the exact difference is the slope times sinc."""
    found, angle = parts(STEEP, SOME), np.pi * STEEP.k_u * SOME
    wanted = found.slope * (np.sinc(angle / np.pi) - 1)
    np.testing.assert_allclose(found.truncation[angle > 1e-3], wanted[angle > 1e-3], rtol=1e-8)


def test_an_escape_is_seen():
    found = parts(STEEP, SOME)
    limits = bounds(STEEP, found)
    assert not any(escapes(found, limits).values())
    assert any(escapes(found, Bounds(*(limit / 4 for limit in limits))).values())
    assert escapes(found._replace(total=found.total + np.nan), limits)["total"] == len(SOME)
    shifted = parts(STEEP, SOME, computed=found.slope + found.total + 1e-4)  # a kernel that is off by 1e-4
    assert escapes(shifted, bounds(STEEP, shifted))["roundoff"] > 10


def test_a_representable_step_leaves_no_error_in_the_arguments():
    step = best_step.representable_step(0.61, 1e-7)
    assert step != 1e-7
    assert parts(STEEP, [step]).argument[0] == 0
    assert parts(STEEP, [1e-7]).argument[0] != 0


@pytest.mark.parametrize(("k", "most"), [(8, 1.5), (512, 3.0)])
def test_representable_steps_need_a_sine_of_an_exact_argument(k, most):
    assert 0.5 < best_step.gain(k, library=True) < most < best_step.gain(k) / 2


@pytest.mark.parametrize("k", [1, 8, 512])
@pytest.mark.parametrize("representable", [False, True])
def test_the_best_step_is_where_it_is_predicted(k, representable):
    proved, seen = best_step.predicted(k, representable), best_step.measured(k, representable)
    assert proved.step / 4 < seen.step < proved.step * 2
    assert proved.floor / 20 < seen.floor <= proved.floor


def test_random_points_would_miss_the_law():
    """Below ε ≈ 6e-5 a hundred random points see no band; the quadrature does."""
    step = 1e-7
    right = predicted("h_u", step)[0]
    assert abs(quadrature("h_u", step) / right - 1) < 0.02
    u = np.random.default_rng(1).random(100)
    numeric, symbolic = (gradient_at(SCENE, u, 0.3, method)[0] for method in (central(step), exact()))
    assert np.sqrt(((numeric - symbolic) ** 2).mean()) < right / 100
