"""A machine around another one: it runs the shader on numbers with bounds, and stores these beside the colours."""

import math
from collections.abc import Callable, Iterable, Sequence
from itertools import repeat
from types import SimpleNamespace
from typing import Any

from renderer.machines.enclosing import Enclosed, Mask, at_work, enclosed
from renderer.machines.forms import COLORS, Variables, flat, of_form
from renderer.operations import where


class Variable:
    """A variable: two of the inner machine's, for the number and its error."""

    def __init__(self, machine: Any, number: Any):
        number = enclosed(number)
        self._stays_exact = number.stays_exact
        self._parts = Variables(machine, (number.value, number.error))

    @property
    def value(self) -> Enclosed:
        """The present value."""
        return Enclosed.counted(*self._parts.value, self._stays_exact)  # type: ignore[call-arg]

    def set(self, number: Any, mask: Mask | None = None) -> None:
        """Put a value in its place, where the mask holds."""
        number = enclosed(number) if mask is None else where(mask, number, self.value)
        self._parts.set((number.value, number.error))


class Enclosing:
    """The machine around another one. It counts work where masks hold as computed, not also where they are open."""

    def __init__(self, inner: Any):
        self.inner, self._mask = inner, None
        self.creases = inner.variable(0.0)  # 1 where a side of one is open
        at_work.set(self)

    def leave_open(self, where_: Any) -> None:
        """Note where the side of a crease is undecided, of the pixels that are being drawn; None: nowhere."""
        if where_ is not None:
            self.creases.set(1.0, where_ & self._mask)

    def variable(self, number: Any) -> Variable:
        """Return a Variable."""
        return Variable(self.inner, number)

    def count(self, kind: str, mask: Mask) -> None:
        """Add the number of pixels for which a mask holds to the count of a kind."""
        self.inner.count(kind, mask.holds)

    def when(self, mask: Mask, body: Callable[[], None]) -> None:
        """Run `body` unless the mask can hold for no pixel of the group."""

        def run():
            outside, self._mask = self._mask, mask.maybe
            body()
            self._mask = outside

        self.inner.when(mask.maybe, run)

    def choose(self, alternatives: Sequence, index: Enclosed, result_of: Callable[[Any], Sequence]) -> Sequence:
        """Return `result_of` the alternative of an index that is the same everywhere."""

        def parts(alternative):
            return [part for number in map(enclosed, result_of(alternative)) for part in (number.value, number.error)]

        flat = self.inner.choose(alternatives, index.value, parts)
        return [Enclosed.counted(*flat[at : at + 2]) for at in range(0, len(flat), 2)]

    def by_squaring(self, exponent: Enclosed, first: Callable, square: Callable, multiply: Callable) -> None:
        """Run the steps of repeated squaring, as the inner machine does."""
        self.inner.by_squaring(exponent.value, first, square, multiply)

    def each_light(self, body: Callable[[SimpleNamespace], None]) -> None:
        """Run `body` on the numbers of one light after another, which are exact."""
        self.inner.each_light(lambda light: body(enclosed_numbers(light)))


def enclosed_numbers(
    numbers: SimpleNamespace, bounds: SimpleNamespace | None = None, rounded: Iterable[str] = ()
) -> SimpleNamespace:
    """Return numbers of a form as Enclosed; those that are `rounded` have `bounds`."""
    errors = of_form(numbers, repeat(0.0))
    vars(errors).update({name: getattr(bounds, name) for name in rounded})
    return of_form(numbers, map(Enclosed, flat(numbers), flat(errors)))


class Pixels:
    """The pixels of a group, as the inner machine has them, with the colours' bounds and `open` stored beside."""

    def __init__(self, machine: Enclosing, pixels: Any, x_bound: Any, y_bound: Any, planes: Sequence[str]):
        self._machine, self._planes = machine, planes
        self.x, self.y, self._pixels = Enclosed(pixels.x, x_bound, True), Enclosed(pixels.y, y_bound, True), pixels

    def load(self, name: str) -> Enclosed:
        """Return a plane's numbers, which are taken for exact."""
        return Enclosed(self._pixels.load(name))

    def store(self, name: str, number: Any) -> None:
        """Write a plane's numbers, and of colours their bounds."""
        number = enclosed(number)
        self._pixels.store(name, number.value)
        if name == "code":
            # two codes differ by 1 at least
            decided = (number.bound < 0.5) & (self._machine.creases.value == 0.0)
            self._pixels.store("open", where(decided, 0.0, 1.0))
        elif f"{name}_bound" in self._planes:
            # a colour is clipped to [0, 1]; a slope that does not exist has no finite bound
            bound, largest = number.bound, 1.0 if name in COLORS else math.inf
            self._pixels.store(f"{name}_bound", where(bound < largest, bound, largest))  # also where it is NaN


def enclosed_group(group: Any, bounds: SimpleNamespace, x_bound: Any, y_bound: Any) -> Any:
    """Return a group that draws the same pixels with bounds, on an enclosing machine around the group's own.

    bounds: of the scene's numbers, by name. x_bound, y_bound: of the image points.
    """
    machine, shader = Enclosing(group.machine), group.want.shader
    pixels = Pixels(machine, group.pixels, x_bound, y_bound, shader.planes)
    return shader.group(machine, enclosed_numbers(group.scene, bounds, shader.rounded), group.want, pixels)
