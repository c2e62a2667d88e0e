"""Our own elementary functions for float64, against balls: no error is above the certified one.

The certificate itself is run with the theorems: `elementary_functions`. Dense random arguments, and adversarial ones:
on and beside the zeros, the quadrants' and the nodes' edges, tiny, large.
A product k·u costs one more rounding, of the reduced argument; the arctangent, the division before its series.
"""

import math
import random
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


def powers(smallest):
    """Return bases and exponents, of which the power's logarithm is not below −smallest."""
    return [(u, abs(k)) for k, u in products() if 0 < u <= 1 and k and -abs(k) * math.log(u) < smallest]


CASES = dict.fromkeys(CERTIFIED, arguments) | {
    "sinpi_of_product": products,
    "cospi_of_product": products,
    "atan2pi": directions,
    "exp": lambda: [(350 * x,) for (x,) in arguments() if abs(x) <= 2],
    "log": lambda: [(abs(x) ** n,) for (x,) in arguments() if abs(x) > 1e-100 for n in (1, -3)],
    "power": partial(powers, SMALL),
    "small_power": partial(powers, 708),
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
    numbers = np.array([np.nan, np.inf, -np.inf, 709.1, -708.1, -0.0, -1e-300])
    with np.errstate(all="ignore"):
        np.testing.assert_array_equal(kernels.exp(numbers), [np.nan, np.inf, 0, np.inf, 0, 1, 1])
        np.testing.assert_array_equal(kernels.log(numbers)[[0, 1, 2, 5, 6]], [np.nan, np.inf, np.nan, -np.inf, np.nan])


@pytest.mark.parametrize("exponent", [5e-4, 0.1, 0.5, 1.0, 7.3, 1e6])
def test_a_power_rises_from_0_to_1(exponent):
    """From one base to the next above it; for an exponent of 0.1 and less it may fall, by a unit in the last place."""
    rng = np.random.default_rng(5)
    bases = np.concatenate([rng.random(9999), 1 - 2.0 ** rng.uniform(-53, 0, 9999), [0, 203 / 256, 57 / 64, 0.5**0.5]])
    with np.errstate(all="ignore"):
        powers = kernels.power(np.unique([*bases, *np.nextafter(bases, 1), 1]), exponent)
        assert np.isnan(kernels.power(math.nan, exponent))
    assert (powers[0], powers[-1], powers.min(), powers.max()) == (0, 1, 0, 1)
    assert (np.diff(powers) >= (-np.spacing(powers[:-1]) if exponent <= 0.1 else 0)).all()
