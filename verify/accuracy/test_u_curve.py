"""Errors of slopes: the U-curve taken apart, and its best step."""

import numpy as np
import pytest

from proofs.formulas.finite_difference import METHODS
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from renderer import Scene, gradient_at
from renderer.scene.methods import difference
from verify.accuracy import best_step
from verify.accuracy.differences import CASES, SLOPES, STEPS, bounds, escapes, parts
from verify.evaluate.arrays import in_balls, signed_distance

SOME = slice(None, None, 20)


@pytest.mark.parametrize("method", METHODS)
def test_no_part_of_the_error_is_above_its_bound(method):
    """The bounds hold, a third of them does not, and where rounding rules their median is below thirty times the error.

    The error is the renderer's own, taken apart by term, one step ε at a time."""
    ratios, above = [], 0
    for case in (case._replace(method=method) for case in CASES):
        errors, limits = parts(case), bounds(case)
        assert not any(escapes(errors, limits).values()), case.name
        above += sum(escapes(errors, {part: limit / 3 for part, limit in limits.items()}).values())
        rounding = (STEPS < 1e-9) & (errors["total"] != 0)
        ratios += [*limits["total"][rounding] / np.abs(errors["total"][rounding])]
        scene = Scene(field=case.field, ku=case.k_u, kv=case.k_v)
        slopes = [gradient_at(scene, case.u, case.v, difference(method, step)) for step in STEPS[SOME].tolist()]
        drawn = np.array(slopes, float)[:, SLOPES.index(case.component)]
        true = in_balls(gradient(HEIGHT_FIELDS[case.field]), case.inputs)[case.component]
        np.testing.assert_array_equal(signed_distance(drawn, true), errors["total"][SOME])
    assert above and np.median(ratios) <= 30


def test_what_is_no_number_escapes():
    assert escapes({"total": np.nan * STEPS}, {"total": STEPS})["total"] == len(STEPS)


@pytest.mark.parametrize("k", [1, 8, 512])
@pytest.mark.parametrize("representable", [False, True])
def test_the_best_step_is_where_it_is_predicted(k, representable):
    proved, measured = best_step.predicted(k, representable), best_step.measured(k, representable)
    assert proved.step / 4 < measured.step < proved.step * 2
    assert proved.floor / 20 < measured.floor <= proved.floor
