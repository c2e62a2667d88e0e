"""Errors of slopes: the U-curve taken apart, its best step.

By theorem `difference_bounds`, run with the others, every point lies below its bound.
"""

import numpy as np
import pytest

from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from renderer import Scene, central, gradient_at
from verify.accuracy import best_step
from verify.accuracy.differences import CASES, SLOPES, STEPS, escapes, parts
from verify.evaluate.arrays import in_balls, signed_distance

SOME = STEPS[::20]


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_what_is_taken_apart_is_the_renderers_error(case):
    """Its own difference, one step at a time."""
    scene, errors = Scene(field=case.field, ku=case.k_u, kv=case.k_v), parts(case, SOME)
    slopes = [gradient_at(scene, case.u, case.v, central(step)) for step in SOME.tolist()]
    drawn = np.array(slopes, float)[:, SLOPES.index(case.component)]
    true = in_balls(gradient(HEIGHT_FIELDS[case.field]), case.inputs)[case.component]
    np.testing.assert_array_equal(signed_distance(drawn, true), errors["total"])


def test_what_is_no_number_escapes():
    assert escapes({"total": np.nan * SOME}, {"total": SOME})["total"] == len(SOME)


@pytest.mark.parametrize("k", [1, 8, 512])
@pytest.mark.parametrize("representable", [False, True])
def test_the_best_step_is_where_it_is_predicted(k, representable):
    proved, measured = best_step.predicted(k, representable), best_step.measured(k, representable)
    assert proved.step / 4 < measured.step < proved.step * 2
    assert proved.floor / 20 < measured.floor <= proved.floor
