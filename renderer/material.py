"""The scene's shading as the kernels take it: weights, colours, lights, and how the highlight is taken."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from renderer.chambers import FIRST_LIGHT_BIT
from renderer.kernels import ambient_term, floor_albedo


class Material(NamedTuple):
    """The scene's shading, as the kernels take it.

    numbers: (16,) kd, ks, shininess, ambient colour (3), albedo of A, of B, of light and of dark floor squares (2: red
    and green, blue). lights: (n, 6) position and colour of the lights that are on and not black; bits: (n,). power:
    the whole power that the highlight's base is raised to, 0 if the shininess is not whole. Of the last four one is
    True, and the others are None, so that Numba leaves out their branches: no highlight; Phong's; Blinn's; Blinn's
    from its base squared, for an even shininess.
    """

    numbers: np.ndarray
    lights: np.ndarray
    bits: np.ndarray
    power: int
    dull: bool | None
    phong: bool | None
    blinn: bool | None
    squared: bool | None


def highlight_of(scene):
    """Return (power, Phong's, Blinn's, Blinn's from its square): how the scene's highlight is taken, if it has one."""
    power = int(scene.shininess) if scene.shininess == int(scene.shininess) else 0
    even = scene.model == "blinn" and power > 0 and power % 2 == 0
    style = "squared" if even else scene.model
    return power // 2 if even else power, *(True if style == name else None for name in ("phong", "blinn", "squared"))


@lru_cache(maxsize=64)
def material_of(scene):
    """Return the Material of a scene."""
    lit = [(n, light) for n, light in enumerate(scene.lights) if light.color is not None and any(light.color)]
    ambient = [ambient_term(scene.ka, channel) for channel in scene.ambient]
    floor = [channel for dark in (0.0, 1.0) for channel in floor_albedo(dark, scene.floor_tint)]
    power, *styles = highlight_of(scene)
    dull = scene.ks == 0.0
    weights = [scene.kd, scene.ks, scene.shininess]
    return Material(
        np.array([*weights, *ambient, *scene.albedo_a, *scene.albedo_b, *floor]),
        np.array([(*light.position, *light.color) for _, light in lit], np.float64).reshape(-1, 6),
        np.array([1 << (FIRST_LIGHT_BIT + number) for number, _ in lit], np.uint8),
        power,
        True if dull else None,
        *(None if dull else style for style in styles),
    )


def material_key(material):
    """Return what is equal for equal materials, and hashable."""
    return (*(part.tobytes() if isinstance(part, np.ndarray) else part for part in material),)
