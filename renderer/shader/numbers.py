"""The numbers that the shader reads: of the scene, of each light, and boxes of the image in which each thing lies."""

import math
from collections.abc import Callable, Iterable
from functools import lru_cache
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np

from renderer.kernels import HEIGHT_EVALUATIONS, LIGHT_MODELS, ambient_term, floor_albedo, silhouette_of_a
from renderer.machines.forms import Shader, flat
from renderer.scene.bounds import EVERYWHERE, Box, ball_box, shadow_boxes
from renderer.scene.methods import GradientMethod, exact
from renderer.scene.scene import Light, Scene, geometry_of
from renderer.shader.gradients import algebraic_powers, uses_algebraic_form
from renderer.shader.shader import FLOOR, NOTHING, PLANES, WORK, Group

FIRST_LIGHT_BIT = 2
AS_GIVEN = ("eye", "radius", "ku", "kv", "beta", "kd", "ks", "albedo_a", "albedo_b")
SHADOWS = ("a_on_floor", "b_on_floor", "b_on_a", "a_on_b")  # of which body on which surface, as `shadow_boxes` has them


def read_only(*arrays: np.ndarray) -> None:
    """Let nobody write any more through arrays that several frames read."""
    for array in arrays:
        array.flags.writeable = False


@lru_cache(maxsize=64)
def reach_of_a(eye: float, radius: float) -> float:
    """Return the largest float64 X for which √X is at most ρ_s: a ray meets A exactly if x² + y² ≤ X.

    The discriminant has the sign of ρ_s − ρ, ρ = √(x² + y²), and a rounded root is monotone. Theorem: hit_of_a.
    """
    silhouette = float(silhouette_of_a(np.float64(eye), np.float64(radius)))
    reach = silhouette * silhouette
    while math.sqrt(reach) > silhouette:
        reach = math.nextafter(reach, 0.0)
    while math.sqrt(math.nextafter(reach, math.inf)) <= silhouette:
        reach = math.nextafter(reach, math.inf)
    return reach


def way_of(scene: Scene, method: GradientMethod) -> tuple[Any, str]:
    """Return (field, way): how the gradient of a scene is taken by a method; not at all where there is no bump."""
    algebraic = method.name == "exact" and uses_algebraic_form(scene, method)
    way = "algebraic" if algebraic else "general" if method.name == "exact" else method.name
    return scene.field, "flat" if scene.beta == 0.0 else way


def style_of(scene: Scene) -> tuple[Any, str]:
    """Return (model, style): how light is taken; by the squared base, if there is one and the shininess is not odd."""
    squared = LIGHT_MODELS[scene.model][1] is not None and scene.shininess % 2.0 != 1.0
    return scene.model, "diffuse" if scene.ks == 0.0 else "squared" if squared else "base"


class Want(NamedTuple):
    """The choice of the code that draws: the scene's numbers are its arguments.

    ways: (field, way to its gradient) pairs, of which `scene.way` is the index of one; a way is algebraic, general, a
    difference, or flat. lights: (model, style) pairs, of which `scene.model` is the index; a style is diffuse (with no
    highlight), base, or squared. integer_power: whether the shininess is a whole number. chambers_known: whether
    the chambers are there to be loaded. surfaces: all, a (drawn over what is there) or elsewhere. colors: whether these
    are wanted. bumps: those of which `scene.bump` is the index of one. horizon: whether a light from behind the surface
    itself adds nothing. stored: which of ON_A and of CHART are. charted: whether ANGLES and CHART are known. bounds:
    whether each colour's bound is stored, and where a chamber is open (`renderer.machines.enclosing_machine`).
    """

    ways: tuple
    lights: tuple
    integer_power: bool = True
    chambers_known: bool = False
    surfaces: str = "all"
    colors: bool = True
    stored: tuple = ()
    charted: bool = False
    bounds: bool = False
    bumps: tuple = ("chart",)
    horizon: bool = False

    @property
    def shader(self) -> Shader:
        """The shader that draws it."""
        return SHADER

    @property
    def is_long(self) -> bool:
        """True if a difference's heights or a power make a long chain of operations, each of which awaits another."""
        return not self.integer_power or any(way in HEIGHT_EVALUATIONS for _, way in self.ways)


