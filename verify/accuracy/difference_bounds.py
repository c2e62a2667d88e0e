"""The proved bounds of each part of the central difference's error along a U-curve, and which points are above.

The bounds are those of `renderer.generate.step_terms`, for any field that the theorems cover.
"""

import numpy as np
from numpy.typing import ArrayLike

from proofs.formulas.step_bounds import TERMS
from renderer.generate.step_terms import SLOPE_TERMS
from verify.accuracy.differences import PARTS, SLOPES, STEPS, Case

Curves = dict[str, np.ndarray]  # {part: one number for each step}


@np.errstate(all="ignore")
def bounds(case: Case, steps: ArrayLike = STEPS) -> Curves:
    """Return {part: upper bounds of its size} of PARTS over the steps."""
    steps = np.asarray(steps, np.float64)
    both = SLOPE_TERMS[case.field](case.u, case.v, case.k_u, case.k_v, steps)
    terms = dict(zip(TERMS, both[SLOPES.index(case.component)], strict=True))
    exact, *rounded = PARTS[:-1]
    found = {exact: sum(value for term, value in terms.items() if term not in rounded)}
    found |= {part: terms[part] for part in rounded}
    return found | {PARTS[-1]: sum(found.values())}


def escapes(found: Curves, limits: Curves) -> dict[str, int]:
    """Return {part: how many points are above their bound}; what is not a number is above."""
    return {part: int(np.count_nonzero(~(np.abs(found[part]) <= limit))) for part, limit in limits.items()}
