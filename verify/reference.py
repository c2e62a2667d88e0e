"""The reference of a pixel: its program in balls of 50 digits, of the exact values of a scene's numbers."""

import math
from collections.abc import Callable
from functools import lru_cache
from typing import Any

from flint import arb

from proofs.formulas.finite_difference import METHODS
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.pixel import albedo_of_a, albedo_of_b, ambient_light, light_color, light_position, pixel, rgb
from proofs.formulas.symbols import ball_center
from renderer import Light, Scene
from verify.evaluate import DIGITS
from verify.evaluate.balls import Balls

COLORS = tuple(s.name for s in rgb)


class Undecided(ValueError):
    """The error that balls do not decide a pixel's selections: it is on an edge, as far as these digits tell."""


@lru_cache(maxsize=64)
def _lines_of(field, model, lights, method, *bump):
    """Return a whole pixel in balls, by a gradient method: exact is the general form."""
    height_field = HEIGHT_FIELDS[field]
    gradient = None if method == "exact" else METHODS[method](height_field)
    return Balls(pixel(height_field, model, lights, gradient, *bump))


def lines_of(scene: Scene, method: str, bits: int, **others: Any) -> dict[str, arb]:
    """Return {name: ball} of every line of a pixel's program, of the exact values of the scene's numbers and others."""
    lines = _lines_of(scene.field, scene.model, len(lights_on(scene)), method, scene.bump, scene.horizon)
    return lines(scene_values(scene, **others), bits)


def lights_on(scene: Scene) -> list[Light]:
    """Return the lights that are on, in order."""
    return [light for light in scene.lights if light.color is not None]


def scene_values(scene: Scene, **others: Any) -> dict[str, Any]:
    """Return {name: number} of a scene and its lights that are on, as `proofs.formulas.pixel` names its inputs.

    others: a program's further inputs (width, height, column, row, epsilon, or an image point's x and y), and numbers
    in place of the scene's.
    """
    center, ball_radius = (scene.ball_center, scene.ball_radius) if scene.ball else ((0.0, 0.0, 0.0), 1.0)
    fields = ("eye", "radius", "beta", "ka", "kd", "ks", "shininess", "floor_tint")
    values = {name: getattr(scene, name) for name in fields} | {"k_u": scene.ku, "k_v": scene.kv}
    values |= {"ball_radius": ball_radius, "ball_on": float(scene.ball), "floor_on": float(scene.floor)}
    triples: list = [(ball_center, center), (ambient_light, scene.ambient)]
    triples += [(albedo_of_a, scene.albedo_a), (albedo_of_b, scene.albedo_b)]
    for number, light in enumerate(lights_on(scene)):
        triples += [(light_position(number), light.position), (light_color(number), light.color)]
    return values | {s.name: c for names, numbers in triples for s, c in zip(names, numbers, strict=True)} | others


def chamber_code(scene: Scene, number_of: Callable[[str], Any]) -> Any:
    """Return the chamber code, as `renderer.picture.stage.Stage` defines it; whole: from a line's name to its value."""
    on = [number for number, light in enumerate(scene.lights) if light.color is not None]
    shadows = sum(number_of(f"occluded_{n}") << 2 + number for n, number in enumerate(on))
    return number_of("surface") | shadows | number_of("dark_square") << 7


def reference_pixel(
    scene: Scene, width: int, height: int, column: int, row: int, digits: int = DIGITS
) -> dict[str, arb]:
    """Return {name: ball} of every line of a pixel's program, from the exact values of the scene's numbers.

    Among the names: surface, occluded_0 … (lights that are on, in order), dark_square, u, v, h_u, h_v, bumped_x …,
    rgb_red, rgb_green, rgb_blue. Off the surface that a name belongs to it has no meaning. Raises Undecided where balls
    of as many digits leave the surface open, or a shadow, a square or a side of a crease that the colour depends on.
    """
    place = {"column": column, "row": row, "width": width, "height": height}
    enclosed = lines_of(scene, "exact", round((digits + 20) / math.log10(2)), **place)
    if wide := [name for name in ("surface", *COLORS) if not enclosed[name].rad() < arb(10) ** (10 - digits)]:
        raise Undecided(f"column = {column}, row = {row}: {', '.join(wide)} undecided at {digits} digits")
    return enclosed
