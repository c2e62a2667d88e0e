"""Our own elementary functions for float64, against balls: no error is above the certified one.

The certificate itself is run with the theorems: `elementary_functions`. Dense random arguments, and adversarial ones:
on and beside the zeros, the quadrants' and the nodes' edges, tiny, large.
A product k·u costs one more rounding, of the reduced argument; the arctangent, the division before its series.
"""

import math
import random
import sys
from fractions import Fraction
from functools import partial

import numpy as np
import pytest
from flint import arb

from renderer import kernels
from verify.accuracy.certified_ulps import CERTIFIED, KERNELS, PIECES, SMALL, at, error_in_ulps, errors_in_ulps


def beside(value, count):
    """Return `value` and its `count` neighbours on either side."""
    found, above, below = [value], value, value
    for _ in range(count):
        above, below = math.nextafter(above, math.inf), math.nextafter(below, -math.inf)
        found += [above, below]
    return found


def arguments():
    rng = random.Random("arguments")
    found = [rng.uniform(-2, 2) for _ in range(3000)] + [rng.uniform(-(2**20), 2**20) for _ in range(1000)]
    found += [x for m in range(-16, 17) for x in beside(m / 8, 3)]
    return [(x,) for x in found + [10.0**-k for k in range(1, 100)]]


def products():
    rng = random.Random("products")
    found = [(rng.uniform(-64, 64), rng.random()) for _ in range(3000)]
    found += [(2.0**20 * rng.random(), rng.random()) for _ in range(500)]
    return found + [(float(k), u) for k in range(1, 65, 3) for m in range(k + 1) for u in beside(m / k, 1)]


def directions():
    rng = random.Random("directions")
    found = []
    for _ in range(3000):
        angle, length = rng.uniform(-math.pi, math.pi), 10.0 ** rng.uniform(-5, 5)
        found.append((length * math.sin(angle), length * math.cos(angle)))
    for edge in (5 / 16, 0.5, 0.75, 1.0):
        found += [p for y in beside(edge, 4) for p in ((y, 1.0), (1.0, y), (-y, 1.0), (y, -1.0), (-y, -1.0))]
    return found + [(s * 10.0**-k, c) for k in range(1, 280, 9) for s in (1, -1) for c in (1.0, -1.0)]


def exponents():
    rng = random.Random("exponents")
    found = [rng.uniform(-708, 709) for _ in range(3000)] + [x for n in range(-9, 10) for x in beside(n / 16, 3)]
    found += [x for n in range(-1021, 1023, 7) for x in beside((n + 0.5) * math.log(2), 1)]
    return [(x,) for x in [*found, -708.0, 709.0, 5e-324]]


def positive_numbers():
    rng = random.Random("positive numbers")
    found = [rng.uniform(0.5, 2) for _ in range(2000)] + [2 ** rng.uniform(-1074, 1024) for _ in range(2000)]
    found += [s * x for x in (1, 9 / 8, 57 / 64, 203 / 256, 323 / 256, 2**0.5) for x in beside(x, 3) for s in (0.5, 1)]
    return [
        (x,) for x in [*found, *(1 + s * 2.0**-n for n in range(1, 53) for s in (1, -1)), 5e-324, sys.float_info.max]
    ]


def bases_and_exponents(smallest):
    rng, found = random.Random("powers"), []
    while len(found) < 4000:
        base = rng.choice((rng.random(), 1 - 2.0 ** rng.uniform(-40, 0), 2.0 ** rng.uniform(-1074, 0)))
        exponent = rng.uniform(0, smallest) / -math.log(base) if base else 0
        found += [(base, exponent)] if 1e-3 <= exponent <= 1e6 else []
    return found


CASES = dict.fromkeys(CERTIFIED, arguments) | {
    "sinpi_of_product": products,
    "cospi_of_product": products,
    "atan2pi": directions,
    "exp": exponents,
    "log": positive_numbers,
    "power": partial(bases_and_exponents, SMALL),
    "small_power": partial(bases_and_exponents, 707),
}


