"""A machine that records what it runs as a straight-line program: each line is an operation on earlier lines' values.

A mask is no line: a selection has it, as a condition, and takes what is compared. Each of a group's masks is to hold
for some pixel: all steps are run.
"""

from collections.abc import Callable, Sequence
from functools import partial, partialmethod
from typing import Any

from renderer.machines.forms import Step, Variables
from renderer.machines.numpy_rows import Rows
from renderer.operations import Constant

Line = tuple
"""An operation, its text or its condition, and the places of what it takes."""


def _operator(kind, order=1):
    return lambda self, *others: self.made(kind, (self, *others)[::order])


class Mask:
    """A condition: a kind, and two numbers, or conditions."""

    def __init__(self, machine: "Recorder", kind: str, parts: Sequence):
        self.machine, self.kind, self.parts = machine, kind, parts

    def made(self, kind: str, parts: Sequence) -> "Mask":
        """Return a condition of conditions."""
        return Mask(self.machine, kind, parts)

    __and__, __or__, __invert__ = map(_operator, ("Both", "Either", "Not"))

    def of_places(self, compared: list[int]) -> tuple:
        """Return (kind, parts …), of numbers their place in a list, to which those that are not in it are added."""
        if isinstance(self.parts[0], Mask):
            return self.kind, *(part.of_places(compared) for part in self.parts)
        places = [self.machine.number(part).place for part in self.parts]
        compared += [place for place in dict.fromkeys(places) if place not in compared]
        return self.kind, *map(compared.index, places)


class Recorded:
    """A number: that of a line."""

    __hash__ = None  # type: ignore[assignment]

    def __init__(self, machine: "Recorder", place: int):
        self.machine, self.place = machine, place

    def made(self, kind: str, parts: Sequence) -> Any:
        """Return a line's number, or the Mask of a comparison."""
        if kind in ("Less", "At_most", "Same"):
            return Mask(self.machine, kind, parts)
        return self.machine.line(kind, *parts)

    __neg__, __abs__, __add__, __sub__, __mul__, __truediv__, __lt__, __le__, __eq__ = map(
        _operator, ("Negative", "Size", "Sum", "Difference", "Product", "Quotient", "Less", "At_most", "Same")
    )  # type: ignore[assignment]
    __radd__, __rsub__, __rmul__, __rtruediv__, __gt__, __ge__ = (
        _operator(kind, -1) for kind in ("Sum", "Difference", "Product", "Quotient", "Less", "At_most")
    )

    def __ne__(self, other):
        return ~(self == other)


class Variable:
    """A variable, which has a present value."""

    def __init__(self, value: Recorded):
        self.value = value

    def set(self, value: Any, mask: Mask | None = None) -> None:
        """Put a value in its place, where the mask holds."""
        machine = self.value.machine
        self.value = machine.number(value) if mask is None else machine.where(mask, value, self.value)


class Recorder(Rows):
    """The machine, and its one pixel. lines: {each: its place}; outputs: {a plane: its place for each drawing}."""

    def __init__(self, *planes: str):
        self.lines, self.outputs, self.lights = {}, {}, []
        self.x, self.y, *_ = map(self.load, ("x", "y", *planes))

    def line(self, operation: str, *numbers: Any, text: Any = "") -> Recorded:
        """Return a line's number, of a new line unless there is one like it."""
        line = operation, text, *(self.number(number).place for number in numbers)
        return Recorded(self, self.lines.setdefault(line, len(self.lines)))

    def number(self, number: Any) -> Recorded:
        """Return a number as Recorded, if it is not one."""
        if isinstance(number, Recorded):
            return number
        kind = "Constant" if isinstance(number, Constant) else "Literal"
        return self.line(kind, text=float(number).hex())

    def load(self, name: str, *numbers: int) -> Recorded:
        """Return an input; numbers: which one of those of a name."""
        return self.line("Input", text=(name, *numbers))

    def store(self, name: str, number: Any) -> None:
        """Make a number an output."""
        self.outputs.setdefault(name, []).append(self.number(number).place)

    sqrt, floor, rint, sinpi, cospi, atan2pi, power = map(
        partial(partialmethod, line), ("Root", "Floor", "Nearest", "Sine", "Cosine", "Angle", "Power")
    )

    def two_product(self, *factors: Any) -> tuple:
        """Return the factors: sinpi and cospi take them, as those of the enclosing machine's rules."""
        return factors

    def where(self, mask: Mask | bool, value: Any, otherwise: Any) -> Recorded:
        """Return a selection; mask: a truth value, where literals are compared."""
        if isinstance(mask, bool):
            return self.number(value if mask else otherwise)
        compared: list[int] = []
        condition = mask.of_places(compared)
        return self.line("Choose", value, otherwise, *(Recorded(self, place) for place in compared), text=condition)

    def variable(self, value: Any) -> Variable:
        """Return a Variable."""
        return Variable(self.number(value))

    def count(self, kind: str, mask: Mask) -> None:
        """Count nothing."""

    def when(self, mask: Mask, body: Step) -> None:
        """Run `body`."""
        body()

    def choose(self, alternatives: Sequence, index: Recorded, result_of: Callable[[Any], Sequence]) -> Sequence:
        """Return `result_of` the alternative of an index, by selections from those of all."""
        results = Variables(self, result_of(alternatives[0]))
        for number, alternative in enumerate(alternatives[1:], 1):
            results.set(result_of(alternative), index == float(number))
        return results.value

