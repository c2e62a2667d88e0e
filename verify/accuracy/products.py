"""Floats beside the creases u = m/k, and how many of them a rounded product k·u puts on one: every one is looked at."""

from fractions import Fraction
from functools import cache

import numpy as np

from renderer import Scene, height_at
from renderer.kernels import two_product

MOST = 64
COUNTED = (1824, 1756, 0)
RATIONALS = [(k, m) for k in range(2, MOST + 1) for m in range(1, k)]


@cache
def found() -> tuple[int, int, int]:
    """Return counts of the floats u nearest to an m/k, and not equal to it: all, those with k·u rounded to m, creases.

    k·u is an exact fraction, rounded once; the kernel that draws decides where a crease is.
    """
    floats = [(k, m, u) for k, m in RATIONALS if (u := Fraction(float(Fraction(m, k)))) * k != m]
    onto = sum(float(k * u) == m for k, m, u in floats)
    return len(floats), onto, sum(bool(height_at(Scene(ku=float(k)), float(u), 0.125) == 0) for k, _, u in floats)


def off(*claimed: int) -> list[tuple[int, int, int]]:
    """Return a piece for each count: how far it is from what is claimed."""
    return [(n, n + 1, abs(count - of)) for n, (count, of) in enumerate(zip(found(), claimed, strict=True))]


def off_by_floats(counts: np.ndarray) -> np.ndarray:
    """Return how far counts by float64's own operations are from COUNTED; a product by two floats is exact."""
    k, m = np.transpose(RATIONALS).astype(float)
    product, error = two_product(k, m / k)
    onto, rounded = product == m, error != 0
    beside = ~onto | rounded
    sizes = np.sum([beside, onto & rounded, beside & ~rounded & (product % 1 == 0)], axis=1)
    return np.abs(sizes - COUNTED)[counts.astype(int)]
