"""The difference canvas of the default scene: how dark it is, and how bright at the creases; pieces of enclosures."""

import math
from collections.abc import Sequence
from fractions import Fraction
from functools import cache

import numpy as np
from flint import arb

from renderer import Frame, Scene, central, exact, pixel, render
from renderer.operations import UNIT
from renderer.picture.differences import difference_on_a

SIZE = 256
CREASE_STEP, DARK_STEPS = 1e-3, (1e-8, 1e-9, 1e-10)
HALF_LEVELS = 100 * 510  # half levels of 255 in 1, times the gain 100: a byte is 1 from one of them on
Pieces = list[tuple[int, int, arb | Fraction]]


@cache
def pictures(step: float, bounds: bool = False) -> tuple[Frame, Frame]:
    """Return the difference's picture and the exact one."""
    drawn = render(Scene(), SIZE, SIZE, bounds=bounds)
    return render(Scene(), SIZE, SIZE, central(step), bounds=bounds, stage=drawn.stage), drawn


def crease_contrast(frame: Frame, reference: Frame) -> tuple[float, ...]:
    """Return (mean |difference| where the kink flag is set, elsewhere on A)."""
    delta, kink = np.abs(difference_on_a(frame, reference)), reference.kink[reference.stage.on_a]
    return float(delta[kink].mean()), float(delta[~kink].mean())


def contrast(orders: int) -> Pieces:
    """Return the one piece: how far the contrast is from `orders`, by the bounds of both pictures."""
    difference, drawn = pictures(CREASE_STEP, bounds=True)
    off = (difference.bounds + drawn.bounds)[drawn.stage.on_a].max() + UNIT * SIZE**2
    on, rest = (arb(mean, float(off)) for mean in crease_contrast(difference, drawn))
    return [(0, 1, abs((on / rest).log() / arb(10).log() - orders).upper())]


def contrast_drawn(numbers: np.ndarray) -> np.ndarray:
    """Return how far the contrast of the pictures as drawn is from four, for every number the same."""
    on, rest = crease_contrast(*pictures(CREASE_STEP))
    return np.full(numbers.shape, math.log10(on / rest) - 4)


def darkness(steps: Sequence[float]) -> Pieces:
    """Return a piece for each step: the largest 100 |ΔI| of A's pixels and channels over half a level, exactly."""
    largest = [float(np.abs(difference_on_a(*pictures(step))).max()) for step in steps]
    return [(n, n + 1, HALF_LEVELS * Fraction(most)) for n, most in enumerate(largest)]


def darkness_alone(steps: np.ndarray, pixels: np.ndarray) -> np.ndarray:
    """Return 100 |ΔI| over half a level of some of A's pixels, each drawn alone, at steps of DARK_STEPS."""
    rows, columns = np.nonzero(pictures(CREASE_STEP)[1].stage.on_a)

    def largest(step, place):
        at = Scene(), SIZE, SIZE, int(columns[int(place)]), int(rows[int(place)])
        colours = (pixel(*at, method).rgb for method in (central(DARK_STEPS[int(step)]), exact()))
        return HALF_LEVELS * np.abs(np.subtract(*colours)).max()

    return np.vectorize(largest)(steps, pixels)
