"""Steps that float64 cannot take: where the theorem says that a slope dies, the renderer's slope is 0."""

import numpy as np
import pytest

from book.figures.binades import STEPS
from renderer import Scene, central, height_at, render
from verify.accuracy.binades import dies

SCENE = Scene(field="sine")


@pytest.mark.parametrize("step", STEPS)
def test_every_slope_dies_where_the_theorem_says_and_elsewhere_by_equal_heights(step):
    at = render(SCENE, 256, 256, central(step)).data_on_a
    for axis in "uv":
        counted, lost = at[f"h_{axis}"] == 0, dies(at[axis], step)
        assert not (lost & ~counted).any()
        more = dies(at[axis], step, within=1.0, at_power=0.5)
        assert (more & ~counted).any() or not more.any()  # a whole spacing would be too much
        rest = counted & ~lost
        u, v = at["u"][rest], at["v"][rest]
        ends = [(u + s, v) if axis == "u" else (u, v + s) for s in (step, -step)]
        np.testing.assert_array_equal(*(height_at(SCENE, *end) for end in ends))
