"""The interface of machines and a shader: numbers in a form, variables that change together, and the class Shader."""

import re
from collections.abc import Callable, Iterable, Sequence
from types import SimpleNamespace
from typing import Any, NamedTuple

from renderer.operations import Mask, Number

COLORS = ("red", "green", "blue")
Step = Callable[[], None]
Numbers = Sequence[Number]


class Shader(NamedTuple):
    """A shader, as machines run it. A want chooses its code; it has the shader as `shader`, and `bounds` and `is_long`.

    group: (machine, scene, want, pixels) → an object with `draw()`, and these as attributes. scene, light: the forms of
    their numbers. rounded: the names of a scene's numbers that are not exact. counted: the kinds of work. planes: the
    names of the stored planes. around: group → the group that is drawn, on a machine around the group's own.
    """

    group: Callable
    scene: SimpleNamespace
    light: SimpleNamespace
    rounded: Sequence[str]
    counted: Sequence[str]
    planes: Sequence[str]
    around: Callable = lambda group: group


def flat(numbers: SimpleNamespace) -> list:
    """Return the numbers one after another, a list."""
    return [part for field in vars(numbers).values() for part in (field if isinstance(field, tuple) else (field,))]


def of_form(form: SimpleNamespace, values: Iterable) -> SimpleNamespace:
    """Return an iterable of values in the form of other numbers: the inverse of `flat`."""
    values, names = iter(values), vars(form).items()
    return SimpleNamespace(
        **{n: tuple(next(values) for _ in old) if isinstance(old, tuple) else next(values) for n, old in names}
    )


def path_of(name: str) -> list[str]:
    """Return the parts of a number's name, such as lights[0].position[2]; of any other text [""], which nothing has."""
    return re.findall(r"\w+", name) if re.fullmatch(r"[a-z_]+(\[\d\](\.[a-z]+\[\d\])?)?", str(name)) else [""]


def part_of(value: Any, name: str) -> Any:
    """Return a part of a tuple or of an object."""
    return value[int(name)] if isinstance(value, tuple) else getattr(value, name)


def with_part(value: Any, path: Sequence[str], part: Any) -> Any:
    """Return a value of tuples and objects with another part at the end of a path."""
    if not path:
        return part
    first, *rest = path
    part = with_part(part_of(value, first), rest, part)
    if isinstance(value, tuple):
        return *value[: int(first)], part, *value[int(first) + 1 :]
    return type(value)(**vars(value) | {first: part})


class Variables:
    """Several variables that change together."""

    def __init__(self, machine: Any, values: Iterable[Number]):
        self._each = [machine.variable(value) for value in values]

    @property
    def value(self) -> Numbers:
        """The present values."""
        return [variable.value for variable in self._each]

    def set(self, values: Iterable[Number], mask: Mask | None = None) -> None:
        """Put values in their place, where the mask holds."""
        for variable, value in zip(self._each, values, strict=True):
            variable.set(value, mask)
