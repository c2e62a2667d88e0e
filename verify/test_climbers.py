"""An optimiser climbs toward the worst case of each bound that is measured on samples, and proved nowhere."""

import math

import numpy as np
import pytest
from hypothesis import Phase, given, seed, settings, target
from hypothesis.strategies import fixed_dictionaries, floats, integers

from proofs.engine.theorem import all_theorems
from verify.stability.geometry import toward_the_pole


def stable_frame(digits, number):
    """Return the error of g by the stable frame."""
    return float(toward_the_pole(sines=np.array([10.0**-digits]), samples=1, seed=number).worst().max())


CLIMBS = {"pole_accuracy": (stable_frame, 1e-12, 1e-16, {"digits": floats(3.9, 6.3), "number": integers(0, 2**16)})}
"""{theorem: (what is climbed, the bound that it claims, what is found at least, from where)}"""


def climb(theorem, examples):
    """Return the highest value that was reached, by hypothesis, which goes on from the highest ones."""
    height, _, _, where = CLIMBS[theorem]
    reached = [0.0]

    @seed(24)
    @settings(max_examples=examples, deadline=None, database=None, phases=[Phase.generate, Phase.target])
    @given(fixed_dictionaries(where))
    def look(at):
        value = height(**at)
        assert not math.isinf(value), at
        reached.append(0.0 if math.isnan(value) else value)  # no digits decide there
        target(reached[-1])

    look()
    return max(reached)


@pytest.mark.parametrize("theorem", CLIMBS)
def test_no_climber_gets_above_the_bound(theorem, pytestconfig):
    """And it finds what is there: the least would be no bound, which a few steps show."""
    _, bound, least, _ = CLIMBS[theorem]
    assert least < climb(theorem, 2000 if pytestconfig.getoption("long") else 40) <= bound


def test_each_measured_bound_has_a_climber():
    measured = {id for id, theorem in all_theorems().items() if theorem.expected == "measured"}
    assert measured == CLIMBS.keys()
