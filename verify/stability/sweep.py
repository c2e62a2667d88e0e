"""A stress sweep: one parameter, some samples at each value; the errors, and the bound of every single point."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from proofs.engine.program import Program
from renderer.machines.enclosing import Enclosed
from verify.evaluate.arrays import Inputs, distance, in_balls, length, response, with_bounds


@dataclass(frozen=True)
class Sweep:
    """errors, bounds: (values, samples). others: {name: errors}, for comparison, without a bound.

    responses: (values,), of the sample with the largest error at each value, how far it is expected to be off.
    """

    parameter: np.ndarray
    errors: np.ndarray
    bounds: np.ndarray
    responses: np.ndarray
    others: dict

    @property
    def points(self) -> int:
        """The number of points measured."""
        return self.errors.size

    @property
    def escaped(self) -> int:
        """The number of errors that are above their bound, or without a reference or a finite bound."""
        return int(np.count_nonzero(~((self.errors <= self.bounds) & np.isfinite(self.bounds))))

    @property
    def sharpness(self) -> float:
        """The median of bound / error, where there is an error."""
        wrong = self.errors > 0
        return float(np.median(self.bounds[wrong] / self.errors[wrong]))

    def in_responses(self, name: str | None = None) -> float:
        """Return the largest error at a value over its response: ours, or that of one of the others."""
        with np.errstate(invalid="ignore"):  # 0/0, of what is exactly 0
            return float(np.nanmax(self.worst(name) / self.responses))

    def worst(self, name: str | None = None) -> np.ndarray:
        """Return the largest error at each value: ours, or that of one of the others; NaN where none is finite."""
        errors = self.errors if name is None else self.others[name]
        finite = np.where(np.isfinite(errors), errors, -1.0).max(axis=1)
        return np.where(finite < 0, np.nan, finite)


def measured(
    parameter: np.ndarray,
    exact: Program,
    inputs: Inputs,
    ours: Mapping[str, Enclosed] | None = None,
    scales: Mapping[str, Any] | None = None,
    others: Mapping[str, Mapping[str, np.ndarray]] | None = None,
    norm: Callable = length,
) -> Sweep:
    """Return the Sweep of our numbers, with bounds, against what a program computes without rounding.

    ours: by default the program's own. scales: {output: the divisor of its errors}, by default 1. others: {name:
    {output: array}} of other ways to compute the same. norm: the function from the errors of all outputs to one.
    """
    ours, scales = ours or with_bounds(exact, inputs), scales or {s.name: 1.0 for s in exact.outputs}
    truth, values = in_balls(exact, inputs), {name: ours[name].value for name in scales}

    def apart(values, truth=truth, scales=scales):
        return norm([distance(values[name], truth[name]) / scale for name, scale in scales.items()])

    off = apart(values)
    bounds = norm([ours[name].bound / scale for name, scale in scales.items()])
    worst = np.arange(len(off)), off.argmax(axis=1)

    def at_worst(arrays):
        return {name: np.broadcast_to(array, off.shape)[worst] for name, array in arrays.items()}

    there, true, sizes = at_worst(inputs), at_worst(truth), at_worst(scales)
    size = norm([abs(number) / sizes[name] for name, number in at_worst(values).items()])
    responses = response(size, lambda taken: apart(in_balls(exact, there, taken), true, sizes))
    return Sweep(parameter, off, bounds, responses, {name: apart(other) for name, other in (others or {}).items()})
