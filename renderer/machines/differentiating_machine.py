"""A machine around another one: it runs the shader on numbers with slopes, and stores these beside the colours."""

from collections.abc import Callable, Sequence
from types import SimpleNamespace
from typing import Any

from renderer.machines.differentiating import Mask, Sloped, sloped, where
from renderer.machines.forms import COLORS, Variables, flat, of_form


class Variable:
    """A variable: one of the inner machine's for the number, and one for each slope."""

    def __init__(self, machine: "Differentiating", number: Any):
        self._all = machine.parts
        self._parts = Variables(machine.inner, self._all(number))

    @property
    def value(self) -> Sloped:
        """The present value."""
        value, *slopes = self._parts.value
        return Sloped(value, tuple(slopes))

    def set(self, number: Any, mask: Mask | None = None) -> None:
        """Put a value in its place, where the mask holds."""
        self._parts.set(self._all(number if mask is None else where(mask, number, self.value)))


class Differentiating:
    """The machine around another one. seeds_of: light → the slopes of its numbers, by each of the scene's."""

    def __init__(self, inner: Any, slopes: int, seeds_of: Callable[[SimpleNamespace], list]):
        self.inner, self._none, self._seeds_of = inner, (0.0,) * slopes, seeds_of

    def parts(self, number: Any) -> tuple:
        """Return a number's value and all its slopes."""
        number = sloped(number)
        return number.value, *(number.slopes or self._none)

    def variable(self, number: Any) -> Variable:
        """Return a Variable."""
        return Variable(self, number)

    def count(self, kind: str, mask: Mask) -> None:
        """Add the number of pixels for which a mask holds to the count of a kind."""
        self.inner.count(kind, mask.inner)

    def when(self, mask: Mask, body: Callable[[], None]) -> None:
        """Run `body` unless the mask holds for no pixel of the group."""
        self.inner.when(mask.inner, body)

    def choose(self, alternatives: Sequence, index: Sloped, result_of: Callable[[Any], Sequence]) -> Sequence:
        """Return `result_of` the alternative of an index that is the same everywhere."""
        if len(alternatives) == 1:  # where a slope that is 0 stays one, which costs nothing
            results = [*map(sloped, result_of(alternatives[0]))]
            values = self.inner.choose(alternatives, index.value, lambda _: [result.value for result in results])
            return [Sloped(value, result.slopes) for value, result in zip(values, results, strict=True)]

        def parts(alternative):
            return [part for number in result_of(alternative) for part in self.parts(number)]

        chosen, size = self.inner.choose(alternatives, index.value, parts), 1 + len(self._none)
        return [Sloped(chosen[at], tuple(chosen[at + 1 : at + size])) for at in range(0, len(chosen), size)]

    def by_squaring(self, exponent: Sloped, first: Callable, square: Callable, multiply: Callable) -> None:
        """Run the steps of repeated squaring, as the inner machine does."""
        self.inner.by_squaring(exponent.value, first, square, multiply)

    def each_light(self, body: Callable[[SimpleNamespace], None]) -> None:
        """Run `body` on the numbers of one light after another."""
        self.inner.each_light(lambda light: body(with_slopes(light, self._seeds_of(light))))


def with_slopes(numbers: SimpleNamespace, seeds: Sequence[SimpleNamespace]) -> SimpleNamespace:
    """Return numbers of a form as Sloped; seeds: their slopes by one number after another, in the same form."""
    return of_form(numbers, map(Sloped, flat(numbers), zip(*map(flat, seeds), strict=True)))


class Pixels:
    """The pixels of a group, as the inner machine has them, with the colours' slopes stored beside."""

    def __init__(self, machine: Differentiating, pixels: Any, x: Sloped, y: Sloped):
        self._parts, self._pixels, self.x, self.y = machine.parts, pixels, x, y

    def load(self, name: str) -> Sloped:
        """Return a plane's numbers, as constants: their slopes are 0."""
        return Sloped(self._pixels.load(name))

    def store(self, name: str, number: Any) -> None:
        """Write a plane's numbers; of a colour also its slopes, to the planes that have them."""
        value, *slopes = self._parts(number)
        self._pixels.store(name, value)
        for place, slope in enumerate(slopes if name in COLORS else ()):
            self._pixels.store(f"{name}_slope_{place}", slope)
