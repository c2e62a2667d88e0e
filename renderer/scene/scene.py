"""The scene and its lights, checked when they are made."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

from renderer.checks import check_choice, check_items, check_kind, check_number, check_triple, check_truth, not_allowed
from renderer.kernels import FIELDS, LIGHT_MODELS
from renderer.machines.forms import part_of, path_of, with_part
from renderer.scene.fields import check_field, check_size, field_from_record, field_record, parameters
from renderer.scene.text import distrusted, read_toml, toml_of
from renderer.whole_files import checked_target, write_whole

if TYPE_CHECKING:
    from proofs.formulas.height_fields import HeightField

    Field: TypeAlias = str | HeightField
    Triple: TypeAlias = Sequence[float]
    Lights: TypeAlias = Sequence["Light"]
else:  # no SymPy is imported, and of a sequence a tuple is kept
    Field, Triple, Lights = Any, tuple, tuple

MODELS, BUMPS = tuple(LIGHT_MODELS), ("chart", "surface")
MOVE_NO_BOUNDARY = ("field", "ku", "kv", "beta")
"""The fields that no chamber depends on."""
NUMBERS = "names of the scene's numbers in its record, such as beta, albedo_a[0], lights[1].position[2]"
MAX_LIGHTS = 5
MAX_WAVE_NUMBER = 2.0**20


@dataclass(frozen=True)
class Light:
    """A point light: position (world units), linear RGB colour (channels in [0, 1e6]); None is a light that is off.

    >>> from renderer import Light
    >>> Light((0, 0, 5))
    Light(position=(0.0, 0.0, 5.0), color=(1.0, 1.0, 1.0))
    """

    position: Triple
    color: Triple | None = (1.0, 1.0, 1.0)

    def __post_init__(self):
        object.__setattr__(self, "position", check_triple("light.position", self.position))
        if self.color is not None:
            object.__setattr__(self, "color", check_triple("light.color", self.color, 0.0, 1e6))


DEFAULT_LIGHTS = (Light((5.0, 5.0, 10.0)), Light((-6.0, 2.0, 8.0), (0.9, 0.65, 0.25)))


def _check_lights(name, value):
    allowed = f"a sequence of at most {MAX_LIGHTS} Light"
    lights = check_items(name, value, allowed)
    if not all(isinstance(light, Light) for light in lights):
        raise not_allowed(name, value, allowed)
    if len(lights) > MAX_LIGHTS:
        raise ValueError(f"{name} = {len(lights)} lights is not allowed: {allowed}")
    return lights


def _light_from_record(number, record):
    if not isinstance(record, dict) or not {"position"} <= record.keys() <= {"position", "color"}:
        raise not_allowed(f"lights[{number}]", record, "a record with a position and a color")
    return Light(**record)


def _given(default, help, check, *allowed):
    """Return a field of the scene: its default, its option's help, the check of a value and the check's arguments."""
    return field(default=default, metadata={"help": help, "check": check, "allowed": allowed})


@dataclass(frozen=True)
class Scene:
    """Sphere A (the bumped one, at the origin), sphere B, the floor z = 0, the eye (0, 0, eye), up to five lights.

    Lengths are in world units, colours linear RGB. Defaults are the chapter's. The height field is a
    name or a HeightField, the model of light a name (blinn_gated: no highlight where N'·ω ≤ 0). The bump is the
    chapter's ("chart") or Blinn's, the normal of the surface that βh displaces, to first order, β a length ("surface";
    theorem surface_bump); with `horizon` no light comes from behind the surface itself. Raises ValueError that names
    the field, its value and what is allowed: 1e-6 ≤ radius/eye ≤ 1 − 1e-9; every other length at most 1e9 radii (and
    B's radius at least 1e-9 of one); B clear of the eye; no light inside a sphere or within 1e-9 of a surface.

    >>> from renderer import Scene
    >>> Scene(field="sine", beta=0.1, ball=False)
    Scene(ball=False, field='sine', beta=0.1)
    >>> Scene(eye=0.5)
    Traceback (most recent call last):
    ValueError: eye = 0.5 is not allowed: radius/eye from 1e-6 to 1 - 1e-9, and radius = 1
    """

    radius: float = _given(1.0, "radius of sphere A", check_number, 1e-60, 1e60)
    eye: float = _given(4.0, "height of the eye", check_number)
    ball: bool = _given(True, "leave sphere B out", check_truth)
    ball_center: Triple = _given((0.5, 0.5, 1.3), "centre of sphere B", check_triple)
    ball_radius: float = _given(0.32, "radius of sphere B", check_number)
    floor: bool = _given(True, "leave the floor out", check_truth)
    lights: Lights = _given(
        DEFAULT_LIGHTS, "a light, in place of the default two; repeat it for more, at most five", _check_lights
    )
    ambient: Triple = _given((0.15, 0.15, 0.16), "colour of the ambient light", check_triple, 0.0, 1e6)
    albedo_a: Triple = _given((0.63, 0.19, 0.16), "albedo of sphere A", check_triple, 0.0, 1.0)
    albedo_b: Triple = _given((0.33, 0.44, 0.62), "albedo of sphere B", check_triple, 0.0, 1.0)
    ka: float = _given(0.1, "ambient weight", check_number, 0.0, 1e6)
    kd: float = _given(0.7, "diffuse weight", check_number, 0.0, 1e6)
    ks: float = _given(0.5, "specular weight", check_number, 0.0, 1e6)
    shininess: float = _given(32.0, "exponent of the highlight", check_number, 1e-3, 1e6)
    model: str = _given("blinn", f"model of light: {', '.join(MODELS)}", check_choice, MODELS)
    floor_tint: float = _given(0.25, "how much red and green the floor lacks", check_number, 0.0, 1.0)
    field: Field = _given("ridges", f"height field: {', '.join(FIELDS)}", check_field, FIELDS)
    ku: float = _given(8.0, "wave number in u", check_number, -MAX_WAVE_NUMBER, MAX_WAVE_NUMBER)
    kv: float = _given(4.0, "wave number in v", check_number, -MAX_WAVE_NUMBER, MAX_WAVE_NUMBER)
    beta: float = _given(0.35, "bump amplitude", check_number, -1e100, 1e100)
    bump: str = _given("chart", "the chapter's bump, chart, or the surface's own, surface", check_choice, BUMPS)
    horizon: bool = _given(False, "let no light in from behind the surface itself", check_truth)

    def __post_init__(self):
        for each in fields(self):
            checked = each.metadata["check"](each.name, getattr(self, each.name), *each.metadata["allowed"])
            object.__setattr__(self, each.name, checked if each.type is Any else each.type(checked))
        for name in parameters(self.field):
            if hasattr(self, name):
                raise not_allowed("field", name, "parameters by names that no number of a scene has")
        if self.bump == "surface" and abs(self.beta) > 1e80 * self.radius:
            raise not_allowed("beta", self.beta, f"at most {1e80 * self.radius:g} in size beside bump 'surface'")
        steeper = 1e20 / self.radius if self.bump == "surface" else 1.0  # than 1/R sin φ, off the pole of any raster
        check_size(self.field, self.ku, self.kv, self.beta, steeper)
        self._check_lengths()

    def __repr__(self) -> str:
        changed = [f"{each.name}={now!r}" for each in fields(self) if (now := getattr(self, each.name)) != each.default]
        return f"Scene({', '.join(changed)})"

    def as_record(self) -> dict[str, Any]:
        """Return the scene as JSON can say it, by the names of its fields: numbers, sequences, dicts and None.

        A custom field is a dict, its formula text. Raises ValueError where it has no text.
        """
        return vars(self) | {"field": field_record(self.field)} | {"lights": [asdict(light) for light in self.lights]}

    @classmethod
    def from_record(cls, record: dict[str, Any]) -> "Scene":
        """Return the scene of a record, such as `as_record` returns, with the chapter's values for missing names.

        Nothing that a record says is run. Raises ValueError that names what is not allowed.
        """
        names = [each.name for each in fields(cls)]
        values = dict(check_kind("scene", record, dict, "a record by the names of its fields"))
        for name, value in values.items():
            check_choice("scene", name, names)
            values[name] = field_from_record(value) if name == "field" else value
        if "lights" in values:
            check_kind("lights", values["lights"], list, "a list of records")
            values["lights"] = [_light_from_record(number, light) for number, light in enumerate(values["lights"])]
        return cls(**values)

    def number(self, name: str, argument: str = "name") -> float:
        """Return a number by its name in the record, such as "lights[0].position[2]".

        Raises ValueError on no such name, which is the value of the `argument` that it names.
        """
        number: Any = self
        if name in (of_field := parameters(self.field)):
            return of_field[name]
        try:
            for part in path_of(name):
                number = part_of(number, part)
        except (AttributeError, IndexError, TypeError):
            number = None
        if not isinstance(number, float):
            raise not_allowed(argument, name, NUMBERS)
        return number

    def with_numbers(self, numbers: Mapping[str, float]) -> "Scene":
        """Return the scene with other numbers, {name: number}. Raises ValueError on what is not allowed.

        >>> from renderer import Scene
        >>> Scene().with_numbers({"ku": 6, "ambient[2]": 0.2})
        Scene(ambient=(0.15, 0.15, 0.2), ku=6.0)
        """
        scene = self
        for name, number in check_kind("numbers", numbers, Mapping).items():  # type: ignore[type-abstract]
            scene.number(name, "numbers")
            if name in parameters(scene.field):
                scene = replace(scene, field=scene.field.with_parameter(name, number))  # type: ignore[union-attr]
            else:
                scene = with_part(scene, path_of(name), number)
        return scene

    def to_file(self, path: str | Path) -> None:
        """Write the scene to a `.toml`, for `from_file` and `--scene`. Raises ValueError as `as_record` does."""
        write_whole(checked_target(path, (".toml",), "path"), toml_of(self.as_record()).encode())

    @classmethod
    def from_file(cls, path: str | Path) -> "Scene":
        """Return the scene of a TOML file, with the chapter's values for missing names. Raises ValueError."""
        with distrusted("scene", path):
            return cls.from_record(read_toml(path))

    def _check_lengths(self):
        ratio = self.radius / self.eye if self.eye else math.inf
        if not 1e-6 <= ratio <= 1 - 1e-9:
            raise not_allowed("eye", self.eye, f"radius/eye from 1e-6 to 1 - 1e-9, and radius = {self.radius:g}")
        far = 1e9 * self.radius
        if self.ball:
            check_number("ball_radius", self.ball_radius, 1e-9 * self.radius, far)
            check_triple("ball_center", self.ball_center, -far, far)
            x, y, z = self.ball_center
            if math.hypot(x, y, z - self.eye) <= self.ball_radius * (1 + 1e-9):
                raise not_allowed("ball_center", self.ball_center, "B clear of the eye")
        for number, light in enumerate(self.lights):
            name, position = f"lights[{number}].position", light.position
            check_triple(name, position, -far, far)
            if math.hypot(*position) <= self.radius * (1 + 1e-9):
                raise not_allowed(name, position, "outside sphere A")
            if self.ball and math.dist(position, self.ball_center) <= self.ball_radius * (1 + 1e-9):
                raise not_allowed(name, position, "outside sphere B")
            if self.floor and abs(position[2]) <= 1e-9 * self.radius:
                raise not_allowed(name, position, "off the floor z = 0 by more than 1e-9 radius")


class Geometry(NamedTuple):
    """The part of a scene on which chambers depend: lengths, and the lights' positions, None for one that is off."""

    eye: float
    radius: float
    ball: tuple[float, ...]
    ball_on: float
    floor_on: float
    lights: tuple


def geometry_of(scene: Scene) -> Geometry:
    """Return the Geometry of a scene. Without sphere B, `ball_on` is 0 and `ball` a unit sphere that is never drawn."""
    ball = (*scene.ball_center, scene.ball_radius) if scene.ball else (0.0, 0.0, 0.0, 1.0)
    lights = tuple(None if light.color is None else light.position for light in scene.lights)
    return Geometry(scene.eye, scene.radius, ball, float(scene.ball), float(scene.floor), lights)
