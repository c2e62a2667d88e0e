"""Slopes of a picture by numbers of its scene: the numbers' names, and where the slopes begin."""

from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import repeat
from types import SimpleNamespace
from typing import Any

from renderer.checks import check_items, not_allowed
from renderer.kernels import image_extent
from renderer.machines.differentiating import Sloped
from renderer.machines.differentiating_machine import Differentiating, Pixels, with_slopes
from renderer.machines.forms import COLORS, Shader, of_form
from renderer.operations import where
from renderer.scene.methods import exact
from renderer.scene.scene import Scene
from renderer.shader.numbers import FIRST_LIGHT_BIT, Shot, Want

OF_BODY = {"ball_center": "ball", "ball_radius": "ball", "albedo_b": "ball", "floor_tint": "floor"}
ALLOWED = "names of the scene's numbers as its record has them, such as beta, albedo_a[0], lights[1].position[2]"
PLACES = {"ball_center": ("ball", 0), "ball_radius": ("ball", 3), "shininess": ("power", 0)}
"""{name of a scene's number: where the shader has it}, but for those that it has by the same name."""


def _parts(name, value):
    """Return the names of a number, or of a tuple's."""
    return [name] if isinstance(value, float) else [f"{name}[{part}]" for part in range(len(value))]


def numbers_of(scene: Scene) -> Iterator[tuple[str, str]]:
    """Yield (name, "" or the body or light that has it and is off) of every number of a scene."""
    for name, value in vars(scene).items():
        body = OF_BODY.get(name, "")
        if isinstance(value, float) or (isinstance(value, tuple) and name != "lights"):
            yield from zip(_parts(name, value), repeat("" if not body or getattr(scene, body) else body))
    for number, light in enumerate(scene.lights):
        name = f"lights[{number}]"
        for part, value in vars(light).items():
            yield from zip(_parts(f"{name}.{part}", value or "rgb"), repeat("" if light.color else name))


def asked(shot: Shot, names: Iterable[str]) -> tuple[Shot, dict[str, tuple]]:
    """Return the shot that has slopes by numbers of its scene, and the parts of its Want that they change.

    Where the picture needs no gradient, or no highlight, its slope may. Raises ValueError on what has no slope.
    """
    names, numbers = check_items("derivatives", names, ALLOWED), dict(numbers_of(shot.scene))
    for name in names:
        if not isinstance(name, str) or name not in numbers:
            raise not_allowed("derivatives", name, ALLOWED)
        if numbers[name]:
            raise not_allowed("derivatives", name, f"no number of {numbers[name]}, which is off in this scene")
    method = shot.method.name
    if method == "exact" and {"ku", "kv"} & set(names):
        if shot.method.form == "algebraic":
            raise not_allowed("form", "algebraic", "general or auto beside a slope by ku or kv: whole powers have none")
        shot = replace(shot, method=exact("general"))
    ((field, way),), ((model, style),) = shot.want.ways, shot.want.lights
    if way == "flat" and "beta" in names:
        way = "general" if method == "exact" else method
    if style == "diffuse" and "ks" in names:
        style = "base"
    return shot, {"by": tuple(dict.fromkeys(names)), "ways": ((field, way),), "lights": ((model, style),)}


def slope_planes(count: int, bounds: bool) -> list[str]:
    """Return the names of the planes of so many slopes, and then of their bounds."""
    ends = ("", "_bound") if bounds else ("",)
    return [f"{color}_slope_{number}{end}" for end in ends for number in range(count) for color in COLORS]


def shader_of(want: Want, shader: Shader) -> Shader:
    """Return a shader as it draws a want's slopes."""
    planes = (*shader.planes, *slope_planes(len(want.by), want.bounds))
    return shader._replace(planes=planes, around=_sloped_group)


def _place(name):
    """Return (the name, the number in brackets at its end or 0)."""
    base, _, part = name.partition("[")
    return base, int(part[:-1] or 0)


def _seeded(seeds, name, part, slope):
    """Return seeds with a slope in place of a number's."""
    old = getattr(seeds, name)
    now = (*old[:part], slope, *old[part + 1 :]) if isinstance(old, tuple) else slope
    return SimpleNamespace(**vars(seeds) | {name: now})


def _seeds(numbers, name, style):
    """Return the slopes of the shader's numbers by one of the scene's, in their form."""
    seeds = of_form(numbers, repeat(0.0))
    if name.startswith("lights"):
        return seeds
    if name == "ka":
        return SimpleNamespace(**vars(seeds) | {"ambient": numbers.ambient_light})
    if name == "floor_tint":  # red and green are (1 − tint) times blue
        reds = {of: (-getattr(numbers, of)[1], 0.0) for of in ("floor_light", "floor_dark")}
        return SimpleNamespace(**vars(seeds) | reds)
    base, part = _place(name)
    place, first = PLACES.get(base, (base, 0))
    slope = numbers.ka if base == "ambient" else 0.5 if (base, style) == ("shininess", "squared") else 1.0
    return _seeded(seeds, place, first + part, slope)


def _light_seeds(light, name):
    """Return the same of a light's numbers. The loop over lights is traced once: a light is known by its bit."""
    seeds = of_form(light, repeat(0.0))
    if not name.startswith("lights"):
        return seeds
    of_light, _, of_part = name.partition(".")
    bit = 2.0 ** (FIRST_LIGHT_BIT + _place(of_light)[1])
    return _seeded(seeds, *_place(of_part), where(light.bit == bit, 1.0, 0.0))


def _sloped_group(group: Any) -> Any:
    """Return a group as the differentiating machine around its own one has it."""
    want, by = group.want, group.want.by
    ((_, style),) = want.lights
    scene = with_slopes(group.scene, [_seeds(group.scene, name, style) for name in by])
    machine = Differentiating(group.machine, len(by), lambda light: [_light_seeds(light, name) for name in by])
    half = image_extent(scene.eye, scene.radius)  # image points move with it
    stretch = Sloped(1.0, (half / half.value).slopes)
    x, y = (Sloped(at, (stretch * at).slopes) for at in (group.pixels.x, group.pixels.y))
    return want.shader.group(machine, scene, want, Pixels(machine, group.pixels, x, y))
