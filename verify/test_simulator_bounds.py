"""What the simulator draws behind its U-curve: the theorems' own bounds, with parameters that hold; and its creases."""

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from sympy import Abs, pi, simplify

from proofs.formulas import step_bounds
from proofs.formulas.half_turns import cospi, sinpi
from proofs.formulas.height_fields import HEIGHT_FIELDS, HeightField, gradient, height
from proofs.formulas.symbols import k_u, k_v, u, v
from proofs.theorems import clamped, roundoff, truncation
from renderer.generate.creases import crease_point, crease_rates
from renderer.generate.kernels import function_of
from renderer.generate.step_terms import ARGUMENT_ERROR, BOUNDS, HEIGHT_ERROR, TERMS, UNIT, bounds_of, is_covered
from renderer.kernels import FIELDS, angles_on_a, chart
from renderer.shader.shader import difference
from verify.evaluate.arrays import distance, in_balls, in_float64

SINE, RIDGES = HEIGHT_FIELDS["sine"], HEIGHT_FIELDS["ridges"]
EXACT = {name: function_of(gradient(field)) for name, field in HEIGHT_FIELDS.items()}
SLANTED = HeightField("slanted", Abs(sinpi(k_u * u + k_v * v)))


second_order = next(c for c in clamped.second_order.claims if c.name == "second_order")
BOUNDED = {  # the claim, our bound, what the claim's symbols stand for, and a change of ours that is seen
    "truncation": (truncation.theorem.claims[0], step_bounds.truncation_bound.expand(step_bounds.truncation),
                   {k_u: step_bounds.frequency}, {step_bounds.frequency: 2 * step_bounds.frequency}),
    "clamped": (second_order, step_bounds.clamped_bound.expand(step_bounds.truncation),
                {clamped.largest: (pi * step_bounds.frequency) ** 3}, {v: 0}),
    "rounding": (roundoff.theorem.claims[0], step_bounds.rounding_bound.expand(step_bounds.rounding),
                 {roundoff.excess: 2 * step_bounds.unit + step_bounds.unit**2}, {step_bounds.unit: 0}),
}  # fmt: skip


@pytest.mark.parametrize("name", BOUNDED)
def test_a_bound_is_the_theorems(name):
    claim, ours, given, change = BOUNDED[name]
    upper, lower = (relation.lhs.xreplace(given) for relation in claim.shows[-2:])
    assert simplify((upper + lower) / 2 - ours) == 0
    assert simplify((upper + lower) / 2 - ours.xreplace(change)) != 0


def test_the_caps_are_the_steepest_slope_once_and_twice():
    slope = step_bounds.slope_bound.expand(step_bounds.steepest)
    assert slope == pi * step_bounds.frequency
    assert step_bounds.crease_bound.expand(step_bounds.apart) == 2 * slope


@pytest.mark.parametrize("field", BOUNDS)
def test_heights_are_as_good_as_the_plot_assumes(field):
    u, v = np.random.default_rng(7).random((2, 2000))
    k_u, k_v = np.random.default_rng(8).uniform(-64, 64, (2, 2000))
    at, of_field = {"u": u, "v": v, "k_u": k_u, "k_v": k_v}, height(HEIGHT_FIELDS[field])
    off = distance(in_float64(of_field, at)["h"], in_balls(of_field, at)["h"])
    assert 0 < off.max() <= HEIGHT_ERROR


def test_a_moved_argument_is_off_by_no_more_than_the_plot_assumes():
    rng = np.random.default_rng(7)
    at_u, eps = rng.random(5000), 10.0 ** rng.uniform(-16, -1, 5000) * rng.choice([-1, 1], 5000)
    exact = [Fraction(a) + Fraction(b) for a, b in zip(at_u, eps, strict=True)]
    worst = max(abs(Fraction(moved) - there) for moved, there in zip(at_u + eps, exact, strict=True))
    assert 0.4 * ARGUMENT_ERROR < worst <= ARGUMENT_ERROR
    assert UNIT == 2.0**-53


