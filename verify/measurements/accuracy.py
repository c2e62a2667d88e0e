"""Accuracy of the exact gradient, and of sine and cosine; the forms toward the pole. See verify/accuracy."""

import math
from fractions import Fraction
from functools import cache, partial

import numpy as np

from proofs.formulas.algebraic_form import MAX_WAVE_NUMBER
from proofs.formulas.certified import ALGEBRAIC_GRADIENT, SINE
from verify.accuracy import base_errors, sine
from verify.accuracy.gradient_errors import worst_at
from verify.checkers.measurements import Enclosure, Measurement, measures
from verify.stability.geometry import toward_the_pole

SEED, POINTS = 20, 200


@measures("algebraic_gradient_accuracy", false={"within 40 (1 + k)": {"bound": 40}, "up to the rim": {"least": 0.01}})
def algebraic_gradient(bound: int = ALGEBRAIC_GRADIENT, least: float = base_errors.LEAST_SQUARE) -> Enclosure:
    """Enclose the algebraic form from the image point: its bases over every box of the hits, and their powers."""
    return Enclosure(
        pieces=partial(base_errors.gradient_pieces, least),
        over={
            "R/e": (base_errors.RATIOS,),
            r"\rho/\rho_s": ((0.0, math.sqrt(1 - least)),),
            "k_u": ((-MAX_WAVE_NUMBER, MAX_WAVE_NUMBER),),
            "k_v": ((-MAX_WAVE_NUMBER, MAX_WAVE_NUMBER),),
        },
        at=worst_at,
        bound=bound,
        quantity="the algebraic form: the bound over π k (1 + k) 2^-53, over all boxes of R/e and ρ/ρ_s, all "
        "wave numbers",
    )


@measures("sine_of_half_turns", {"within 12/5": {"bound": Fraction(12, 5)}, "π²/2 is off by 1 ulp": {"off": 1}})
def half_turns(bound: Fraction = SINE, off: int = 0) -> Enclosure:
    """Enclose sine and cosine at every reduced argument."""
    return Enclosure(
        pieces=partial(sine.pieces, off),
        over={"ku": ((0.0, sine.END),)},
        at=sine.errors,
        bound=bound,
        quantity="sine and cosine: the error over every piece of the reduced range, in units of 2^-53",
    )


@cache
def _toward_the_pole(sine):
    """Return the largest |g − exact| near sin φ = sine: (seed, seed without the fallback, stable)."""
    sines = sine * np.random.default_rng(SEED).uniform(1, 1.1, POINTS)
    sweep = toward_the_pole(sines=sines, samples=1, seed=SEED)
    return [sweep.worst(name) for name in ("seed with fallback", "seed", None)]


@measures(
    "pole_accuracy",
    false={"the stable forms lose as much": {"seed_form": 2}, "the fallback helps": {"with_fallback": 1}},
)
def at_two_latitudes(seed_form: int = 1, with_fallback: int = 0) -> Measurement:
    """Measure g near the pole: the seed's form loses digits, the seed's fallback all of them, the stable forms none."""
    near, nearer = _toward_the_pole(1.01e-4), _toward_the_pole(6e-7)
    return Measurement(
        np.concatenate([near[2], nearer[2]]),
        seed=SEED,
        bound=1e-12,
        holds=near[seed_form].max() > 1e-7 and nearer[seed_form].max() > 1e-3 and nearer[with_fallback].max() > 20,
        quantity="|g − g at 50 digits|, the largest of 200 points, sin φ from 1.01e-4 and from 6e-7, up to a tenth "
        "above",
    )
