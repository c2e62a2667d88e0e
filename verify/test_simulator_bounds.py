"""What bounds a central difference's error, on the pages and in the simulator: it holds everywhere, and is sharp."""

from dataclasses import replace

import numpy as np
import pytest
from sympy import Abs

from proofs.formulas.finite_difference import central
from proofs.formulas.half_turns import cospi, sinpi
from proofs.formulas.height_fields import HEIGHT_FIELDS, HeightField, gradient
from proofs.formulas.step_bounds import TERMS
from proofs.formulas.symbols import k_u, k_v, u, v
from renderer.generate.creases import crease_point, crease_rates
from renderer.generate.kernels import function_of
from renderer.generate.step_terms import BOUNDS, ROOM, SLOPE_TERMS, factors_of, half_unit, slope_terms, truncation_bound
from renderer.kernels import FIELDS, angles_on_a, chart
from verify.accuracy.differences import SLOPES, Case, bounds

SINE, RIDGES = HEIGHT_FIELDS["sine"], HEIGHT_FIELDS["ridges"]
SLANTED = HeightField("slanted", Abs(sinpi(k_u * u + k_v * v)))
COSINES = HeightField("cosines", cospi(k_u * u) * cospi(k_v * v))
FOLDED = HeightField("folded", Abs(COSINES.expression))
COVERED = {field.name: field for field in (*(HEIGHT_FIELDS[name] for name in BOUNDS), COSINES, FOLDED)}


def test_only_what_the_theorems_cover_has_a_bound():
    """A slanted wave, a square, another amplitude or frequency, a sine of a cosine's angle: none."""
    assert {SINE.name, RIDGES.name} < BOUNDS.keys()
    assert slope_terms(SLANTED) is None
    sine = sinpi(k_u * u)
    for expression in (sine**2, sinpi(3 * k_u * u / 2) * sine, sine * cospi(k_u * u), 2 * sine, sine + sinpi(k_v * v)):
        assert factors_of(replace(SINE, expression=expression)) is None
    assert factors_of(replace(SINE, expression=sine * cospi(k_v * v))) == (sine, cospi(k_v * v))


def test_the_page_and_the_simulator_show_one_number():
    """The point at which they once showed two, apart by a factor of 21.6."""
    step = 1e-9
    shown = BOUNDS["sine"](0.31, 0.47, 8.0, 4.0, step)
    page = [bounds(Case("", "sine", 8.0, 4.0, 0.31, 0.47, slope), [step])["total"][0] for slope in SLOPES]
    assert [*shown[2:]] == pytest.approx(page, rel=1e-15) and shown[0] == max(shown[2:])
    assert page[0] == pytest.approx(1.6e-7, rel=1e-2)


def drawn(count):
    """Return random u, v, k_u, k_v and ε: everywhere, beside zeros, the seam and poles; whole waves and others."""
    rng = np.random.default_rng(11)
    eps, waves = 10.0 ** rng.uniform(-18, np.log10(0.5), count), rng.integers(-16, 17, (2, count)).astype(float)
    waves += rng.choice([0.0, 0.5, 0.3], count)
    near = 10.0 ** rng.uniform(-9, -1, (2, count)) * rng.choice([-1, 1], (2, count))
    places, halves = rng.random((2, count)), rng.choice([0.0, 0.5], (2, count))
    zeros = (np.rint(places * waves) + halves + near) / np.where(waves == 0, 1, waves)
    places = np.where(rng.random((2, count)) < 0.5, places, zeros)
    return places[0] % 1.0, np.clip(np.abs(places[1]), 0, 1), *waves, eps


