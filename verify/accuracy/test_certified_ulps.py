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

from proofs.formulas.certified import CERTIFIED
from renderer import kernels
from verify.accuracy.certified_ulps import PIECES, SMALL, error_in_ulps, errors_in_ulps
from verify.accuracy.pieces import worst


def beside(values, count):
    """Return float64 numbers and their `count` neighbours on either side."""
    found, above, below = [values], values, values
    for _ in range(count):
        above, below = np.nextafter(above, np.inf), np.nextafter(below, -np.inf)
        found += [above, below]
    return np.concatenate(found)


RANDOM = np.random.default_rng(5)


def arguments():
    spread = RANDOM.uniform(-2, 2, 3000), RANDOM.uniform(-(2**20), 2**20, 1000), 10.0 ** -np.arange(1.0, 100)
    return (np.concatenate([*spread, beside(np.arange(-16, 17) / 8, 3)]),)


def products():
    k, m = (grid.ravel() for grid in np.meshgrid(np.arange(1.0, 65, 3), np.arange(65)))
    creases, large = beside(m[m <= k] / k[m <= k], 1), RANDOM.uniform(0, 2.0**20, 500)
    waves = np.concatenate([RANDOM.uniform(-64, 64, 3000), large, np.tile(k[m <= k], 3)])
    return waves, np.concatenate([RANDOM.random(3500), creases])


def directions():
    angles, lengths = RANDOM.uniform(0, np.pi / 2, 2000), 10.0 ** RANDOM.uniform(-5, 5, 2000)
    small = np.concatenate([beside(np.array([5 / 16, 0.5, 0.75, 1.0]), 4), 10.0 ** -np.arange(1.0, 280, 9)])
    y = np.concatenate([lengths * np.sin(angles), small, np.ones_like(small)])
    x = np.concatenate([lengths * np.cos(angles), np.ones_like(small), small])
    return np.concatenate([y, y, -y, -y]), np.concatenate([x, -x, x, -x])


def logarithms():
    (numbers,) = np.abs(arguments())
    numbers = numbers[numbers > 1e-100]
    return (np.concatenate([numbers, numbers**-3]),)


def powers(smallest):
    """Return bases and exponents, of which the power's logarithm is not below −smallest."""
    exponents, bases = np.abs(products())
    with np.errstate(all="ignore"):
        within = (bases > 0) & (bases <= 1) & (exponents > 0) & (-exponents * np.log(bases) < smallest)
    return bases[within], exponents[within]


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
    cases = CASES[name]()
    errors = errors_in_ulps(name, *cases)
    where = [argument[errors.argmax()] for argument in cases]
    assert errors.max() <= CERTIFIED[name], f"{name}{where} is off by {errors.max()} ulp"


@pytest.mark.parametrize("name", CERTIFIED)
def test_what_is_stated_is_what_is_certified_to_a_hundredth(name):
    certified = float(worst(PIECES[name]()))
    assert certified <= CERTIFIED[name] < certified + 0.01


def test_the_measure_sees_an_error():
    """One ulp added is one ulp measured, and a missed zero is infinite."""
    assert error_in_ulps(math.nextafter(0.75, 1), arb(0.75)) == 1
    assert error_in_ulps(1e-300, arb(0)) == math.inf


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
