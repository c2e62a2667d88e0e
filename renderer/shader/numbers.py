"""The shot, made once of a scene, and the numbers that the shader reads: of scene and lights, and of bodies' boxes."""

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, fields
from functools import cache, lru_cache
from operator import attrgetter
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np

from renderer.checks import check_kind, check_whole
from renderer.kernels import HEIGHT_EVALUATIONS, LIGHT_MODELS, ambient_term, floor_albedo, silhouette_of_a
from renderer.machines.forms import COLORS, Shader, flat
from renderer.scene.bounds import EVERYWHERE, Box, ball_box, shadow_boxes
from renderer.scene.fields import field_kernels
from renderer.scene.methods import GradientMethod, checked_method, exact
from renderer.scene.raster import MAX_SIDE, Raster
from renderer.scene.scene import MOVE_NO_BOUNDARY, Light, Scene, geometry_of
from renderer.shader.gradients import algebraic_powers
from renderer.shader.shader import FLOOR, NOTHING, PLANES, WORK, Group

EXACT, PIXEL = exact(), Raster(1, 1)
MOST_SAMPLES = 16
FIRST_LIGHT_BIT = 2
AS_GIVEN = ("eye", "radius", "ku", "kv", "beta", "ka", "kd", "ks", "albedo_a", "albedo_b")
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


@cache
def slope_planes(count: int, bounds: bool) -> tuple[str, ...]:
    """Return the names of the planes of so many slopes, and then of their bounds."""
    ends = ("", "_bound") if bounds else ("",)
    return tuple(f"{color}_slope_{number}{end}" for end in ends for number in range(count) for color in COLORS)


class Want(NamedTuple):
    """The choice of the code that draws: the scene's numbers are its arguments.

    ways: (field, way to its gradient) pairs, of which `scene.way` is the index of one; a way is algebraic, general, a
    difference, flat, or stored: h_u and h_v are loaded. lights: (model, style) pairs, of which `scene.model` is the
    index; a style is diffuse (with no highlight), base, or squared. integer_power: whether the shininess is a whole
    number. chambers_known: whether the chambers are there to be loaded. surfaces: all, a (drawn over what is there)
    or elsewhere. colors: whether these are wanted. bumps: those of which `scene.bump` is the index of one. horizon:
    whether a light from behind the surface itself adds nothing. stored: which of ON_A and of CHART are. charted:
    whether ANGLES and CHART are known. bounds: whether each colour's bound is stored, and where a chamber is open
    (`renderer.machines.enclosing_machine`). by: the names of numbers by which each colour's slopes are stored, and
    around: the group that has these (`renderer.shader.slopes`).
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
    by: tuple = ()
    around: Any = None

    @property
    def shader(self) -> Shader:
        """The shader that draws it."""
        planes = (*PLANES, *slope_planes(len(self.by), self.bounds))
        return SHADER._replace(planes=planes, around=self.around) if self.by else SHADER

    @property
    def by_color(self) -> bool:
        """True if a light that adds nothing is to be looked at all the same."""
        return any("color" in name or name in ("kd", "ks") for name in self.by)

    @property
    def is_long(self) -> bool:
        """True if a difference's heights or a power make a long chain of operations, each of which awaits another."""
        return not self.integer_power or any(way in HEIGHT_EVALUATIONS for _, way in self.ways)


_shading = attrgetter(*(field.name for field in fields(Scene) if field.name not in MOVE_NO_BOUNDARY))