@pytest.mark.parametrize("name", COVERED)
@np.errstate(all="ignore")
def test_no_difference_is_further_off_than_its_bound(name):
    field, at = COVERED[name], drawn(20_000)
    ours, true = function_of(central(field))(*at), function_of(gradient(field))(*at[:-1])
    errors = np.abs(np.broadcast_arrays(*ours, at[0])[:2] - np.array(np.broadcast_arrays(*true, at[0])[:2]))
    terms = np.array([np.broadcast_arrays(*slope, at[0])[:-1] for slope in slope_terms(field)(*at)])
    assert (errors <= terms.sum(axis=1)).all()
    assert (errors > terms.sum(axis=1) - terms.max(axis=1)).any()  # without its largest term it is no bound
    leading = {TERMS[number] for number in np.unique(terms.argmax(axis=1))}
    assert leading == {*TERMS} - ({"straddling"} if factors_of(field)[0] is None else set())  # rings has no seam


@pytest.mark.parametrize("name", BOUNDS)
@np.errstate(all="ignore")
def test_where_both_arguments_round_back_the_bound_is_the_slope(name):
    """The difference is 0 there, and its error the slope itself: the bound is no more than a rounding above it."""
    rng = np.random.default_rng(5)
    at = *rng.uniform(0.1, 0.9, (2, 1000)), 8.0, 4.0
    for eps in (1e-18, 5e-18):
        assert not np.any(function_of(central(HEIGHT_FIELDS[name]))(*at, eps))
        for slope, bound in zip(
            function_of(gradient(HEIGHT_FIELDS[name]))(*at), BOUNDS[name](*at, eps)[2:], strict=True
        ):
            assert np.all(np.abs(slope) <= bound) and np.all(bound <= np.abs(slope) * ROOM**2 + 1e-12)


@np.errstate(all="ignore")
def test_a_hump_of_ridges_that_ends_inside_the_step_has_no_smooth_bound():
    """At v = 0.0045 the first one does, at v = 1/256; with the sample at the pole, and without. At v = 0 it begins."""
    rng, many = np.random.default_rng(3), 20_000
    at_v = np.concatenate([rng.uniform(0, 0.01, many), [0.0, 0.0045]])
    eps = np.concatenate([rng.uniform(1e-4, 2e-2, many), [9e-4, 9e-4]])
    at = 0.798, at_v, 512.0, 256.0
    errors = np.abs(function_of(central(RIDGES))(*at, eps)[1] - function_of(gradient(RIDGES))(*at)[1])
    terms = np.array(SLOPE_TERMS["ridges"](*at, eps)[1])
    ends = (at_v < 1 / 256) & (at_v + eps > 1 / 256)
    assert (errors <= terms.sum(axis=0)).all()
    assert (errors[ends] > truncation_bound(eps, 256.0)[ends]).any() and not terms[0][ends].any()
    assert (errors[-2:] > 4 * truncation_bound(9e-4, 256.0)).all()
    assert [TERMS[number] for number in terms[:, -2:].argmax(axis=0)] == ["one-sided", "straddling"]


@np.errstate(all="ignore")
def test_the_simulators_bound_is_the_larger_slopes():
    at = drawn(1000)
    bound, leading, *slopes = BOUNDS["ridges"](*at)
    terms = np.array([np.broadcast_arrays(*slope, at[0])[:-1] for slope in SLOPE_TERMS["ridges"](*at)])
    np.testing.assert_allclose(slopes, terms.sum(axis=1))
    larger = terms[np.argmax(slopes, axis=0), :, np.arange(1000)]
    np.testing.assert_array_equal(leading, np.where(larger.any(axis=1), larger.argmax(axis=1) + 1, 0))
    np.testing.assert_array_equal(bound, np.max(slopes, axis=0))


def test_the_truncation_bound_is_attained():
    """Where the slope is steepest, the error of a small step is the bound, up to the next term of its series."""
    for k in (1.0, 8.0, 64.0):
        step = 1e-2 / k
        error = np.pi * k * (1 - np.sinc(k * step))
        assert 0.999 < error / truncation_bound(step, k) < 1


def test_half_a_unit_is_half_of_the_spacing():
    numbers = 10.0 ** np.random.default_rng(7).uniform(-18, 0.3, 5000)
    np.testing.assert_array_equal(half_unit(numbers), np.spacing(numbers) / 2)
    assert 0 < ROOM - 1 < 1e-9


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
