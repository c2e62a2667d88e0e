"""A stress sweep: one parameter, some samples at each value; what was measured, and the bound of every single point."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from proofs.engine.program import Program
from renderer.machines.enclosing import Enclosed
from verify.evaluate.arrays import Inputs, distance, in_balls, length, response


@dataclass(frozen=True)
class Sweep:
    """errors, bounds: (values, samples). others: {name: errors}, for comparison, without a bound.

    responses: (values,), of the sample with the largest error at each value, how far it is expected to be off.
    """

    parameter: np.ndarray
    errors: np.ndarray
    bounds: np.ndarray
    responses: np.ndarray
    others: dict = field(default_factory=dict)

    @property
    def points(self) -> int:
        """How many points were measured."""
        return self.errors.size

    @property
    def escaped(self) -> int:
        """How many errors are above their bound, or have no reference, or no finite bound."""
        return int(np.count_nonzero(~((self.errors <= self.bounds) & np.isfinite(self.bounds))))

    @property
    def sharpness(self) -> float:
        """The median of bound / error, where there is an error."""
        seen = self.errors > 0
        return float(np.median(self.bounds[seen] / self.errors[seen]))

    def in_responses(self, name: str | None = None) -> float:
        """Return the largest error at a value over its response: ours, or that of one of the others."""
        with np.errstate(invalid="ignore"):  # 0/0, of what is exactly 0
            return float(np.nanmax(self.worst(name) / self.responses))

    def worst(self, name: str | None = None) -> np.ndarray:
        """Return the largest error at each value: ours, or that of one of the others; NaN where none is finite."""
        errors = self.errors if name is None else self.others[name]
        finite = np.where(np.isfinite(errors), errors, -1.0).max(axis=1)
        return np.where(finite < 0, np.nan, finite)


def _apart(values, others, scales, norm):
    return norm([distance(values[name], others[name]) / scale for name, scale in scales.items()])


def measured(
    parameter: np.ndarray,
    ours: Mapping[str, Enclosed],
    exact: Program,
    inputs: Inputs,
    scales: Mapping[str, Any],
    others: Mapping[str, Mapping[str, np.ndarray]] | None = None,
    norm: Callable = length,
) -> Sweep:
    """Return the Sweep of our numbers, with bounds, against what a program computes without rounding.

    scales: {output: by what its errors are divided}. others: {name: {output: array}} of other ways to compute the
    same. norm: what is taken of the outputs' errors, given all of them.
    """
    truth, values = in_balls(exact, inputs), {name: ours[name].value for name in scales}
    off = _apart(values, truth, scales, norm)
    errors = {name: _apart(numbers, truth, scales, norm) for name, numbers in (others or {}).items()}
    bounds = norm([ours[name].bound / scale for name, scale in scales.items()])
    worst = np.arange(len(off)), off.argmax(axis=1)

    def at_worst(arrays):
        return {name: np.broadcast_to(array, off.shape)[worst] for name, array in arrays.items()}

    there, true, sizes = at_worst(inputs), at_worst(truth), at_worst(scales)

    def change(taken):
        return _apart(in_balls(exact, there, taken), true, sizes, norm)

    size = norm([abs(number) / sizes[name] for name, number in at_worst(values).items()])
    return Sweep(parameter, off, bounds, response(size, change), errors)
