"""The numbers that the shader is given: of the scene, of each light, and where on the image each thing can be."""

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from renderer.bounds import ball_box, shadow_boxes
from renderer.gradients import algebraic_powers, uses_algebraic_form
from renderer.kernels import FIELDS, LIGHT_MODELS, ambient_term, floor_albedo, silhouette_of_a
from renderer.shader import FLOOR, NOTHING, Want

FIRST_LIGHT_BIT = 2


class SceneNumbers(NamedTuple):
    """A scene and a gradient method. Boxes are (left, right, low, high) in image points."""

    eye: float
    radius: float
    ball: tuple  # centre and radius of B
    ball_on: float
    floor_on: float
    ground: float  # the surface that is seen where there is no sphere
    reach_of_a: float  # the largest x² + y² at which A is met
    box_of_b: tuple
    way: float
    model: float
    ku: float
    kv: float
    beta: float
    eps: float
    power_u: float  # whole powers of the algebraic form, not negative, and what the imaginary parts are turned by
    power_v: float
    turn_u: float
    turn_v: float
    kd: float
    ks: float
    shininess: float
    power: float  # the whole power of the highlight's base, or of its square
    ambient: tuple
    albedo_a: tuple
    albedo_b: tuple
    floor_light: tuple  # red and green; blue
    floor_dark: tuple


class LightNumbers(NamedTuple):
    """A light that is on; the boxes are where a body's shadow on a surface can be."""

    position: tuple
    color: tuple
    glows: float  # 0 for a black light, which casts shadows and adds nothing
    bit: float  # of the chamber code
    inverse_bit: float
    a_on_floor: tuple
    b_on_floor: tuple
    b_on_a: tuple
    a_on_b: tuple


class Geometry(NamedTuple):
    """What the chambers depend on, beside the raster: lengths, and the lights' positions, None for one that is off."""

    eye: float
    radius: float
    ball: tuple
    ball_on: float
    floor_on: float
    lights: tuple


SCENE_FORM = SceneNumbers(
    *(0.0,) * 2, (0.0,) * 4, *(0.0,) * 4, (0.0,) * 4, *(0.0,) * 14, *[(0.0,) * 3] * 3, *[(0.0,) * 2] * 2
)
LIGHT_FORM = LightNumbers((0.0,) * 3, (0.0,) * 3, 0.0, 0.0, 0.0, *[(0.0,) * 4] * 4)
"""Examples, which say how many numbers each field has."""


def flat(numbers):
    """Return the numbers one after another, a list."""
    return [part for field in numbers for part in (field if isinstance(field, tuple) else (field,))]


def of_form(form, values):
    """Return an iterable of values in the form of an example: the inverse of `flat`."""
    values = iter(values)
    return type(form)(*(tuple(next(values) for _ in f) if isinstance(f, tuple) else next(values) for f in form))


def geometry_of(scene):
    """Return the Geometry of a scene. An absent B is a unit ball that no kernel asks about."""
    ball = (*scene.ball_center, scene.ball_radius) if scene.ball else (0.0, 0.0, 0.0, 1.0)
    lights = tuple(None if light.color is None else light.position for light in scene.lights)
    return Geometry(scene.eye, scene.radius, ball, float(scene.ball), float(scene.floor), lights)


def reach_of_a(eye, radius):
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


@lru_cache(maxsize=64)
def places_of(geometry):
    """Return (reach of A, box of B, [boxes of each light, None for one that is off]): fixed for the chambers."""
    boxes = [None if position is None else shadow_boxes(geometry, position) for position in geometry.lights]
    return reach_of_a(geometry.eye, geometry.radius), ball_box(geometry), boxes


def way_of(scene, method):
    """Return (field, way): how the gradient of a scene is taken by a method; not at all where there is no bump."""
    algebraic = method.name == "exact" and uses_algebraic_form(scene, method)
    way = "algebraic" if algebraic else "general" if method.name == "exact" else method.name
    return scene.field, "flat" if scene.beta == 0.0 else way


def style_of(scene):
    """Return (model, style): how light is taken; from the squared base for an even shininess, where a model has it."""
    squared = LIGHT_MODELS[scene.model][1] is not None and scene.shininess % 2.0 == 0.0
    return scene.model, "dull" if scene.ks == 0.0 else "squared" if squared else "base"


def want_of(scene, method, **more):
    """Return the Want of a scene's picture by a method."""
    return Want((way_of(scene, method),), (style_of(scene),), scene.shininess.is_integer(), **more)


@lru_cache(maxsize=64)
def numbers_of(scene, method):
    """Return (the scene's numbers, those of the lights that are on (n, …)), float64 arrays."""
    geometry = geometry_of(scene)
    reach, box_of_b, boxes = places_of(geometry)
    (_, way), (_, style) = way_of(scene, method), style_of(scene)
    powers = algebraic_powers(scene) if way == "algebraic" else (0, 0)
    power = scene.shininess / 2 if style == "squared" else scene.shininess
    scene_numbers = SceneNumbers(
        *geometry[:5],
        FLOOR if scene.floor else NOTHING,
        reach,
        box_of_b,
        float(list(FIELDS).index(scene.field)),
        float(list(LIGHT_MODELS).index(scene.model)),
        scene.ku,
        scene.kv,
        scene.beta,
        method.eps or 0.0,
        *(float(abs(power)) for power in powers),
        *(-1.0 if power < 0 else 1.0 for power in powers),
        scene.kd,
        scene.ks,
        scene.shininess,
        power,
        tuple(ambient_term(scene.ka, channel) for channel in scene.ambient),
        scene.albedo_a,
        scene.albedo_b,
        *(tuple(float(part) for part in floor_albedo(dark, scene.floor_tint)) for dark in (0.0, 1.0)),
    )
    lights = []
    for number, (light, box) in enumerate(zip(scene.lights, boxes, strict=True)):
        if light.color is not None:
            bit = float(1 << (FIRST_LIGHT_BIT + number))
            lights.append(flat(LightNumbers(light.position, light.color, float(any(light.color)), bit, 1 / bit, *box)))
    return np.array(flat(scene_numbers)), np.array(lights).reshape(len(lights), len(flat(LIGHT_FORM)))