@dataclass(unsafe_hash=True)  # nobody changes one
class Shot:
    """A scene, the method of its gradient and a raster, and what drawing reads of these, made here once.

    By default the exact gradient, and one pixel. samples: each way across a pixel. Raises ValueError on what is none.

    geometry: the part of the scene on which chambers depend. shading: the fields on which the colours off A depend.
    powers: of the algebraic form of the gradient, or None. way: to the gradient: algebraic, general, or a difference.
    glows: whether light is scattered; without it no normal is seen. want: the Want of the picture, drawn from nothing;
    without a bump that is seen, without a gradient. numbers: (the scene's, those of the lights that are on (n, …)),
    float64 arrays.
    """

    scene: Scene
    method: GradientMethod = EXACT
    raster: Raster = PIXEL
    samples: int = 1

    def __post_init__(self):
        method, scene = checked_method("gradient", self.method), check_kind("scene", self.scene, Scene)
        most = min(MOST_SAMPLES, MAX_SIDE // max(self.raster.width, self.raster.height))
        self.samples = check_whole("samples", self.samples, most)
        self.geometry, self.shading = geometry_of(scene), _shading(scene)
        self.powers = algebraic_powers(scene, method)
        self.way = "algebraic" if self.powers else "general" if method.name == "exact" else method.name
        self.glows = (scene.kd > 0.0 or scene.ks > 0.0) and any(any(each.color or ()) for each in scene.lights)
        wave_numbers = {"k_u": scene.ku, "k_v": scene.kv}
        level = any(wave_numbers[name] == 0.0 for name in field_kernels(scene.field)["level_without"])
        way = "flat" if level or scene.beta == 0.0 or not self.glows else self.way
        squared = LIGHT_MODELS[scene.model][1] is not None and scene.shininess % 2.0 != 1.0
        style = "diffuse" if scene.ks == 0.0 else "squared" if squared else "base"
        choices = ((scene.field, way),), ((scene.model, style),), scene.shininess.is_integer()
        self.want = Want(*choices, bumps=(scene.bump,), horizon=scene.horizon)
        lights = [
            flat(light_numbers(number, light, boxes, self.glows))
            for number, (light, boxes) in enumerate(zip(scene.lights, shadow_boxes(self.geometry), strict=True))
            if light.color is not None
        ]
        self.numbers = np.array(flat(scene_numbers(self))), np.array(lights).reshape(-1, len(flat(LIGHT_FORM)))


def scene_numbers(shot: Shot, number: Callable = np.float64) -> SimpleNamespace:
    """Return the numbers of a shot's scene and method, by name. Boxes are (left, right, low, high).

    number: the class of the scene's numbers where others are computed from them.
    """
    scene, geometry = shot.scene, shot.geometry
    ((_, style),), (power_u, power_v) = shot.want.lights, shot.powers or (0, 0)
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
        eps=shot.method.eps or 0.0,
        power_u=float(abs(power_u)),  # whole powers of the algebraic form,
        power_v=float(abs(power_v)),
        turn_u=-1.0 if power_u < 0 else 1.0,  # and the sign that negative ones give to imaginary parts
        turn_v=-1.0 if power_v < 0 else 1.0,
        power=scene.shininess / 2 if style == "squared" else scene.shininess,  # of the highlight's base, or its square
        ambient_light=scene.ambient,
        ambient=tuple(ambient_term(number(scene.ka), channel) for channel in scene.ambient),
        floor_light=light,  # red and green; blue
        floor_dark=dark,
    )


def light_numbers(number: int, light: Light, boxes: Iterable[Box], glows: bool = True) -> SimpleNamespace:
    """Return the numbers of a light that is on, by name; the boxes are where a body's shadow on a surface can be.

    glows: whether anything scatters light.
    """
    bit = float(1 << (FIRST_LIGHT_BIT + number))
    return SimpleNamespace(
        position=light.position,
        color=light.color,
        glows=float(glows and any(light.color or ())),  # 0 for a black light, which casts shadows and adds nothing
        bit=bit,  # of the chamber code
        inverse_bit=1 / bit,
        **dict(zip(SHADOWS, boxes, strict=True)),
    )


LIGHT_FORM = light_numbers(0, Light((0.0, 0.0, 0.0)), (EVERYWHERE * 2,) * 4)
SCENE_FORM = scene_numbers(Shot(Scene()))
ROUNDED = ("reach_of_a", "ambient", "floor_light", "floor_dark")  # of a scene's numbers; the others are exact
SHADER = Shader(Group, SCENE_FORM, LIGHT_FORM, ROUNDED, WORK, PLANES)
