"""The U-curve taken apart: the three parts make the whole, a point above its bound is seen, and the best step is.

That every point lies below its bound is the theorem `difference_bounds`, run with the others.
"""

import mpmath
import numpy as np
import pytest

from proofs.formulas.finite_difference import central as central_difference
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from renderer import Scene, central, gradient_at
from verify.accuracy import best_step
from verify.accuracy.differences import CASES, PARTS, SLOPES, STEPS, bounds, escapes, parts
from verify.evaluate import DIGITS, Reference

STEEP = CASES[0]
SOME = STEPS[::20]


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_mpmath_and_the_renderer_measure_the_same(case):
    """Other arithmetic than the balls', and the renderer's own difference, one step at a time."""
    of_slope, of_difference = (Reference(make(HEIGHT_FIELDS[case.field])) for make in (gradient, central_difference))
    scene, found = Scene(field=case.field, ku=case.k_u, kv=case.k_v), parts(case, SOME[::3])
    np.testing.assert_allclose(sum(found[part] for part in PARTS[:-1]), found["total"], rtol=1e-6, atol=1e-14)
    with mpmath.workdps(DIGITS):
        slope = of_slope(case.inputs)[case.component]
        for step, total, truncation in zip(SOME[::3], found["total"], found["truncation"], strict=True):
            drawn = gradient_at(scene, case.u, case.v, central(float(step)))[SLOPES.index(case.component)]
            true = of_difference(case.inputs | {"epsilon": float(step)})[case.component]
            assert float(mpmath.mpf(float(drawn)) - slope) == pytest.approx(total, rel=1e-14, abs=1e-40)
            assert float(true - slope) == pytest.approx(truncation, rel=1e-14, abs=1e-40)


def test_an_escape_is_seen():
    found, limits = parts(STEEP, SOME), bounds(STEEP, SOME)
    assert not any(escapes(found, limits).values())
    assert any(escapes(found, {part: limit / 4 for part, limit in limits.items()}).values())
    assert escapes(found | {"total": np.nan * SOME}, limits)["total"] == len(SOME)
    assert escapes({part: errors + 1e-4 for part, errors in found.items()}, limits)[PARTS[2]] > 10  # a kernel's fault


def test_a_representable_step_leaves_no_error_in_the_arguments():
    step = best_step.representable_step(0.61, 1e-7)
    moved = parts(STEEP, [step, 1e-7])[PARTS[1]]
    assert step != 1e-7 and moved[0] == 0 != moved[1]


@pytest.mark.parametrize(("k", "most"), [(8, 1.5), (512, 3.0)])
def test_representable_steps_need_a_sine_of_an_exact_argument(k, most):
    assert 0.5 < best_step.gain(k, library=True) < most < best_step.gain(k) / 2


@pytest.mark.parametrize("k", [1, 8, 512])
@pytest.mark.parametrize("representable", [False, True])
def test_the_best_step_is_where_it_is_predicted(k, representable):
    proved, seen = best_step.predicted(k, representable), best_step.measured(k, representable)
    assert proved.step / 4 < seen.step < proved.step * 2
    assert proved.floor / 20 < seen.floor <= proved.floor
