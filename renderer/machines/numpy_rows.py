"""The shader on NumPy's arrays, some rows of the picture at a time: where there is no compiler, and to check one."""

from collections.abc import Callable, Iterable, Sequence
from types import SimpleNamespace
from typing import Any

import numpy as np

from renderer.machines import Job
from renderer.machines.forms import Shader, Step, of_form
from renderer.operations import Mask, Number

NAME = "numpy"


class Variable:
    """A variable: an array that is replaced."""

    def __init__(self, value: Number):
        self.value = np.asarray(value)

    def set(self, value: Number, mask: Mask | None = None) -> None:
        """Put a value in its place, where the mask holds."""
        self.value = value if mask is None else np.where(mask, value, self.value)


class Rows:
    """A machine whose values are arrays over some rows."""

    variable = Variable

    def __init__(self, shader: Shader, lights: Iterable[np.ndarray]):
        self.lights = [of_form(shader.light, light) for light in lights]
        self.counts = dict.fromkeys(shader.counted, 0)

    def count(self, kind: str, mask: Mask) -> None:
        """Add the number of a mask's pixels to the count of a kind."""
        self.counts[kind] += int(np.count_nonzero(mask))

    def when(self, mask: Mask, body: Step) -> None:
        """Run `body` unless the mask holds for no pixel."""
        if np.any(mask):
            body()

    def choose(self, alternatives: Sequence, index: Number, result_of: Callable[[Any], Sequence]) -> Sequence:
        """Return `result_of` the alternative of an index."""
        return result_of(alternatives[int(index)])

    def by_squaring(self, exponent: Number, first: Step, square: Step, multiply: Step) -> None:
        """Run the steps of repeated squaring, as `renderer.machines.traced.Tracer.by_squaring` does."""
        remaining = int(exponent)
        if not remaining:
            return
        while not remaining & 1:
            square()
            remaining >>= 1
        first()
        while remaining := remaining >> 1:
            square()
            if remaining & 1:
                multiply()

    def each_light(self, body: Callable[[SimpleNamespace], None]) -> None:
        """Run `body` on the numbers of one light after another."""
        for light in self.lights:
            body(light)


class Block:
    """The pixels of some rows, a slice: the part of the frame's planes that the shader reads and writes."""

    def __init__(self, job: Job, rows: slice):
        begin, end = job["columns"][rows].T
        self.rows, self.columns, self._planes = rows, slice(begin.min(), end.max()), job
        self.x, self.y = job["x"][self.columns], job["y"][rows, None]

    def load(self, name: str) -> np.ndarray:
        """Return a plane's part as float64."""
        return self._planes[name][self.rows, self.columns].astype(np.float64)

    def store(self, name: str, value: Number) -> None:
        """Write a plane's part."""
        self._planes[name][self.rows, self.columns] = value


def drawer(want: Any, job: Job) -> Callable[[slice], list[int]]:
    """Return the function that draws rows (a slice) of a Job and returns the counts, in the shader's order."""
    shader = want.shader
    scene = of_form(shader.scene, job["scene"])

    @np.errstate(all="ignore")  # a selection computes both of its sides
    def draw(rows):
        machine, block = Rows(shader, job["lights"]), Block(job, rows)
        group = shader.group(machine, scene, want, block)
        if want.bounds:
            from renderer.machines.enclosing_machine import enclosed_group  # what most pictures never need to import

            of_pixels = job["x_bound"][block.columns], job["y_bound"][block.rows, None]
            group = enclosed_group(group, of_form(shader.scene, job["scene_bounds"]), *of_pixels)
        shader.around(group).draw()
        return [*machine.counts.values()]

    return draw


@np.errstate(all="ignore")
def over_points(kernel: Callable, *inputs: Any) -> list[np.ndarray]:
    """Return what a kernel gives at each point, an array for each output; inputs: arrays (points,), or one number."""
    result, points = kernel(*inputs), np.broadcast(*inputs).size
    return [np.broadcast_to(each, points) for each in (result if isinstance(result, tuple) else (result,))]


def write_levels(numbers: np.ndarray, begins: np.ndarray, level_at: np.ndarray, levels: np.ndarray) -> None:
    """Write the levels of numbers: in cells, equal parts of [0, 1], which have `level_at` where they begin.

    A level, from 1 on, holds from a number on, of `begins`; of no cell two begin inside.
    """
    inside = np.fmin(np.fmax(numbers, 0.0), 1.0)  # NaN is 0
    level = level_at[(inside * (len(level_at) - 1)).astype(np.intp)]
    levels[...] = level + (numbers >= begins[level])


def over_bytes(kernel: Callable, *inputs: np.ndarray) -> np.ndarray:
    """Return what a kernel gives of bytes, as bytes."""
    return kernel(*(each.astype(np.int16) for each in inputs)).astype(np.uint8)