def test_only_what_the_theorems_cover_has_a_bound():
    """A slanted wave, a square, two of one frequency, twice a wave, creases where a cosine is zero: no bound."""
    assert bounds_of(SLANTED) is None
    waves = sinpi(k_u * u) ** 2, sinpi(k_u * u) * cospi(k_u * u), 2 * sinpi(k_u * u), Abs(cospi(k_u * u))
    for expression in waves:
        assert not is_covered(replace(SINE, expression=expression))
    assert is_covered(replace(SINE, expression=sinpi(2 * k_u * u)))
    assert is_covered(replace(SINE, expression=sinpi(k_u * u) * cospi(k_v * v)))


def drawn(count):
    """Return random u, v, k_u, k_v and ε: everywhere, by creases, by the seam and by the pole."""
    rng = np.random.default_rng(11)
    eps, waves = 10.0 ** rng.uniform(-15, -1, count), rng.integers(-16, 17, (2, count)).astype(float)
    near = 10.0 ** rng.uniform(-9, -1, (2, count)) * rng.choice([-1, 1], (2, count))
    places = rng.random((2, count))
    creased = (np.rint(places * waves) + near) / np.where(waves == 0, 1, waves)
    places = np.where(rng.random((2, count)) < 0.5, places, creased)
    return places[0] % 1.0, np.abs(places[1]) % 0.9, *waves, eps


@pytest.mark.parametrize("field", BOUNDS)
@np.errstate(all="ignore")
def test_no_difference_is_further_off_than_its_bound(field):
    u, v, ku, kv, eps = drawn(4000)
    ours, true = difference(FIELDS[field], "central", u, v, ku, kv, eps), EXACT[field](u, v, ku, kv)
    error = np.maximum(*(abs(one - other) for one, other in zip(ours, true, strict=True)))
    bound, leading, *terms = BOUNDS[field](u, v, ku, kv, eps)
    terms = np.array(np.broadcast_arrays(*terms, u)[: len(TERMS)])
    np.testing.assert_allclose(bound, terms.sum(axis=0))
    np.testing.assert_array_equal(terms[leading.astype(int) - 1, np.arange(len(u))], terms.max(axis=0))
    assert (error <= bound).all()
    assert (error > bound - terms.max(axis=0)).any()  # without its largest term it is no bound


@np.errstate(all="ignore")
def test_the_creases_are_where_the_factors_are_zero():
    """Meridians, a parallel and slanted waves: on the image, and back on the chart, the factor is zero there."""
    for field, ku, kv in ((RIDGES, 8.0, 4.0), (SLANTED, 7.0, 3.0)):
        rates = np.reshape(crease_rates(field)(ku, kv), (-1, 3))
        assert len(rates) == len(field.creases)
        for a, b, offset in rates:
            x, y = crease_point(a, b, np.float64(1.0), np.linspace(0.01, 1, 97), 4.0, 1.0)
            seen = ~np.isnan(x)
            at_u, at_v = chart(*angles_on_a(x[seen], y[seen], 4.0, 1.0))
            turns = a * at_u + b * at_v + offset
            assert seen.any() and np.abs(turns - np.rint(turns)).max() < 1e-12
            assert np.abs(a * at_v + b * at_u).max() > 0.1  # u and v the wrong way round are seen
    hidden, _ = crease_point(np.float64(0.0), np.float64(4.0), np.float64(2.0), np.linspace(0, 1, 9), 4.0, 1.0)
    assert np.isnan(hidden).all()  # v = 1/2 is below the horizon


def test_a_difference_straddles_circles_and_not_the_pole():
    """At v < ε the difference is clamped at the pole, where |sin πk_v v| ends; at v = 1/k_v it crosses the crease."""
    straddling = FIELDS["ridges"]["straddling"]
    at_v = np.array([1e-9, 1e-4, 0.009, 0.2499, 0.2501, 0.26])
    flags = straddling(np.full(6, 0.05), at_v, 8.0, 4.0, 1e-3)
    np.testing.assert_array_equal(flags, [0, 0, 0, 1, 1, 0])
    assert straddling(np.float64(0.05), np.float64(0.03), 8.0, 16.0, 0.05) == 1  # the first circle, past the pole
