"""The proved bounds of each part of the central difference's error, in float64 with room for their own rounding.

truncation  theorems truncation_bound, crease_error_area, clamped_difference_of_odd; where none of these holds, the
            difference and the slope are each at most L = π k, or the seam's jump over the span more
argument    an argument off by α moves h by at most L α; both are divided by the span
roundoff    theorem roundoff_bound with η, the error of a computed height, from theorem elementary_functions
"""

from typing import NamedTuple

import numpy as np

from verify.accuracy.certified_ulps import CERTIFIED
from verify.accuracy.differences import Case, Parts

UNIT = 2.0**-53
SINE_ULPS = float(max(CERTIFIED["sinpi_of_product"], CERTIFIED["cospi_of_product"]))
ROOM = 1 + 1e-12  # for the rounding of the bounds themselves


class Bounds(NamedTuple):
    """Upper bounds of |truncation|, |argument|, |roundoff| and of their sum: (steps,) each."""

    truncation: np.ndarray
    argument: np.ndarray
    roundoff: np.ndarray
    total: np.ndarray


def steepest(case: Case, found: Parts) -> np.ndarray:
    """Return L: a bound of |h'| wherever the arguments reach, at most |h'| here and the curvature's share more."""
    rate = np.pi * case.frequency
    near = abs(found.slope) + rate**2 * (found.steps + argument_error(case, found.steps))
    bends = case.place == "crease" or case.field == "ridges"  # |h'| is that of the sine on both sides of a crease
    return np.minimum(rate, near if not bends or found.slope else rate) * ROOM


def _sine_error(largest):
    """Return how far a computed sine of at most `largest` can be off."""
    return SINE_ULPS * np.minimum(UNIT, 2 * UNIT * largest)


def height_errors(case: Case, found: Parts) -> tuple[np.ndarray, float]:
    """Return (η, δ): how far a computed height can be off on its own, and relatively by the factor that both share.

    The factor that does not move is computed once for both heights: its error scales their difference.
    """
    reach = np.minimum(1, found.moving + np.pi * case.frequency * (found.steps + argument_error(case, found.steps)))
    if case.field == "rings":
        return _sine_error(reach), 0.0
    shared = 2 * UNIT * SINE_ULPS
    return (_sine_error(reach) + UNIT * reach) * found.still * (1 + shared), shared


def argument_error(case: Case, steps: np.ndarray) -> np.ndarray:
    """Return α: how far u ± ε, or v ± ε, as float64 has them can be off; wrapping rounds once more."""
    at = case.u if case.component == "h_u" else case.v
    wraps = (case.component == "h_u") & ((at - steps < 0) | (at + steps >= 1))
    return np.spacing(at + steps) / 2 + np.where(wraps, UNIT / 2, 0)


def truncation_bound(case: Case, steps: np.ndarray) -> np.ndarray:
    """Return a bound of |D − h'| in exact arithmetic."""
    rate = np.pi * case.frequency
    smooth, lipschitz = rate**3 * steps**2 / 6, 2 * rate + 0 * steps
    if case.place == "pole" and case.component == "h_v":
        within = steps > case.v
        clamped = (steps**2 + 2 * steps * case.v - 2 * case.v**2) / 6 * rate**3
        first_hump = (case.v + steps) * case.frequency <= 1 if case.field == "ridges" else True
        smooth = np.where(within, np.where(first_hump, clamped, np.inf), smooth)
    elif case.place == "crease" or (case.place == "seam" and case.frequency % 2 == 1):
        reaches = steps > case.distance
        tent = rate * (1 - case.distance / steps) + 2 / 3 * rate * (rate * steps) ** 2
        smooth = np.where(reaches, np.where(steps * 2 * case.frequency <= 1, tent, np.inf), smooth)
    elif case.field == "ridges":
        to_crease = abs(case.u - round(case.u * case.frequency) / case.frequency)
        smooth = np.where(steps > to_crease, np.inf, smooth)
    elif case.place == "seam" and case.frequency % 2:
        jump = abs(np.sin(np.pi * case.frequency))
        smooth = np.where(steps > case.distance, np.inf, smooth)
        lipschitz = lipschitz + np.where(steps > case.distance, jump / (2 * steps), 0)
    return np.minimum(smooth, lipschitz) * ROOM


def bounds(case: Case, found: Parts) -> Bounds:
    """Return the Bounds of a case's Parts."""
    steps = found.steps
    span = np.where((case.component == "h_v") & (steps > case.v), case.v + steps, 2 * steps)
    largest, (alone, shared) = steepest(case, found), height_errors(case, found)
    if case.place == "seam" and case.frequency % 1:
        largest = largest + (steps >= case.distance) / span  # the jump, at most 1, divided
    truncation = truncation_bound(case, steps)
    argument = 2 * largest * argument_error(case, steps) / span * ROOM
    roundoff = (2 * alone / span * (1 + UNIT) ** 2 + largest * (shared + 2 * UNIT + UNIT**2)) * ROOM
    return Bounds(truncation, argument, roundoff, truncation + argument + roundoff)


def escapes(found: Parts, limits: Bounds) -> dict[str, int]:
    """Return {part: how many points are above their bound}; what is not a number is above."""
    return {
        part: int(np.count_nonzero(~(np.abs(getattr(found, part)) <= getattr(limits, part)))) for part in limits._fields
    }
