"""Gradient methods: what a step may be."""

from renderer import central, exact
from renderer.scene.methods import GradientMethod
from tests.refusals import rejection


def test_a_step_that_is_rejected():
    for eps in (0.0, 0.51, 1e-41):
        assert rejection(central, eps) == f"eps = {eps!r} is not allowed: a finite number from 1e-40 to 0.5"


def test_the_exact_gradient_has_no_step():
    said = rejection(GradientMethod, "exact", 1e-3)
    assert said == "eps = 0.001 is not allowed: None for the exact gradient"
    assert rejection(exact, "fast") == "form = 'fast' is not allowed: one of 'auto', 'general', 'algebraic'"