def want_of(scene: Scene, method: GradientMethod, **more: Any) -> Want:
    """Return the Want of a scene's picture by a method."""
    scenes = {"bumps": (scene.bump,), "horizon": scene.horizon}
    return Want((way_of(scene, method),), (style_of(scene),), scene.shininess.is_integer(), **scenes, **more)


def scene_numbers(scene: Scene, method: GradientMethod, number: Callable = np.float64) -> SimpleNamespace:
    """Return the numbers of a scene and a gradient method, by name. Boxes are (left, right, low, high).

    number: the class of the scene's numbers where others are computed from them.
    """
    geometry = geometry_of(scene)
    (_, way), (_, style) = way_of(scene, method), style_of(scene)
    power_u, power_v = (algebraic_powers(scene) if way == "algebraic" else None) or (0, 0)
    light, dark = (floor_albedo(number(dark), number(scene.floor_tint)) for dark in (0.0, 1.0))
    return SimpleNamespace(
        **{name: getattr(scene, name) for name in AS_GIVEN},
        ball=geometry.ball,  # centre and radius of B
        ball_on=geometry.ball_on,
        floor_on=geometry.floor_on,
        ground=FLOOR if scene.floor else NOTHING,  # the surface where there is no sphere
        reach_of_a=reach_of_a(scene.eye, scene.radius),  # the largest x² + y² at which A is met
        box_of_b=ball_box(geometry),
        way=0.0,  # which of those that a Want has
        model=0.0,
        bump=0.0,
        eps=method.eps or 0.0,
        power_u=float(abs(power_u)),  # whole powers of the algebraic form,
        power_v=float(abs(power_v)),
        turn_u=-1.0 if power_u < 0 else 1.0,  # and the sign that negative ones give to imaginary parts
        turn_v=-1.0 if power_v < 0 else 1.0,
        power=scene.shininess / 2 if style == "squared" else scene.shininess,  # of the highlight's base, or its square
        ambient=tuple(ambient_term(number(scene.ka), channel) for channel in scene.ambient),
        floor_light=light,  # red and green; blue
        floor_dark=dark,
    )


def light_numbers(number: int, light: Light, boxes: Iterable[Box]) -> SimpleNamespace:
    """Return the numbers of a light that is on, by name; the boxes are where a body's shadow on a surface can be."""
    bit = float(1 << (FIRST_LIGHT_BIT + number))
    return SimpleNamespace(
        position=light.position,
        color=light.color,
        glows=float(any(light.color or ())),  # 0 for a black light, which casts shadows and adds nothing
        bit=bit,  # of the chamber code
        inverse_bit=1 / bit,
        **dict(zip(SHADOWS, boxes, strict=True)),
    )


SCENE_FORM = scene_numbers(Scene(), exact())
LIGHT_FORM = light_numbers(0, Light((0.0, 0.0, 0.0)), (EVERYWHERE * 2,) * 4)
ROUNDED = ("reach_of_a", "ambient", "floor_light", "floor_dark")  # of a scene's numbers; the others are exact
SHADER = Shader(Group, SCENE_FORM, LIGHT_FORM, ROUNDED, WORK, PLANES)


@lru_cache(maxsize=64)
def numbers_of(scene: Scene, method: GradientMethod) -> tuple[np.ndarray, np.ndarray]:
    """Return (the scene's numbers, those of the lights that are on (n, …)), float64 arrays."""
    geometry = geometry_of(scene)
    lights = [
        flat(light_numbers(number, light, shadow_boxes(geometry, light.position)))
        for number, light in enumerate(scene.lights)
        if light.color is not None
    ]
    numbers = np.array(flat(scene_numbers(scene, method))), np.array(lights).reshape(-1, len(flat(LIGHT_FORM)))
    read_only(*numbers)
    return numbers
