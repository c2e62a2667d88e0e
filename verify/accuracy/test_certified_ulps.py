"""Our own sinpi, cospi and atan2pi for float64, against 50 digits: no error is above the certified one.

The certificate itself is run with the theorems: `elementary_functions`. Dense random arguments, and adversarial ones:
on and beside the zeros, the quadrants' and the nodes' edges, tiny, large.
A product k·u costs one more rounding, of the reduced argument; the arctangent, the division before its series.
"""

import math
import random
from fractions import Fraction

import mpmath
import numpy as np
import pytest

from verify.accuracy.certified_ulps import CERTIFIED, KERNELS, pieces_of

EXACT = {"sin": mpmath.sinpi, "cos": mpmath.cospi}


def beside(value, count):
    """Return `value` and its `count` neighbours on either side."""
    found, above, below = [value], value, value
    for _ in range(count):
        above, below = math.nextafter(above, math.inf), math.nextafter(below, -math.inf)
        found += [above, below]
    return found


def error_in_ulps(computed, exact):
    """Return |computed − exact| in units in the last place of exact; infinite for a missed zero."""
    if exact == 0:
        return 0.0 if computed == 0 else math.inf
    return float(abs(mpmath.mpf(float(computed)) - exact) / math.ulp(float(exact)))


def arguments():
    rng = random.Random("arguments")
    found = [rng.uniform(-2, 2) for _ in range(3000)] + [rng.uniform(-(2**20), 2**20) for _ in range(1000)]
    found += [x for m in range(-16, 17) for x in beside(m / 8, 3)]
    return found + [10.0**-k for k in range(1, 100)]


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


def worst(name):
    """Return (the largest error of a kernel function in ulps, where)."""
    with mpmath.workdps(50):
        if name == "atan2pi":
            cases = [((y, x), mpmath.atan2(mpmath.mpf(y), mpmath.mpf(x)) / mpmath.pi) for y, x in directions()]
        elif name.endswith("_of_product"):
            cases = [((k, u), EXACT[name[:3]](mpmath.mpf(k) * mpmath.mpf(u))) for k, u in products()]
        else:
            cases = [((x,), EXACT[name[:3]](mpmath.mpf(x))) for x in arguments()]
        values = KERNELS[name](*np.array([case for case, _ in cases]).T)
        return max((error_in_ulps(v, exact), case) for v, (case, exact) in zip(values, cases, strict=True))


@pytest.mark.parametrize("name", CERTIFIED)
def test_error_in_ulps(name, record_property):
    error, where = worst(name)
    record_property("ulps", f"{error:.3f}")
    assert error <= CERTIFIED[name], f"{name}{where} is off by {error} ulp"


@pytest.mark.parametrize("name", ["sinpi", "cospi", "atan2pi"])
def test_no_piece_is_certified_too_low(name):
    """On each piece of the range the kernel's error stays below that piece's own bound, and on some comes near it."""
    rng, nearest = random.Random(name), 0
    with mpmath.workdps(50):
        for piece in pieces_of(name):
            for _ in range(2):
                x = rng.uniform(float(piece.low), float(piece.high))
                x = min(max(x, math.nextafter(float(piece.low), 1)), math.nextafter(float(piece.high), 0))
                if name == "atan2pi":
                    larger = rng.uniform(1, 2)
                    case, exact = (x * larger, larger), mpmath.atan2(x * larger, larger) / mpmath.pi
                else:
                    case, exact = (x,), EXACT[name[:3]](mpmath.mpf(x))
                seen = error_in_ulps(KERNELS[name](*map(np.float64, case)), exact) / float(piece.ulps)
                assert seen <= 1, f"{name}{case}"
                nearest = max(nearest, seen)
    assert nearest > 0.5


def test_the_measure_sees_an_error():
    """One ulp added is one ulp measured, and a missed zero is infinite."""
    assert error_in_ulps(math.nextafter(0.75, 1), mpmath.mpf(0.75)) == 1
    assert error_in_ulps(1e-300, mpmath.mpf(0)) == math.inf


def test_zeros_are_exact():
    """sin πku is zero on every crease that float64 holds, and on none of its neighbours (F9)."""
    product = KERNELS["sinpi_of_product"]
    for k in range(1, 65):
        for m in range(k):
            for u in beside(m / k, 1)[: 3 if m else 1]:
                exactly_on_crease = (k * Fraction(u)).denominator == 1
                assert (product(float(k), np.float64(u)) == 0) == exactly_on_crease
