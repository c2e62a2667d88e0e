"""Slopes of a picture by numbers of its scene: the numbers' names, and where the slopes begin."""

from collections.abc import Iterable
from dataclasses import replace
from itertools import product, repeat
from typing import Any

from renderer.checks import check_items, not_allowed
from renderer.kernels import image_extent
from renderer.machines.bounded import plus
from renderer.machines.differentiating import Sloped, sloped
from renderer.machines.differentiating_machine import Differentiating, Pixels, with_slopes
from renderer.machines.forms import of_form, path_of, with_part
from renderer.operations import where
from renderer.scene.fields import field_kernels, parameters
from renderer.scene.methods import exact
from renderer.scene.scene import NUMBERS
from renderer.shader.numbers import FIRST_LIGHT_BIT, Shot
from renderer.shader.shader import Group, difference

PLACES = {"ball_center": ["ball"], "ball_radius": ["ball", "3"], "shininess": ["power"]}
"""{name of a scene's number: where the shader has it}, but for those that it has by the same name."""


def asked(shot: Shot, names: Iterable[str]) -> tuple[Shot, dict[str, Any]]:
    """Return the shot that has slopes by numbers of its scene, and the parts of its Want that they change.

    A slope may need the gradient or the highlight where the picture needs neither. Raises ValueError on a number
    without a slope.
    """
    scene, names = shot.scene, check_items("derivatives", names, f"a list of {NUMBERS}")
    on: dict[str, Any] = {"ball_": scene.ball, "albedo_b": scene.ball, "floor_tint": scene.floor}
    on |= {f"lights[{number}]": light.color for number, light in enumerate(scene.lights)}
    for name, (front, is_on) in product(names, on.items()):
        if not is_on and str(name).startswith(front):
            raise not_allowed("derivatives", name, "no number of a body or a light that is off in this scene")
    custom: Any = scene.field
    for name in names:
        scene.number(name, "derivatives")
        if name in parameters(custom):
            custom.by(name)
    method = shot.method.name
    if method == "exact" and {"ku", "kv"} & set(names):
        if shot.method.form == "algebraic":
            raise not_allowed("form", "algebraic", "general or auto beside a slope by ku or kv: whole powers have none")
        shot = replace(shot, method=exact("general"))
    ((field, way),), ((model, style),) = shot.want.ways, shot.want.lights
    if way == "flat" and shot.scene.beta:  # of a bump that is not seen, and may be by one of these
        seen_by = any(name in ("ku", "kv", "kd", "ks", *parameters(field)) or "color" in name for name in names)
        way = shot.way if seen_by else way
    elif way == "flat" and "beta" in names:
        way = "general" if method == "exact" else method
    if style == "diffuse" and "ks" in names:
        style = "base"
    changes = {"by": tuple(dict.fromkeys(names)), "around": sloped_group}
    return shot, changes | {"ways": ((field, way),), "lights": ((model, style),)}


def _seeds(numbers, name, style):
    """Return the slopes of the shader's numbers by one of the scene's, in their form."""
    seeds, (first, *rest) = of_form(numbers, repeat(0.0)), path_of(name)
    match first:
        case "lights":
            return seeds
        case "ka":
            return with_part(seeds, ["ambient"], numbers.ambient_light)
        case "floor_tint":  # red and green are (1 − tint) times blue
            for floor in ("floor_light", "floor_dark"):
                seeds = with_part(seeds, [floor, "0"], -getattr(numbers, floor)[1])
            return seeds
    slope = numbers.ka if first == "ambient" else 0.5 if (first, style) == ("shininess", "squared") else 1.0
    return with_part(seeds, [*PLACES.get(first, [first]), *rest], slope)


def _light_seeds(light, name):
    """Return the slopes of a light's numbers by one of the scene's numbers, in their form.

    The loop over lights is traced once for all of them, so a light is recognised by its bit.
    """
    seeds, (first, *rest) = of_form(light, repeat(0.0)), path_of(name)
    if first != "lights":
        return seeds
    number, *place = rest
    return with_part(seeds, place, where(light.bit == 2.0 ** (FIRST_LIGHT_BIT + int(number)), 1.0, 0.0))


def sloped_group(group: Any) -> Any:
    """Return a group that draws the same pixels with slopes, on a differentiating machine around the group's own."""
    want, by = group.want, group.want.by
    style = want.lights[0][1]
    seeded = ("lights" if name in parameters(want.ways[0][0]) else name for name in by)  # which no scene's number is
    scene = with_slopes(group.scene, [_seeds(group.scene, name, style) for name in seeded])
    machine = Differentiating(group.machine, len(by), lambda light: [_light_seeds(light, name) for name in by])
    half = image_extent(scene.eye, scene.radius)  # image points move with it
    stretch = Sloped(1.0, (half / half.value).slopes)
    x, y = (Sloped(at, (stretch * at).slopes) for at in (group.pixels.x, group.pixels.y))
    return _Sloped(machine, scene, want, Pixels(machine, group.pixels, x, y))


class _Sloped(Group):
    """A group whose gradient has slopes by a custom field's parameters too."""

    def gradient(self, angles: Any, mask: Any) -> Any:
        gradient, (field, way) = super().gradient(angles, mask), self.want.ways[0]  # of a custom field the one
        for place, name in enumerate(self.want.by if way != "flat" else ()):
            if name in parameters(field):
                kernels, s = field_kernels(field.by(name)), self.scene
                here = [number.value for number in map(sloped, (*self.chart(angles), s.ku, s.kv, s.eps))]
                exact_way = way in ("general", "algebraic")
                moved = kernels["gradient"](*here[:4]) if exact_way else difference(kernels, way, *here)
                parts = [[*self.machine.parts(part)] for part in gradient]
                for part, slope in zip(parts, moved, strict=True):
                    part[1 + place] = plus(part[1 + place], slope)
                gradient = [Sloped(value, tuple(slopes)) for value, *slopes in parts]
        return gradient
