"""Gradient methods: what a step may be."""

import dataclasses
import math

import pytest

from renderer import central, central4, exact, forward
from renderer.methods import METHODS, GradientMethod

DIFFERENCES = [central, forward, central4]
STEPS = "a finite number from 1e-40 to 0.5"


@pytest.mark.parametrize("make", DIFFERENCES)
@pytest.mark.parametrize("eps", [0.0, -1e-3, math.nan, math.inf, 0.51, 1e-41, 5e-324, "1e-3", None, True, [1e-3]])
def test_a_step_that_is_rejected(make, eps):
    with pytest.raises(ValueError) as error:
        make(eps)
    assert str(error.value) == f"eps = {eps!r} is not allowed: {STEPS}"


@pytest.mark.parametrize("make", DIFFERENCES)
@pytest.mark.parametrize("eps", [0.5, 1e-3, 1e-40])
def test_a_step_that_is_accepted(make, eps):
    assert make(eps).eps == eps


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("backward", 1e-3), "gradient = 'backward' is not allowed: one of 'exact', 'forward', 'central', 'central4'"),
        (("exact", None, "fast"), "form = 'fast' is not allowed: one of 'auto', 'general', 'algebraic'"),
    ],
)
def test_an_unknown_method_or_form(arguments, message):
    with pytest.raises(ValueError, match=message):
        GradientMethod(*arguments)


def test_the_exact_gradient_has_no_step():
    with pytest.raises(ValueError, match=r"eps = 0\.001 is not allowed: None for the exact gradient"):
        GradientMethod("exact", 1e-3)
    assert exact().eps is None


def test_every_method_has_its_name():
    made = [exact(), forward(1e-3), central(1e-3), central4(1e-3)]
    assert tuple(method.name for method in made) == METHODS


def test_frozen():
    with pytest.raises(dataclasses.FrozenInstanceError):
        central(1e-3).eps = 0.1
