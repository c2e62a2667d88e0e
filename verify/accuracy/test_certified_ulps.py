"""Our own sinpi, cospi and atan2pi for float64, against balls: no error is above the certified one.

The certificate itself is run with the theorems: `elementary_functions`. Dense random arguments, and adversarial ones:
on and beside the zeros, the quadrants' and the nodes' edges, tiny, large.
A product k·u costs one more rounding, of the reduced argument; the arctangent, the division before its series.
"""

import math

import numpy as np
import pytest
from flint import arb

from proofs.formulas.certified import CERTIFIED
from verify.accuracy.certified_ulps import error_in_ulps, errors_in_ulps, pieces_of, worst


def beside(values, count):
    """Return float64 numbers and their `count` neighbours on either side."""
    found, above, below = [values], values, values
    for _ in range(count):
        above, below = np.nextafter(above, np.inf), np.nextafter(below, -np.inf)
        found += [above, below]
    return np.concatenate(found)


def cases_of(name):
    """Return the arguments of a function, an array each."""
    rng = np.random.default_rng(5)
    if name == "atan2pi":
        angles, lengths = np.pi * rng.uniform(0, 0.5, 2000), 10.0 ** rng.uniform(-5, 5, 2000)
        small = np.concatenate([beside(np.array([5 / 16, 0.5, 0.75, 1.0]), 4), 10.0 ** -np.arange(1.0, 280, 9)])
        y = np.concatenate([lengths * np.sin(angles), small, np.ones_like(small)])
        x = np.concatenate([lengths * np.cos(angles), np.ones_like(small), small])
        return np.concatenate([y, y, -y, -y]), np.concatenate([x, -x, x, -x])
    if name.endswith("product"):
        k, m = (grid.ravel() for grid in np.meshgrid(np.arange(1.0, 65, 3), np.arange(65)))
        creases, large = beside(m[m <= k] / k[m <= k], 1), rng.uniform(0, 2.0**20, 500)
        waves = np.concatenate([rng.uniform(-64, 64, 3000), large, np.tile(k[m <= k], 3)])
        return waves, np.concatenate([rng.random(3500), creases])
    spread = (rng.uniform(-2, 2, 3000), rng.uniform(-(2**20), 2**20, 1000), 10.0 ** -np.arange(1.0, 100))
    return (np.concatenate([*spread, beside(np.arange(-16, 17) / 8, 3)]),)


@pytest.mark.parametrize("name", CERTIFIED)
def test_error_in_ulps(name):
    cases = cases_of(name)
    errors = errors_in_ulps(name, *cases)
    at = [argument[errors.argmax()] for argument in cases]
    assert errors.max() <= CERTIFIED[name], f"{name}{at} is off by {errors.max()} ulp"


@pytest.mark.parametrize("name", CERTIFIED)
def test_what_is_stated_is_what_is_certified_to_a_hundredth(name):
    certified = float(worst(pieces_of(name)))
    assert certified <= CERTIFIED[name] < certified + 0.01


@pytest.mark.parametrize("name", ["sinpi", "cospi", "atan2pi"])
def test_no_piece_is_certified_too_low(name):
    """On each piece of the range the kernel's error stays below that piece's own bound, and on some comes near it."""
    rng, pieces = np.random.default_rng(3), pieces_of(name)
    low, high, ulps = (np.array([float(getattr(p, end)) for p in pieces]) for end in ("low", "high", "ulps"))
    x = np.clip(rng.uniform(low, high, (2, len(pieces))), np.nextafter(low, 1), np.nextafter(high, 0))
    larger = rng.uniform(1, 2, x.shape)
    shares = errors_in_ulps(name, *((x * larger, larger) if name == "atan2pi" else (x,))) / ulps
    assert 0.5 < shares.max() <= 1


def test_the_measure_sees_an_error():
    """One ulp added is one ulp measured, and a missed zero is infinite."""
    assert error_in_ulps(math.nextafter(0.75, 1), arb(0.75)) == 1
    assert error_in_ulps(1e-300, arb(0)) == math.inf
