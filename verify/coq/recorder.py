"""A machine that records what it runs as a straight-line program: each line is an operation on earlier lines' numbers.

Operations have Python's names. A condition is no line: a selection has it, and takes what it compares. As of a group in
which each mask holds for some pixel, all steps are recorded.
"""

from collections.abc import Callable, Iterable, Sequence
from functools import partial, partialmethod
from typing import Any

import numpy as np

from renderer.machines.forms import Step
from renderer.machines.numpy_rows import Rows
from renderer.operations import Constant, where

CONDITIONS, REFLECTED = ("lt", "le", "eq", "ne", "and", "or", "invert"), {"lt": "gt", "le": "ge"}


class Recorded:
    """A number, by its line's place, or a condition: (its name, its parts …)."""

    __hash__ = None  # type: ignore[assignment]

    def __init__(self, machine: Any, stands_for: Any):
        self.machine, self.stands_for = machine, stands_for


def _operator(name, order):
    def operator(self, *others):
        parts = (self, *others)[::order]
        return Recorded(self.machine, (name, *parts)) if name in CONDITIONS else self.machine.line(name, *parts)

    return operator


for _name in (*CONDITIONS, "neg", "abs", "add", "sub", "mul", "truediv"):
    setattr(Recorded, f"__{_name}__", _operator(_name, 1))
    setattr(Recorded, f"__{REFLECTED.get(_name, f'r{_name}')}__", _operator(_name, -1))


class Variable:
    """A variable, which has a present value."""

    def __init__(self, value: Any):
        self.value = value

    def set(self, value: Any, mask: Any = None) -> None:
        """Put a value in its place, where the mask holds."""
        self.value = value if mask is None else where(mask, value, self.value)


class Recorder(Rows):
    """The machine, and its one pixel. lines: {each: its place}; outputs: {a plane: its place for each drawing}."""

    variable = Variable  # type: ignore[assignment]

    def __init__(self, *planes: str):
        self.lines: dict[tuple, int] = {}
        self.outputs: dict[str, list[int]] = {}
        self.x, self.y, *_ = map(self.load, ("x", "y", *planes))

    def line(self, operation: str, *numbers: Any, text: Any = "") -> Recorded:
        """Return a line's number, of a new line unless there is one like it."""
        line = operation, text, *map(self.place, numbers)
        return Recorded(self, self.lines.setdefault(line, len(self.lines)))

    def place(self, number: Any) -> int:
        """Return the place of a number's line."""
        if not isinstance(number, Recorded):
            kind = "constant" if isinstance(number, Constant) else "literal"
            number = self.line(kind, text=float(number).hex())
        return number.stands_for

    def load(self, *name: Any) -> Recorded:
        """Return an input; name: with the numbers of it, where it is one of several."""
        return self.line("input", text=name)

    def store(self, name: str, number: Any) -> None:
        """Make a number an output."""
        self.outputs.setdefault(name, []).append(self.place(number))

    sqrt, floor, rint, sinpi, cospi, atan2pi, exp, log, power = map(
        partial(partialmethod, line), ("sqrt", "floor", "rint", "sinpi", "cospi", "atan2pi", "exp", "log", "power")
    )

    def two_product(self, a: Any, b: Any) -> tuple:
        """Return a product, and its rounding error."""
        return a * b, self.line("product_error", a, b)

    def where(self, mask: Recorded, *sides: Any) -> Recorded:
        """Return a selection."""
        compared: dict[int, int] = {}

        def condition(part):
            if isinstance(of := getattr(part, "stands_for", None), tuple):
                return of[0], *map(condition, of[1:])
            return compared.setdefault(self.place(part), len(compared))

        text = condition(mask)
        return self.line("where", *sides, *(Recorded(self, place) for place in compared), text=text)

    def count(self, kind: str, mask: Recorded) -> None:
        """Count nothing."""

    def when(self, mask: Recorded, body: Step) -> None:
        """Run `body`."""
        body()

    def choose(self, alternatives: Sequence, index: Recorded, result_of: Callable[[Any], Sequence]) -> Sequence:
        """Return `result_of` the alternative of an index, by selections from those of all."""
        chosen, *others = map(result_of, alternatives)
        for number, other in enumerate(others, 1):
            chosen = [where(index == float(number), *sides) for sides in zip(other, chosen, strict=True)]
        return chosen


def values_of(lines: Iterable[tuple], inputs: Iterable, done: Callable) -> list:
    """Return the values of recorded lines for their inputs in order; done(name, *numbers): an operation's result."""
    values: list[Any] = []
    inputs = iter(inputs)

    def holds(condition, compared):
        kind, *parts = condition
        return done(kind, *(holds(p, compared) if isinstance(p, tuple) else compared[p] for p in parts))

    for kind, text, *places in lines:
        taken = [values[place] for place in places]
        if kind == "where":
            taken = [holds(text, taken[2:]), *taken[:2]]
        values.append(
            done(kind, *taken) if taken else next(inputs) if kind == "input" else np.float64(float.fromhex(text))
        )
    return values
