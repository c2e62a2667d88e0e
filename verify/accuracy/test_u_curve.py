"""The U-curve taken apart: the three parts make the whole, a point above its bound is seen, and the best step is.

That every point lies below its bound is the theorem `difference_bounds`, run with the others.
"""

import numpy as np
import pytest

from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from renderer import Scene, central, gradient_at
from verify.accuracy import best_step
from verify.accuracy.differences import CASES, SLOPES, STEPS, bounds, escapes, parts
from verify.evaluate.arrays import in_balls, signed_distance

STEEP = CASES[0]
SOME = STEPS[::20]


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_what_is_taken_apart_is_the_renderers_error(case):
    """Its own difference, one step at a time."""
    scene, found = Scene(field=case.field, ku=case.k_u, kv=case.k_v), parts(case, SOME)
    slopes = [gradient_at(scene, case.u, case.v, central(step)) for step in SOME.tolist()]
    drawn = np.array(slopes, float)[:, SLOPES.index(case.component)]
    true = in_balls(gradient(HEIGHT_FIELDS[case.field]), case.inputs)[case.component]
    np.testing.assert_array_equal(signed_distance(drawn, true), found["total"])


def test_an_escape_is_seen():
    found, limits = parts(STEEP, SOME), bounds(STEEP, SOME)
    assert not any(escapes(found, limits).values())
    assert any(escapes(found, {part: limit / 4 for part, limit in limits.items()}).values())
    assert escapes(found | {"total": np.nan * SOME}, limits)["total"] == len(SOME)


@pytest.mark.parametrize("k", [1, 8, 512])
@pytest.mark.parametrize("representable", [False, True])
def test_the_best_step_is_where_it_is_predicted(k, representable):
    proved, seen = best_step.predicted(k, representable), best_step.measured(k, representable)
    assert proved.step / 4 < seen.step < proved.step * 2
    assert proved.floor / 20 < seen.floor <= proved.floor
