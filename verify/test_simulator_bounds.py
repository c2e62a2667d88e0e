"""What the simulator draws behind its U-curve: the theorems' own bounds, with parameters that hold."""

import random
import re
from pathlib import Path

import mpmath
import numpy as np
import pytest
from sympy import pi, simplify

from proofs.formulas import step_bounds
from proofs.formulas.symbols import k_u, v
from proofs.theorems import clamped, roundoff, truncation
from renderer import Scene
from renderer.gradients import height_at

CURVE = Path(__file__).resolve().parent.parent / "book" / "static" / "simulator" / "curve.js"


def test_the_truncation_bound_is_the_theorems():
    claim = truncation.theorem.claims[0]
    upper, lower = claim.shows[-2].lhs, claim.shows[-1].lhs
    ours = step_bounds.truncation_bound.expand(step_bounds.truncation).xreplace({step_bounds.frequency: k_u})
    assert simplify((upper + lower) / 2 - ours) == 0
    assert simplify((upper + lower) / 2 - 2 * ours) != 0


def test_the_clamped_bound_is_the_theorems():
    claim = next(c for c in clamped.second_order.claims if c.name == "second_order")
    upper, lower = (relation.lhs for relation in claim.shows[-2:])
    given = {clamped.largest: (pi * step_bounds.frequency) ** 3}
    ours = step_bounds.clamped_bound.expand(step_bounds.truncation)
    assert simplify((upper + lower).xreplace(given) / 2 - ours) == 0
    assert simplify((upper + lower).xreplace(given) / 2 - ours.xreplace({v: 0})) != 0


def test_the_rounding_bound_is_the_theorems():
    claim = roundoff.theorem.claims[0]
    upper, lower = (relation.lhs for relation in claim.shows[-2:])
    ours = step_bounds.rounding_bound.expand(step_bounds.rounding)
    assert simplify((upper + lower) / 2 - ours) == 0
    assert simplify((upper + lower) / 2 - ours.xreplace({step_bounds.unit: 0})) != 0


def test_the_caps_are_the_steepest_slope_once_and_twice():
    slope = step_bounds.slope_bound.expand(step_bounds.steepest)
    assert slope == pi * step_bounds.frequency
    assert step_bounds.crease_bound.expand(step_bounds.apart) == 2 * slope


def parameter(name):
    """Return a power-of-two constant of the plot's source, as a float."""
    whole, exponent = re.search(rf"{name} = (?:(\d+) \* )?2 \*\* (-\d+)", CURVE.read_text(encoding="utf-8")).groups()
    return int(whole or 1) * 2.0 ** int(exponent)


@pytest.mark.parametrize("field", ["sine", "ridges", "rings"])
def test_heights_are_as_good_as_the_plot_assumes(field):
    rng, worst = random.Random(field), 0.0
    for _ in range(2000):
        u, v, k_u, k_v = rng.random(), rng.random(), rng.uniform(-64, 64), rng.uniform(-64, 64)
        with mpmath.workdps(50):
            one = mpmath.sinpi(mpmath.mpf(k_u) * u) * mpmath.sinpi(mpmath.mpf(k_v) * v)
            exact = {"sine": one, "ridges": abs(one), "rings": mpmath.sinpi(2 * mpmath.mpf(k_v) * v)}[field]
            worst = max(worst, abs(float(exact - float(height_at(Scene(field=field, ku=k_u, kv=k_v), u, v)))))
    assert 0 < worst <= parameter("HEIGHT_ERROR")


def test_a_moved_argument_is_off_by_no_more_than_the_plot_assumes():
    rng, worst = np.random.default_rng(7), 0.0
    for u, eps in zip(rng.random(5000), 10.0 ** rng.uniform(-16, -1, 5000), strict=True):
        with mpmath.workdps(50):
            worst = max(worst, *(abs(float(mpmath.mpf(u) + s * mpmath.mpf(eps) - (u + s * eps))) for s in (1, -1)))
    assert 0.4 * parameter("ARGUMENT_ERROR") < worst <= parameter("ARGUMENT_ERROR")
    assert parameter("UNIT") == 2.0**-53
