"""Programs over arrays: with bounds the same numbers, never too small a bound, and a fault that they see."""

import flint
import numpy as np
import pytest
from sympy import exp, log, sqrt

from proofs.engine.program import Program, chain
from proofs.formulas.camera import angles_on_a
from proofs.formulas.chart import chart
from proofs.formulas.half_turns import sinpi
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from proofs.formulas.symbols import real
from renderer import operations
from renderer.machines.enclosing import UNIT, Enclosed
from verify.evaluate.arrays import distance, in_balls, in_float64, with_bounds

a, b, c, result = real("a b c result")
RANDOM = np.random.default_rng(11)
PAIRS = {"a": RANDOM.uniform(-3, 3, 500), "b": RANDOM.uniform(-3, 3, 500), "c": RANDOM.uniform(0, 3, 500)}


def program(expression):
    """Return the program of one line."""
    inputs = tuple(sorted(expression.free_symbols, key=str))
    return Program("line", inputs, ((result, expression),), (result,))


def test_it_computes_what_the_kernels_compute():
    whole = chain("whole", angles_on_a, chart, gradient(HEIGHT_FIELDS["ridges"]))
    inputs = {"x": PAIRS["a"] / 4, "y": PAIRS["b"] / 4, "eye": 4.0, "radius": 1.0, "k_u": 8.0, "k_v": 4.0}
    ours, bounded = in_float64(whole, inputs), with_bounds(whole, inputs)
    for name, numbers in ours.items():
        np.testing.assert_array_equal(bounded[name].value, numbers)


@pytest.mark.parametrize(
    "expression",
    [
        a + b,
        a * b - c,
        a / b,
        sqrt(c) / 3,
        (a - b) * (a + b) - a * a + b * b,
        sinpi(a * b),
        abs(a) * c**3,
        exp(a * b),
        log(c * c),
        (c / 3) ** (3 + a),
    ],
)
def test_no_error_is_above_its_bound(expression):
    line = program(expression)
    bounded = with_bounds(line, PAIRS)["result"]
    errors = distance(bounded.value, in_balls(line, PAIRS)["result"])
    assert (errors <= bounded.bound).all()
    assert np.median(bounded.bound) < 1e-14


def test_a_fault_in_the_last_places_is_above_its_bound():
    bounded, exact = with_bounds(program(a + b), PAIRS)["result"], in_balls(program(a + b), PAIRS)["result"]
    off = distance(bounded.value * (1 + 3 * 2 * UNIT), exact)
    assert (off > bounded.bound).mean() > 0.9


def test_a_comparison_that_rounding_can_turn_covers_both_branches():
    near = Enclosed(np.array([1.0, 1.0]), np.array([1e-3, 0.0]))
    chosen = operations.where(near >= 1.0005, 5.0, 2.0)
    assert chosen.value.tolist() == [2.0, 2.0]
    assert (chosen.bound >= [3.0, 0.0]).all()  # and no more than what makes up for rounded bounds
    np.testing.assert_allclose(chosen.bound, [3.0, 0.0], rtol=1e-6)


def test_a_divisor_that_may_be_zero_has_no_bound():
    with np.errstate(all="ignore"):
        assert np.isinf((Enclosed(1.0) / Enclosed(np.array([1e-3]), np.array([2e-3]))).bound).all()


def test_a_ball_that_decides_nothing_is_no_reference():
    """1/(sin πa − sin πb) with a = b: the ball of the difference is around 0, that of the quotient everywhere."""
    assert in_balls(program(1 / (sinpi(a) - sinpi(b))), {"a": [0.3], "b": [0.3]})["result"][0] is None
    assert isinstance(in_balls(program(a * b), {"a": [0.3], "b": [0.1]})["result"][0], flint.arb)
