"""Gradient methods: what may not be asked of the exact one, and a step that is too small."""

import pytest

from renderer import central, central4, exact, forward
from renderer.scene.methods import GradientMethod, difference
from tests.refusals import rejection


def test_the_exact_gradient_has_no_step():
    error = rejection(GradientMethod, "exact", 1e-3)
    assert error == "eps = 0.001 is not allowed: none beside the exact gradient, which takes no step"
    assert rejection(exact, "fast") == "form = 'fast' is not allowed: one of 'auto', 'general', 'algebraic'"


@pytest.mark.filterwarnings("error")
def test_a_step_that_float64_loses_is_told_but_for_a_sweep():
    for method in (central, forward, central4):
        method(2.0**-53)
        difference(method.__name__, 1e-17)
        with pytest.warns(UserWarning, match="below 2"):
            method(1e-17)


def test_a_representable_step_is_a_multiple_of_the_coarsest_spacing():
    for eps in (0.1, 1e-3, 3e-16):
        step = central(eps, representable=True).eps
        assert abs(step - eps) <= 2.0**-53 and (step * 2.0**52).is_integer()
    assert rejection(central, 1e-16, True) == "eps = 1e-16 is not allowed: a finite number from 2.22045e-16 to 0.5"
    assert rejection(central, 1e-3, 1) == "representable = 1 is not allowed: a bool"
