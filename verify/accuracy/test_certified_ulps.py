"""Our own elementary functions for float64, against balls: no error is above the certified one.

The certificate itself is run with the theorems: `elementary_functions`. Dense random arguments, and adversarial ones:
on and beside the zeros, the quadrants' and the nodes' edges, tiny, large.
A product k·u costs one more rounding, of the reduced argument; the arctangent, the division before its series.
"""

import math
from functools import partial

import numpy as np
import pytest
from flint import arb
from numpy.testing import assert_array_equal
from sympy import Rational

from proofs.formulas import exponential
from proofs.formulas.certified import CERTIFIED
from renderer import kernels
from verify.accuracy.certified_ulps import SMALL, error_in_ulps, errors_in_ulps


def beside(values, count=3):
    """Return float64 numbers and their neighbours on either side; below a power of two these are half as far away."""
    return np.concatenate([values + half * np.spacing(values) / 2 for half in range(-2 * count, 2 * count + 1)])


RANDOM = np.random.default_rng(5)


def arguments():
    spread = RANDOM.uniform(-2, 2, 3000), RANDOM.uniform(-(2**20), 2**20, 1000), 10.0 ** -np.arange(1.0, 100)
    return (np.concatenate([*spread, beside(np.arange(-16, 17) / 8)]),)


def products():
    k = RANDOM.integers(1, 65, 800).astype(float)
    creases = beside(np.floor((k + 1) * RANDOM.random(800)) / k)
    waves = RANDOM.uniform(-64, 64, 3000), RANDOM.uniform(0, 2.0**20, 500), np.resize(k, creases.size)
    return np.concatenate(waves), np.concatenate([RANDOM.random(3500), creases])


def test_a_constant_of_few_binary_places_has_no_rest():
    assert exponential._in_two(Rational(3, 2)) == (Rational(3, 2), 0)


def directions():
    nodes = beside(np.array([5 / 16, 0.5, 0.75, 1.0])), 10.0 ** -np.arange(1.0, 280, 9)
    ratios = np.concatenate([RANDOM.random(2000), *nodes])
    ones = np.ones_like(ratios)
    octants = [(s * y, t * x) for y, x in ((ratios, ones), (ones, ratios)) for s in (1, -1) for t in (1, -1)]
    return tuple(map(np.concatenate, zip(*octants, strict=True)))


def logarithms():
    (numbers,) = np.abs(arguments())
    numbers = numbers[numbers > 1e-100]
    return (np.concatenate([numbers, numbers**-3]),)


def powers(smallest):
    """Return bases and exponents, of which the power's logarithm is not below −smallest."""
    exponents = 10.0 ** RANDOM.uniform(-3, 6, 5000)
    return np.exp(-RANDOM.uniform(0, smallest, 5000) / exponents), exponents


CASES = dict.fromkeys(CERTIFIED, arguments) | {
    "sinpi_of_product": products,
    "cospi_of_product": products,
    "atan2pi": directions,
    "exp": lambda: tuple(350 * x[np.abs(x) <= 2] for x in arguments()),
    "log": logarithms,
    "power": partial(powers, SMALL),
    "small_power": partial(powers, 708),
}


@pytest.mark.parametrize("name", CERTIFIED)
def test_error_in_ulps(name):
    assert errors_in_ulps(name, *CASES[name]()).max() <= CERTIFIED[name]


def test_the_measure_sees_an_error():
    """One ulp added is one ulp measured, and a missed zero is infinite."""
    assert error_in_ulps(math.nextafter(0.75, 1), arb(0.75)) == 1
    assert error_in_ulps(1e-300, arb(0)) == math.inf


@np.errstate(all="ignore")
def test_what_they_are_at_the_ends_of_their_range_and_outside():
    numbers = np.array([np.nan, np.inf, -np.inf, 709.1, -708.1, -0.0])
    assert_array_equal(kernels.exp(numbers), [np.nan, np.inf, 0, np.inf, 0, 1])
    assert_array_equal(kernels.log(numbers[[0, 1, 4, 5]]), [np.nan, np.inf, np.nan, -np.inf])
    for exponent in (5e-4, 0.1, 0.5, 1.0, 7.3, 1e6):
        assert_array_equal(kernels.power(np.array([0, 1, np.nan]), exponent), [0, 1, np.nan])
