"""The order of the difference that is clamped at the pole, at a fixed v/ε < 1, in exact arithmetic.

Second for the chapter's fields, which are odd about v = 0; first for one that is not: cos πk_v v.
"""

import numpy as np

from proofs.formulas.finite_difference import central
from proofs.formulas.half_turns import cospi
from proofs.formulas.height_fields import HEIGHT_FIELDS, HeightField, gradient
from proofs.formulas.symbols import k_v, v
from verify.evaluate.arrays import distance, in_balls

ODD = ("sine", "ridges", "rings")
FIELDS = {name: HEIGHT_FIELDS[name] for name in ODD} | {"cosine": HeightField("cosine", cospi(k_v * v))}
STEPS = np.logspace(-6, -3, 13)


def errors(field: str, ratio: float = 0.5, steps: np.ndarray = STEPS) -> np.ndarray:
    """Return |D − h_v| at v = ratio · ε for each step, in exact arithmetic: k = (8, 4), u = 0.31."""
    at = {"u": 0.31, "v": ratio * steps, "k_u": 8.0, "k_v": 4.0, "epsilon": steps}
    return distance(in_balls(central(FIELDS[field]), at)["h_v"], in_balls(gradient(FIELDS[field]), at)["h_v"])


def fitted_slope(steps: np.ndarray, values: np.ndarray) -> float:
    """Return the slope of log values against log steps by least squares."""
    return float(np.polyfit(np.log(steps), np.log(values), 1)[0])


def order(field: str, ratio: float = 0.5) -> float:
    """Return the fitted order of the clamped difference of a field."""
    return fitted_slope(STEPS, errors(field, ratio))
