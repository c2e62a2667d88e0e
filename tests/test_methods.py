"""Gradient methods: what may not be asked of the exact one."""

from renderer import exact
from renderer.scene.methods import GradientMethod
from tests.refusals import rejection


def test_the_exact_gradient_has_no_step():
    said = rejection(GradientMethod, "exact", 1e-3)
    assert said == "eps = 0.001 is not allowed: None for the exact gradient"
    assert rejection(exact, "fast") == "form = 'fast' is not allowed: one of 'auto', 'general', 'algebraic'"
