"""Gradient methods: what a step may be."""

import math

import pytest

from renderer import central, central4, exact, forward
from renderer.methods import METHODS, GradientMethod


@pytest.mark.parametrize("eps", [0.0, -1e-3, math.nan, math.inf, 0.51, 1e-41, 5e-324, "1e-3", None, True, [1e-3]])
def test_a_step_that_is_rejected(eps):
    with pytest.raises(ValueError) as error:
        central(eps)
    assert str(error.value) == f"eps = {eps!r} is not allowed: a finite number from 1e-40 to 0.5"


@pytest.mark.parametrize("eps", [0.5, 1e-40])
def test_a_step_that_is_accepted(eps):
    assert central(eps).eps == eps


def test_an_unknown_form():
    with pytest.raises(ValueError, match="form = 'fast' is not allowed: one of 'auto', 'general', 'algebraic'"):
        exact("fast")


def test_the_exact_gradient_has_no_step():
    with pytest.raises(ValueError, match=r"eps = 0\.001 is not allowed: None for the exact gradient"):
        GradientMethod("exact", 1e-3)


def test_every_method_has_its_name():
    made = [exact(), forward(1e-3), central(1e-3), central4(1e-3)]
    assert tuple(method.name for method in made) == METHODS
