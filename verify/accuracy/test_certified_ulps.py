"""Our own sinpi, cospi and atan2pi for float64, against balls: no error is above the certified one.

The certificate itself is run with the theorems: `elementary_functions`. Dense random arguments, and adversarial ones:
on and beside the zeros, the quadrants' and the nodes' edges, tiny, large.
A product k·u costs one more rounding, of the reduced argument; the arctangent, the division before its series.
"""

import math
import random
from fractions import Fraction

import numpy as np
import pytest
from flint import arb

from proofs.formulas.certified import CERTIFIED
from verify.accuracy.certified_ulps import KERNELS, error_in_ulps, errors_in_ulps, pieces_of


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


def cases_of(name):
    """Return the arguments of a function, tuples."""
    return directions() if name == "atan2pi" else products() if name.endswith("product") else arguments()


@pytest.mark.parametrize("name", CERTIFIED)
def test_error_in_ulps(name):
    cases = cases_of(name)
    errors = errors_in_ulps(name, *np.array(cases).T)
    assert errors.max() <= CERTIFIED[name], f"{name}{cases[errors.argmax()]} is off by {errors.max()} ulp"


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


def test_zeros_are_exact():
    """sin πku is zero on every crease that float64 holds, and on none of its neighbours (F9)."""
    product = KERNELS["sinpi_of_product"]
    for k in range(1, 65):
        for m in range(k):
            for u in beside(m / k, 1)[: 3 if m else 1]:
                exactly_on_crease = (k * Fraction(u)).denominator == 1
                assert (product(float(k), np.float64(u)) == 0) == exactly_on_crease
