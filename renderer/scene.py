"""What is drawn: the scene and its lights, checked when they are made."""

import math
from dataclasses import dataclass, field

from renderer.kernels import FIELDS, LIGHT_MODELS

MODELS = tuple(LIGHT_MODELS)
MAX_LIGHTS = 5
MAX_WAVE_NUMBER = 2.0**20


def _reject(name, value, allowed):
    raise ValueError(f"{name} = {value!r} is not allowed: {allowed}")


def check_number(name, value, low=-math.inf, high=math.inf, allowed=None):
    """Return `value` as a float, or raise ValueError unless it is a finite number in [low, high]."""
    allowed = allowed or f"a finite number from {low:g} to {high:g}"
    if isinstance(value, (str, bytes, bool)):
        _reject(name, value, allowed)
    try:
        number = float(value)
    except (TypeError, ValueError, OverflowError):
        _reject(name, value, allowed)
    if not math.isfinite(number) or not low <= number <= high:
        _reject(name, value, allowed)
    return number


def check_triple(name, value, low=-math.inf, high=math.inf):
    """Return `value` as a tuple of three floats, or raise ValueError."""
    allowed = f"three finite numbers from {low:g} to {high:g}"
    if isinstance(value, (str, bytes)):
        _reject(name, value, allowed)
    try:
        items = tuple(value)
    except TypeError:
        _reject(name, value, allowed)
    if len(items) != 3:
        _reject(name, value, allowed)
    return tuple(check_number(f"{name}[{i}]", item, low, high) for i, item in enumerate(items))


def check_choice(name, value, choices):
    """Return `value`, or raise ValueError unless it is one of `choices`."""
    if value not in tuple(choices):
        _reject(name, value, "one of " + ", ".join(map(repr, choices)))
    return value


@dataclass(frozen=True)
class Light:
    """A point light: position (world units), linear RGB colour (channels in [0, 1e6]); None is a light that is off."""

    position: tuple
    color: tuple | None = (1.0, 1.0, 1.0)

    def __post_init__(self):
        object.__setattr__(self, "position", check_triple("light.position", self.position))
        if self.color is not None:
            object.__setattr__(self, "color", check_triple("light.color", self.color, 0.0, 1e6))


DEFAULT_LIGHTS = (Light((5.0, 5.0, 10.0)), Light((-6.0, 2.0, 8.0), (0.9, 0.65, 0.25)))


@dataclass(frozen=True)
class Scene:
    """Sphere A (the bumped one, at the origin), sphere B, the floor z = 0, the eye (0, 0, eye), up to five lights.

    Lengths are in world units, colours linear RGB. Defaults are the chapter's. Raises ValueError that names the
    field, its value and what is allowed: 1e-6 ≤ radius/eye ≤ 1 − 1e-9; every other length at most 1e9 radii (and
    B's radius at least 1e-9 of one); B clear of the eye; no light inside a sphere or within 1e-9 of a surface.
    """

    radius: float = 1.0
    eye: float = 4.0
    ball: bool = True
    ball_center: tuple = (0.5, 0.5, 1.3)
    ball_radius: float = 0.32
    floor: bool = True
    lights: tuple = field(default=DEFAULT_LIGHTS)
    ambient: tuple = (0.15, 0.15, 0.16)
    albedo_a: tuple = (0.63, 0.19, 0.16)
    albedo_b: tuple = (0.33, 0.44, 0.62)
    ka: float = 0.1
    kd: float = 0.7
    ks: float = 0.5
    shininess: float = 32.0
    model: str = "blinn"
    floor_tint: float = 0.25
    field: str = "ridges"
    ku: float = 8.0
    kv: float = 4.0
    beta: float = 0.35

    def __post_init__(self):
        for name, value in self._checked().items():
            object.__setattr__(self, name, value)
        self._check_lengths()

    def _checked(self):
        """Return every field's value, checked one by one and converted."""
        numbers = {
            "radius": (1e-60, 1e60),
            "ka": (0.0, 1e6),
            "kd": (0.0, 1e6),
            "ks": (0.0, 1e6),
            "shininess": (1e-3, 1e6),
            "floor_tint": (0.0, 1.0),
            "ku": (-MAX_WAVE_NUMBER, MAX_WAVE_NUMBER),
            "kv": (-MAX_WAVE_NUMBER, MAX_WAVE_NUMBER),
            "beta": (-1e100, 1e100),
        }
        checked = {name: check_number(name, getattr(self, name), *limits) for name, limits in numbers.items()}
        checked |= {name: check_number(name, getattr(self, name)) for name in ("eye", "ball_radius")}
        for name, high in (("ball_center", math.inf), ("ambient", 1e6), ("albedo_a", 1.0), ("albedo_b", 1.0)):
            checked[name] = check_triple(name, getattr(self, name), -math.inf if high == math.inf else 0.0, high)
        for name in ("ball", "floor"):
            checked[name] = bool(check_choice(name, getattr(self, name), (True, False)))
        checked["field"] = check_choice("field", self.field, FIELDS)
        checked["model"] = check_choice("model", self.model, MODELS)
        checked["lights"] = self._checked_lights()
        return checked

    def _checked_lights(self):
        allowed = f"a sequence of at most {MAX_LIGHTS} Light"
        try:
            lights = tuple(self.lights)
        except TypeError:
            _reject("lights", self.lights, allowed)
        if not all(isinstance(light, Light) for light in lights):
            _reject("lights", self.lights, allowed)
        if len(lights) > MAX_LIGHTS:
            raise ValueError(f"lights = {len(lights)} lights is not allowed: {allowed}")
        return lights

    def _check_lengths(self):
        ratio = self.radius / self.eye if self.eye else math.inf
        if not 1e-6 <= ratio <= 1 - 1e-9:
            _reject("eye", self.eye, f"radius/eye from 1e-6 to 1 - 1e-9, and radius = {self.radius:g}")
        far = 1e9 * self.radius
        if self.ball:
            check_number("ball_radius", self.ball_radius, 1e-9 * self.radius, far)
            check_triple("ball_center", self.ball_center, -far, far)
            x, y, z = self.ball_center
            if math.hypot(x, y, z - self.eye) <= self.ball_radius * (1 + 1e-9):
                _reject("ball_center", self.ball_center, "B clear of the eye")
        for number, light in enumerate(self.lights):
            self._check_light(f"lights[{number}].position", light.position, far)

    def _check_light(self, name, position, far):
        check_triple(name, position, -far, far)
        if math.hypot(*position) <= self.radius * (1 + 1e-9):
            _reject(name, position, "outside sphere A")
        if self.ball and math.dist(position, self.ball_center) <= self.ball_radius * (1 + 1e-9):
            _reject(name, position, "outside sphere B")
        if self.floor and abs(position[2]) <= 1e-9 * self.radius:
            _reject(name, position, "off the floor z = 0 by more than 1e-9 radius")
