"""An optimiser climbs toward the worst case of the bound that is measured on samples, and proved nowhere."""

import numpy as np
from hypothesis import Phase, given, seed, settings, target
from hypothesis.strategies import floats, integers

from proofs.engine.theorem import all_theorems
from verify.stability.geometry import toward_the_pole


def test_no_climber_gets_above_the_bound(pytestconfig):
    """Of g by the stable frame. And it finds what is there: the least would be no bound, which a few steps show."""
    assert [id for id, theorem in all_theorems().items() if theorem.expected == "measured"] == ["pole_accuracy"]
    reached = []

    @seed(24)
    @settings(max_examples=2000 if pytestconfig.getoption("long") else 40, deadline=None, database=None,
              phases=[Phase.generate, Phase.target])  # fmt: skip
    @given(floats(3.9, 6.3), integers(0, 2**16))
    def look(digits, number):
        reached.append(float(toward_the_pole(sines=np.array([10.0**-digits]), samples=1, seed=number).worst().max()))
        target(reached[-1])

    look()
    assert 1e-16 < max(reached) <= 1e-12