@pytest.mark.parametrize("name", CERTIFIED)
def test_error_in_ulps(name):
    cases = CASES[name]()
    errors = errors_in_ulps(name, *np.array(cases).T)
    assert errors.max() <= CERTIFIED[name], f"{name}{cases[errors.argmax()]} is off by {errors.max()} ulp"


@pytest.mark.parametrize("name", ["sinpi", "cospi", "atan2pi", "exp", "log"])
def test_no_piece_is_certified_too_low(name):
    """On each piece of the range the kernel's error stays below that piece's own bound, and on some comes near it."""
    rng, pieces = np.random.default_rng(3), PIECES[name]()
    low, high, ulps = (np.array([float(getattr(p, end)) for p in pieces]) for end in ("low", "high", "ulps"))
    x = np.clip(rng.uniform(low, high, (2, len(pieces))), np.nextafter(low, np.inf), np.nextafter(high, -np.inf))
    shares = errors_in_ulps(name, *at(name, x, rng.uniform(1, 2, x.shape))) / ulps
    assert 0.5 < shares.max() <= 1


def test_the_measure_sees_an_error():
    """One ulp added is one ulp measured, and a missed zero is infinite."""
    assert error_in_ulps(math.nextafter(0.75, 1), arb(0.75)) == 1
    assert error_in_ulps(1e-300, arb(0)) == math.inf


def test_zeros_are_exact():
    """sin πku is zero on every crease that float64 holds, and on none of its neighbours (F9)."""
    product = KERNELS["sinpi_of_product"]
    for k in range(1, 65):
        for m in range(k):
            for u in beside(m / k, 1)[: 3 if m else 1]:
                exactly_on_crease = (k * Fraction(u)).denominator == 1
                assert (product(float(k), np.float64(u)) == 0) == exactly_on_crease


def test_what_exp_and_log_are_outside_their_range():
    nan, inf = math.nan, math.inf
    numbers = np.array([nan, inf, -inf, 709.0, 709.1, -708.0, -708.1, 0.0, -0.0, -1e-300])
    with np.errstate(all="ignore"):
        exponentials, logarithms = kernels.exp(numbers), kernels.log(numbers)
    np.testing.assert_array_equal(exponentials[[0, 1, 2, 4, 6, 7, 8]], [nan, inf, 0, inf, 0, 1, 1])
    assert 8.2e307 < exponentials[3] < inf and 3e-308 < exponentials[5] < 4e-308
    np.testing.assert_array_equal(logarithms[[0, 1, 2, 7, 8, 9]], [nan, inf, nan, -inf, -inf, nan])


@pytest.mark.parametrize("exponent", [1e-3, 0.1, 0.5, 1.0, 7.3, 999.5, 1e6])
def test_a_power_rises_from_0_to_1(exponent):
    """From one base to the next above it; for an exponent of 0.1 and less it may fall, by a unit in the last place."""
    rng, edges = np.random.default_rng(5), [0, 5e-324, 203 / 256, 57 / 64, 0.5**0.5, 0.5, 1]
    bases = np.concatenate([rng.random(5000), 1 - 2.0 ** rng.uniform(-53, 0, 5000), 2.0 ** rng.uniform(-1074, 0, 5000)])
    bases = np.unique([*bases, *np.nextafter(bases, 1), *(x for edge in edges for x in beside(edge, 9) if 0 <= x <= 1)])
    with np.errstate(all="ignore"):
        powers = kernels.power(bases, exponent)
    assert (powers[0], powers[-1]) == (0, 1) and powers.min() == 0 and powers.max() == 1
    assert (np.diff(powers) >= (-np.spacing(powers[:-1]) if exponent <= 0.1 else 0)).all()
    assert np.isnan(kernels.power(math.nan, exponent))
