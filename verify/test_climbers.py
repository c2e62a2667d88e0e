"""An optimiser climbs toward the worst case of the bound that is measured on samples, and proved nowhere."""

import numpy as np
import pytest
from hypothesis import Phase, given, seed, settings, target
from hypothesis.strategies import floats, integers

from proofs.engine.theorem import all_theorems
from verify.stability.geometry import toward_the_pole

MEASURED = [id for id, theorem in all_theorems().items() if theorem.expected == "measured"]


def stable_frame(examples):
    """Return the largest error of g by the stable frame that hypothesis finds, which goes on from the highest ones."""
    reached = [0.0]

    @seed(24)
    @settings(max_examples=examples, deadline=None, database=None, phases=[Phase.generate, Phase.target])
    @given(floats(3.9, 6.3), integers(0, 2**16))
    def look(digits, number):
        reached.append(float(toward_the_pole(sines=np.array([10.0**-digits]), samples=1, seed=number).worst().max()))
        target(reached[-1])

    look()
    return max(reached)


CLIMBS = {"pole_accuracy": (stable_frame, 1e-12, 1e-16)}
"""{theorem: (what is climbed, the bound that it claims, what is found at least)}"""


@pytest.mark.parametrize("theorem", MEASURED)
def test_no_climber_gets_above_the_bound(theorem, pytestconfig):
    """And it finds what is there: the least would be no bound, which a few steps show."""
    climb, bound, least = CLIMBS[theorem]
    assert least < climb(2000 if pytestconfig.getoption("long") else 40) <= bound
