"""Where a step is too small for float64 to take: both u + ε and u − ε round back to u, and every height has slope 0."""

import numpy as np
from numpy.typing import ArrayLike

BITS = 52  # a float64 number from 2^k up to 2^(k+1) is a multiple of 2^(k − BITS)


def spacings(at: np.ndarray) -> np.ndarray:
    """Return the distance s from each float64 number above 0 to the next one of its binade."""
    _, above = np.frexp(at)
    return np.ldexp(1.0, above - 1 - BITS)


def dies(at: ArrayLike, epsilon: ArrayLike, within: float = 0.5, at_power: float = 0.25) -> np.ndarray:
    """Return whether the step is lost at each float64 number, by theorem binades: never at 0, the pole and the seam.

    within: below how many spacings it is; at_power: up to how many where the number is a power of two.
    """
    at, epsilon = np.asarray(at, float), np.asarray(epsilon)
    s, power = spacings(np.where(at > 0, at, 1.0)), np.frexp(at)[0] == 0.5
    return (at > 0) & np.where(power, epsilon <= at_power * s, epsilon < within * s)
