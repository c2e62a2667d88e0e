"""Steps that float64 does not take: the printed central difference, of heights that no rounding makes flat."""

import numpy as np

from renderer import kernels
from verify.accuracy.binades import dies
from verify.checkers.measurements import Measurement, measures

SEED, EACH, DEEPEST = 31, 400, 60
STEPS = (0.2, 0.25, 0.26, 0.49, 0.51, 0.74, 0.76, 1.2)  # in spacings; the tie apart


def _numbers():
    """Return float64 numbers below 1 of each binade, with the first, the second and the last of it."""
    significands = np.random.default_rng(SEED).integers(2**52, 2**53, (DEEPEST, EACH))
    significands[:, :3] = 2**52, 2**52 + 1, 2**53 - 1
    return np.ldexp(significands.astype(float), -53 - np.arange(DEEPEST)[:, None])


def slopes(at: np.ndarray, step: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return h_u of the height u, and h_v of the height v, there."""
    in_u, _ = kernels.central(lambda u, v, k_u, k_v: u, at, 0.5, 1.0, 1.0, step)
    _, in_v = kernels.central(lambda u, v, k_u, k_v: v, 0.5, at, 1.0, 1.0, step)
    return in_u, in_v


@measures(
    "binades",
    false={
        "up to a whole spacing": {"within": 1.0},
        "at a power of two as elsewhere": {"at_power": 0.49},
        "at the tie for every significand": {"odd": 0.0},
    },
)
def steps_that_are_lost(within: float = 0.5, at_power: float = 0.25, odd: float = 2.0) -> Measurement:
    """Measure the slopes of h = u and h = v: 0 where the theorem says so, and at a tie 2 for odd significands."""
    at = _numbers()
    slopes_seen, claimed = [], []
    for share in STEPS:
        step = share * np.spacing(at)
        lost = dies(at, step, within, at_power)
        for slope in slopes(at, step):
            slopes_seen.append(slope[lost])
            claimed.append(np.zeros(lost.sum()))
    inner = at[:, 3:]
    tie = np.spacing(inner) / 2
    is_odd = np.ldexp(inner, 53 + np.arange(DEEPEST)[:, None]) % 2 == 1
    for slope in slopes(inner, tie):
        slopes_seen.append(slope.ravel())
        claimed.append(np.where(is_odd, odd, 0.0).ravel())
    return Measurement(
        np.concatenate(slopes_seen),
        claimed=np.concatenate(claimed),
        seed=SEED,
        bound=0,
        quantity=f"how far slopes of h = u and h = v in {DEEPEST} binades are from what the theorem says",
        numbers={"tie_odd": np.count_nonzero(is_odd)},
    )
