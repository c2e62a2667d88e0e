"""The 50-digit reference of a pixel: its program run on the exact values of a scene's float64 numbers."""

import math
from functools import lru_cache
from typing import Any

from flint import arb
from mpmath import mpf

from proofs.formulas import symbols
from proofs.formulas.finite_difference import METHODS
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.pixel import CHANNELS, light_color, light_position, pixel
from renderer import Light, Scene
from verify.evaluate import DIGITS, Reference
from verify.evaluate.balls import Balls

COLORS = tuple(f"rgb_{c}" for c in CHANNELS)


class Undecided(ValueError):
    """A pixel on an edge, as far as so many digits tell: its selections, and so its colour, are not known."""


@lru_cache(maxsize=64)
def _pixel_references(field, model, lights, method):
    gradient = None if method == "exact" else METHODS[method](HEIGHT_FIELDS[field])
    program = pixel(HEIGHT_FIELDS[field], model, lights, gradient)
    return Reference(program), Balls(program)


def lights_on(scene: Scene) -> list[Light]:
    """Return the lights that are on, in order."""
    return [light for light in scene.lights if light.color is not None]


def scene_values(scene: Scene, **others: Any) -> dict[str, Any]:
    """Return {name: number} of a scene and its lights that are on, as `proofs.formulas.pixel` names its inputs.

    others: width, height, column, row, epsilon.
    """
    center, ball_radius = (scene.ball_center, scene.ball_radius) if scene.ball else ((0.0, 0.0, 0.0), 1.0)
    values = others | {
        "eye": scene.eye,
        "radius": scene.radius,
        "ball_radius": ball_radius,
        "ball_on": float(scene.ball),
        "floor_on": float(scene.floor),
        "k_u": scene.ku,
        "k_v": scene.kv,
        **{name: getattr(scene, name) for name in ("beta", "ka", "kd", "ks", "shininess", "floor_tint")},
        **{s.name: c for s, c in zip(symbols.ball_center, center, strict=True)},
    }
    for name, triple in (("ambient", scene.ambient), ("albedo_a", scene.albedo_a), ("albedo_b", scene.albedo_b)):
        values |= {f"{name}_{c}": value for c, value in zip(CHANNELS, triple, strict=True)}
    for number, light in enumerate(lights_on(scene)):
        assert light.color is not None  # it is on
        values |= {s.name: p for s, p in zip(light_position(number), light.position, strict=True)}
        values |= {s.name: c for s, c in zip(light_color(number), light.color, strict=True)}
    return values


def reference_pixel(
    scene: Scene,
    width: int,
    height: int,
    column: int,
    row: int,
    method: str = "exact",
    eps: float | None = None,
    digits: int = DIGITS,
) -> dict[str, mpf]:
    """Return {name: value} of every line of a pixel's program, from the exact values of the scene's numbers.

    Among the names: surface, occluded_0 … (lights that are on, in order), dark_square, u, v, h_u, h_v, bumped_x …,
    rgb_red, rgb_green, rgb_blue. Off the surface that a name belongs to it has no meaning. Raises Undecided where balls
    of as many digits leave the surface open, or a shadow, a square or a side of a crease that the colour depends on.
    """
    values = scene_values(scene, column=column, row=row, width=width, height=height, epsilon=eps)
    reference, balls = _pixel_references(scene.field, scene.model, len(lights_on(scene)), method)
    enclosed = balls(values, round((digits + 20) / math.log10(2)))
    if wide := [name for name in ("surface", *COLORS) if not enclosed[name].rad() < arb(10) ** (10 - digits)]:
        raise Undecided(f"column = {column}, row = {row}: {', '.join(wide)} undecided at {digits} digits")
    return reference(values, digits)
