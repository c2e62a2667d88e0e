"""The best step of a central difference and its floor: as the theorem predicts, and as measured; and a trick.

Predicted: theorem best_step, of the bounds of truncation and rounding. Measured: the largest error over smooth points
is least at the best step. The trick takes for ε what u ± ε can represent, (u + ε) − u in float64, so that α = 0.
"""

import math
from typing import NamedTuple

import numpy as np

from proofs.formulas import step_bounds
from proofs.formulas.finite_difference import central
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from renderer.generate.kernels import function_of
from verify.accuracy.step_terms import SINE_ROUNDINGS, UNIT, rounding_bound, slope_bound, truncation_bound
from verify.evaluate.arrays import in_balls, in_float64
from verify.evaluate.programs import naive

POINTS, SEED, PER_DECADE, WINDOW = 16, 3, 20, 5
SINE = HEIGHT_FIELDS["sine"]
_best_step = function_of(step_bounds.best_step)


class Best(NamedTuple):
    """A best step and the error that it leaves."""

    step: float
    floor: float


def best_of(k: float, rounding: float) -> Best:
    """Return the Best of the truncation bound for k and a rounding error of `rounding`/ε: theorem best_step."""
    truncation = truncation_bound(1.0, k)
    for_one, _ = _best_step(truncation, 1.0)  # the rounding whose best step is 1: it goes with the step's cube
    step = (rounding / for_one) ** (1 / 3)
    return Best(step, _best_step(truncation, step)[1])


def predicted(k: float, representable: bool = False) -> Best:
    """Return the Best of the proved bound for sine in u, wherever the point is; representable: with the trick."""
    heights, arguments = SINE_ROUNDINGS * UNIT + UNIT, 0.0 if representable else UNIT
    return best_of(k, rounding_bound(2.0, slope_bound(k), 0.0, heights, arguments))


def errors(k: float, steps: np.ndarray, representable: bool = False, library: bool = False) -> np.ndarray:
    """Return (steps, points) |computed − exact| of h_u, sine, v on a crest; library: with the C library's sine, whose
    argument πku is rounded before it is reduced.

    At smooth u ∈ [1/2, 3/4], where float64 is coarsest: all of them are multiples of 2^-53.
    """
    u = np.random.default_rng(SEED).uniform(0.5, 0.75, POINTS)
    at = {"u": u, "v": 0.125, "k_u": k, "k_v": 4}
    true, used = in_balls(gradient(SINE), at)["h_u"].astype(float), steps[:, None]
    used = (u + used) - u if representable else used  # one for all: u is on the grid of 2^-53
    computed = in_float64(naive(central(SINE)) if library else central(SINE), at | {"epsilon": used})["h_u"]
    return np.abs(computed - true)


def measured(k: float, representable: bool = False, library: bool = False) -> Best:
    """Return the measured Best: where the largest error over the points and the WINDOW steps around is least.

    The error of u ± ε depends on the last bits of ε, so that a single step may be lucky.
    """
    middle = math.log10(predicted(k, representable).step)
    steps = 10.0 ** np.arange(middle - 1.2, middle + 1.2, 1 / PER_DECADE)
    worst = np.pad(errors(k, steps, representable, library).max(axis=1), WINDOW // 2, "edge")
    worst = np.lib.stride_tricks.sliding_window_view(worst, WINDOW).max(axis=1)
    return Best(float(steps[worst.argmin()]), float(worst.min()))


def gain(k: float, library: bool = False) -> float:
    """Return how many times less error representable steps leave, each kind at its best."""
    return measured(k, library=library).floor / measured(k, representable=True, library=library).floor
