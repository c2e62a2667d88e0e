"""A stress sweep: one parameter, some samples at each value; what was measured, and the bound of every single point."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from proofs.engine.program import Program
from verify.evaluate.arrays import Inputs, in_balls, vector_bound, vector_distance, with_bounds


@dataclass(frozen=True)
class Sweep:
    """errors, bounds: (values, samples). others: {name: errors}, for comparison, without a bound.

    A NaN error is a point without a reference: 53 bits do not decide there on which side of a jump it lies.
    """

    parameter: np.ndarray
    errors: np.ndarray
    bounds: np.ndarray
    others: dict = field(default_factory=dict)

    @property
    def points(self) -> int:
        """How many points have a reference."""
        return self.errors.size - self.undecided

    @property
    def undecided(self) -> int:
        """How many have none."""
        return int(np.isnan(self.errors).sum())

    @property
    def escaped(self) -> int:
        """How many errors are above their bound, or their bound is not finite."""
        return int(
            np.count_nonzero(~np.isnan(self.errors) & ~((self.errors <= self.bounds) & np.isfinite(self.bounds)))
        )

    @property
    def sharpness(self) -> float:
        """The median of bound / error, where there is an error."""
        seen = self.errors > 0
        return float(np.median(self.bounds[seen] / self.errors[seen]))

    def worst(self, name: str | None = None) -> np.ndarray:
        """Return the largest error at each value: ours, or that of one of the others; NaN where none is finite."""
        errors = self.errors if name is None else self.others[name]
        finite = np.where(np.isfinite(errors), errors, -1.0).max(axis=1)
        return np.where(finite < 0, np.nan, finite)

    def worst_bound(self) -> np.ndarray:
        """Return the largest bound at each value."""
        return np.where(np.isnan(self.errors), 0.0, self.bounds).max(axis=1)


def measured(
    parameter: np.ndarray,
    program: Program,
    inputs: Inputs,
    names: Sequence[str],
    reference: Program | None = None,
    **others: Mapping[str, np.ndarray],
) -> Sweep:
    """Return the Sweep of the vector of a program's outputs by name: its errors against balls and its running bounds.

    reference: another program for the same numbers. others: {name: {output: array}} of other ways to compute them.
    """
    ours, truth = with_bounds(program, inputs), in_balls(reference or program, inputs)

    def errors(values):
        return vector_distance(values, truth, names)

    values = {n: ours[n].value for n in names}
    return Sweep(parameter, errors(values), vector_bound(ours, names), {n: errors(v) for n, v in others.items()})
