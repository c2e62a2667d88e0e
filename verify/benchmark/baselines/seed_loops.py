"""The seed chapter's renderer as it is meant: pixel by pixel in Python, short NumPy vectors, both pipelines.

The method is the seed's, the text is not. Mended where it draws another scene than it says: B's quadratic (F1), and
u = 1, which is u = 0. Its frame by √(1 − N_z²) and its v by acos stay: they lose digits at the pole alone.
"""

import math
from collections.abc import Callable, Sequence
from functools import partial

import numpy as np

from renderer import Scene

Ball = tuple[np.ndarray, float]  # centre and radius
NOTHING, SPHERE_A, SPHERE_B, FLOOR = 0, 1, 2, 3
HEIGHTS: dict[str, Callable] = {
    "sine": lambda scene, u, v: math.sin(math.pi * scene.ku * u) * math.sin(math.pi * scene.kv * v),
    "ridges": lambda scene, u, v: abs(HEIGHTS["sine"](scene, u, v)),
    "rings": lambda scene, u, v: math.sin(2 * math.pi * scene.kv * v),
}
"""{field: (scene, u, v) → h}: the seed's, and no others"""


def height_of_field(scene: Scene, u: float, v: float) -> float:
    """Return h(u, v)."""
    return HEIGHTS[str(scene.field)](scene, u, v)


def central_gradient(scene: Scene, u: float, v: float, eps: float) -> tuple[float, float]:
    """Return (h_u, h_v) by central differences of step eps: u wraps, v is clamped and divides by what is left."""
    upper, lower = min(1.0, v + eps), max(0.0, v - eps)
    span = 2 * eps if v + eps <= 1.0 and v - eps >= 0.0 else upper - lower
    along_u = height_of_field(scene, (u + eps) % 1.0, v) - height_of_field(scene, (u - eps) % 1.0, v)
    along_v = height_of_field(scene, u, upper) - height_of_field(scene, u, lower)
    return along_u / (2 * eps), along_v / span


def _slopes_of_sine(scene, u, v, sign=lambda product: 1.0):
    a, b = math.pi * scene.ku, math.pi * scene.kv
    sin_u, sin_v = math.sin(a * u), math.sin(b * v)
    side = float(sign(sin_u * sin_v))
    return a * math.cos(a * u) * sin_v * side, b * sin_u * math.cos(b * v) * side


SLOPES: dict[str, Callable] = {
    "sine": _slopes_of_sine,
    "ridges": partial(_slopes_of_sine, sign=np.sign),
    "rings": lambda scene, u, v: (0.0, 2 * math.pi * scene.kv * math.cos(2 * math.pi * scene.kv * v)),
}


def exact_gradient(scene: Scene, u: float, v: float) -> tuple[float, float]:
    """Return (h_u, h_v) by the derivative; on a crease the sign of zero is zero."""
    return SLOPES[str(scene.field)](scene, u, v)


def bumped(scene: Scene, normal: np.ndarray, gradient: Callable) -> np.ndarray:
    """Return the perturbed normal of sphere A: chart point, gradient, frame, and N + βg at length 1."""
    n_x, n_y, n_z = normal
    u = (math.atan2(n_y, n_x) + math.pi) / (2 * math.pi)
    v = math.acos(min(1.0, max(-1.0, n_z))) / math.pi
    h_u, h_v = gradient(scene, u if u < 1.0 else 0.0, v)
    sin_phi = math.sqrt(max(0.0, 1.0 - n_z * n_z))
    e_theta = np.array([-n_y / sin_phi, n_x / sin_phi, 0.0])
    e_phi = np.array([n_z * n_x / sin_phi, n_z * n_y / sin_phi, -sin_phi])
    m = normal + scene.beta * (h_u * e_theta + h_v * e_phi)
    return _unit(m)


def nearest_hit(scene: Scene, center: np.ndarray, x: float, y: float) -> tuple[int, float]:
    """Return (surface, t) of the first surface along the ray (tx, ty, e − te)."""
    e, squared = scene.eye, x * x + y * y + scene.eye**2
    best, t = (FLOOR, 1.0) if scene.floor else (NOTHING, math.inf)
    if scene.ball:
        toward = center[0] * x + center[1] * y + (e - center[2]) * e
        beyond = center[0] ** 2 + center[1] ** 2 + (e - center[2]) ** 2 - scene.ball_radius**2
        under = toward * toward - squared * beyond
        if under >= 0 and 0 < (near := (toward - math.sqrt(under)) / squared) <= t:
            best, t = SPHERE_B, near
    under = (e * scene.radius) ** 2 - (e * e - scene.radius**2) * (x * x + y * y)
    if under >= 0 and (near := (e * e - math.sqrt(under)) / squared) <= t:
        best, t = SPHERE_A, near
    return best, t


