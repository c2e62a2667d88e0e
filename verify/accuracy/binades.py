"""Steps too small for float64 to take: both u + ε and u − ε round back to u, and every height has slope 0."""

import numpy as np
from numpy.typing import ArrayLike


def dies(at: ArrayLike, epsilon: ArrayLike, within: float = 0.5, at_power: float = 0.25) -> np.ndarray:
    """Return whether the step is lost at each float64 number, by theorem binades: never at 0, the pole and the seam.

    within: below how many spacings it is; at_power: up to how many where the number is a power of two.
    """
    at, epsilon = np.asarray(at, float), np.asarray(epsilon)
    s, power = np.spacing(np.where(at > 0, at, 1.0)), np.frexp(at)[0] == 0.5
    return (at > 0) & np.where(power, epsilon <= at_power * s, epsilon < within * s)
