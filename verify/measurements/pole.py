"""Toward the pole: the seed's frame and chart in float64 against balls, and the stable ones."""

from functools import cache

import numpy as np

from verify.checkers.measurements import Measurement, measures
from verify.stability.geometry import toward_the_pole

SEED, POINTS = 20, 200


@cache
def _worst(sine):
    """Return the largest |g − exact| near sin φ = sine: (seed, seed without the fallback, stable)."""
    sines = sine * np.random.default_rng(SEED).uniform(1, 1.1, POINTS)
    sweep = toward_the_pole(sines=sines, samples=1, seed=SEED)
    return [sweep.worst(name) for name in ("seed with fallback", "seed", None)]


def _one_digit(value):
    """Return the largest number to one digit: more would depend on the machine's libm."""
    return float(f"{value.max():.0e}")


@measures(
    "pole_accuracy",
    false={"the stable forms lose as much": {"seed_form": 2}, "the fallback helps": {"with_fallback": 1}},
)
def at_two_latitudes(seed_form: int = 1, with_fallback: int = 0) -> Measurement:
    """Measure forms toward the pole: the seed's lose digits, its fallback all of them; the stable ones none."""
    near, nearer = _worst(1.01e-4), _worst(6e-7)
    return Measurement(
        np.concatenate([near[2], nearer[2]]),
        of=_one_digit,
        seed=SEED,
        bound=1e-12,
        holds=near[seed_form].max() > 1e-7 and nearer[seed_form].max() > 1e-3 and nearer[with_fallback].max() > 20,
        quantity="|g − g at 50 digits|, the largest of 200 points, sin φ from 1.01e-4 and from 6e-7, up to a tenth "
        "above",
    )