def is_shadowed(point: np.ndarray, light: np.ndarray, center: np.ndarray, radius: float) -> bool:
    """Return whether a sphere stands between the point and the light: a root of its quadratic in (0, 1)."""
    segment, offset = light - point, point - center
    a, b, c = float(segment @ segment), float(offset @ segment), float(offset @ offset) - radius * radius
    under = b * b - a * c
    if under < 0:
        return False
    root = math.sqrt(under)
    return 0 < (-b - root) / a < 1 or 0 < (-b + root) / a < 1


def _unit(vector):
    return vector / np.linalg.norm(vector)


BASES = {
    "blinn": lambda normal, towards, view: normal @ _unit(towards + view),
    "phong": lambda normal, towards, view: (2.0 * float(normal @ towards) * normal - towards) @ view,
}
"""{model: (N', ω, v̂) → the base of the highlight}"""


def shaded(
    scene: Scene, point: np.ndarray, normal: np.ndarray, view: np.ndarray, albedo: np.ndarray, blockers: Sequence[Ball]
) -> np.ndarray:
    """Return the colour, linear RGB, not yet clipped."""
    color = scene.ka * np.array(scene.ambient)
    for light in scene.lights:
        if light.color is None:
            continue
        position = np.array(light.position)
        if any(is_shadowed(point, position, center, radius) for center, radius in blockers):
            continue
        towards = _unit(position - point)
        mu = float(normal @ towards)
        specular = max(0.0, float(BASES[str(scene.model)](normal, towards, view))) ** scene.shininess
        color += np.array(light.color) * (scene.kd * albedo * max(0.0, mu) + scene.ks * specular)
    return color


def surface_at(
    scene: Scene, surface: int, point: np.ndarray, center: np.ndarray, gradient: Callable
) -> tuple[np.ndarray, np.ndarray, list[Ball]]:
    """Return (shading normal, albedo, the spheres that can shadow it) of a point of a surface."""
    body_a, body_b = (np.zeros(3), scene.radius), (center, scene.ball_radius)
    others = [body_b] if scene.ball else []
    if surface == SPHERE_A:
        return bumped(scene, point / scene.radius, gradient), np.array(scene.albedo_a), others
    if surface == SPHERE_B:
        return (point - center) / scene.ball_radius, np.array(scene.albedo_b), [body_a]
    light_square = math.sin(math.pi * point[0]) * math.sin(math.pi * point[1]) >= 0
    base = 0.85 if light_square else 0.15
    dimmed = base * (1 - scene.floor_tint)
    return np.array([0.0, 0.0, 1.0]), np.array([dimmed, dimmed, base]), [body_a, *others]


def seed_loops(scene: Scene, width: int, height: int, eps: float | None = None) -> tuple[np.ndarray, np.ndarray]:
    """Return (rgb (height, width, 3) in [0, 1], surface (height, width)): the exact pipeline, or of step eps."""
    gradient = exact_gradient if eps is None else partial(central_gradient, eps=eps)
    rgb, surfaces = np.zeros((height, width, 3)), np.zeros((height, width), np.uint8)
    half = 1.25 * scene.eye * scene.radius / math.sqrt(scene.eye**2 - scene.radius**2)
    eye, center = np.array([0.0, 0.0, scene.eye]), np.array(scene.ball_center)
    for row in range(height):
        y = half * (1 - 2 * (row + 0.5) / height) - 0.15 * half
        for column in range(width):
            x = half * (2 * (column + 0.5) - width) / height
            surface, t = nearest_hit(scene, center, x, y)
            if surface == NOTHING:
                continue
            point = np.array([t * x, t * y, scene.eye * (1 - t)])
            normal, albedo, blockers = surface_at(scene, surface, point, center, gradient)
            view = _unit(eye - point)
            rgb[row, column] = shaded(scene, point, normal, view, albedo, blockers)
            surfaces[row, column] = surface
    return np.clip(rgb, 0, 1), surfaces
