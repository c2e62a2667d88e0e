"""Sphere A: the one surface that a bump changes, drawn by the shader of its field and way to the gradient."""

from typing import NamedTuple

import numpy as np

from renderer.gradients import algebraic_powers, uses_algebraic_form
from renderer.kernels import FIELDS
from renderer.material import material_of
from renderer.shaders import SHADERS, draw_flat


class Bump(NamedTuple):
    """How sphere A is drawn: the shader and what it is given beside the runs; heights a gradient, whether algebraic."""

    shader: object
    arguments: tuple
    heights: int
    algebraic: bool

    def draw(self, stage, band, work, rgb=None, planes=None):
        """Draw the band's runs of A into `rgb`, (3, height, width), or what is known of them into `planes`, or both.

        planes: (6, height, width): cos θ, sin θ, cos φ, sin φ, h_u, h_v. work: (3,) int64, added to.
        """
        self.shader(band.runs_on_a, *stage.place(band), *self.arguments, rgb, planes, work)


def bump_of(scene, method, flat=False):
    """Return the Bump of a scene by a method. Where `flat` is set there is no gradient at all."""
    numbers = np.array([scene.ku, scene.kv, scene.beta, method.eps or 0.0])
    algebraic = method.name == "exact" and uses_algebraic_form(scene, method)
    powers = algebraic_powers(scene) if algebraic else (0, 0)
    arguments = (numbers, powers, *material_of(scene))
    if flat:
        return Bump(draw_flat, arguments, 0, False)
    role = "algebraic" if algebraic else "general" if method.name == "exact" else method.name
    heights = FIELDS[scene.field]["height_evaluations"].get(role, 0)
    return Bump(SHADERS[scene.field][role], arguments, heights, algebraic)
