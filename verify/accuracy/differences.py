"""Errors of a difference's h_u and h_v at any point, seam and poles included, in exact parts: truncation and roundings.

The difference in exact arithmetic, and the same of the arguments u ± ε as float64 has them, are balls of the
program's own lines; the float64 difference is the kernel's. With D the exact difference and D̂ that of the rounded
arguments: total = (D − h') + (D̂ − D) + (computed − D̂). The bounds are those of `verify.accuracy.step_terms`.
"""

from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from proofs.formulas.finite_difference import FAR, METHODS, NEAR, span_v, stepped
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from proofs.formulas.step_bounds import TERMS
from verify.accuracy.step_terms import SLOPE_TERMS, slope_terms
from verify.evaluate.arrays import Inputs, in_balls, in_float64, signed_distance
from verify.evaluate.programs import lines

PER_DECADE = 40
ARGUMENTS = {*NEAR, *FAR, span_v, stepped}
STEPS = np.array([10.0 ** (-n / PER_DECADE) for n in range(PER_DECADE, 16 * PER_DECADE + 1)])
PARTS = (*TERMS[:3], "total")  # the first is the whole error in exact arithmetic, straddling and one-sided included
SLOPES = ("h_u", "h_v")

Curves = dict[str, np.ndarray]  # {part: one number for each step}


class Case(NamedTuple):
    """A place of a difference: the component, one of SLOPES, of a field at (u, v), by a method."""

    name: str
    field: str
    k_u: float
    k_v: float
    u: float
    v: float
    component: str = "h_u"
    method: str = "central"

    @property
    def inputs(self) -> dict[str, float]:
        """The point and the wave numbers, {name: number}."""
        return {name: getattr(self, name) for name in ("u", "v", "k_u", "k_v")}


@cache
def _split(field, method):
    """Return a difference, and in two programs: where it samples, and the quotient of given samples."""
    difference = METHODS[method](HEIGHT_FIELDS[field])
    arguments = tuple(symbol for symbol, _ in difference.definitions if symbol in ARGUMENTS)
    return difference, difference.keep(*arguments), lines(difference, arguments, difference.outputs)


def taken_apart(field: str, inputs: Inputs, steps: ArrayLike, method: str) -> dict[str, np.ndarray]:
    """Return {component: the signed errors of PARTS} over arrays of points or of steps. inputs: u, v, k_u, k_v."""
    at, (difference, where, quotient) = {**inputs, "epsilon": steps}, _split(field, method)
    slope, exact, computed = (
        in_balls(gradient(HEIGHT_FIELDS[field]), inputs),
        in_balls(difference, at),
        in_float64(difference, at),
    )
    moved = in_balls(quotient, at | in_float64(where, at))
    pairs = ((exact, slope), (moved, exact), (computed, moved), (computed, slope))
    return {c: np.array([signed_distance(a[c], b[c]) for a, b in pairs]) for c in SLOPES}


def parts(case: Case, steps: ArrayLike = STEPS) -> Curves:
    """Return {part: signed errors} of a case over the steps."""
    errors = taken_apart(case.field, case.inputs, np.asarray(steps, np.float64), case.method)
    return dict(zip(PARTS, errors[case.component], strict=True))


@np.errstate(all="ignore")
def bounds(case: Case) -> Curves:
    """Return {part: upper bounds of its size} over STEPS, for a field that the theorems cover."""
    terms = slope_terms(HEIGHT_FIELDS[case.field], case.method)
    both = terms(case.u, case.v, case.k_u, case.k_v, STEPS)
    truncation, *rounding, straddling, one_sided = both[SLOPES.index(case.component)]
    exact = truncation + straddling + one_sided
    return dict(zip(PARTS, (exact, *rounding, exact + sum(rounding)), strict=True))


def escapes(errors: Curves, limits: Curves) -> dict[str, int]:
    """Return {part: how many points are above their bound}; what is not a number is above."""
    return {part: int(np.count_nonzero(~(np.abs(errors[part]) <= limit))) for part, limit in limits.items()}


SMOOTH = (0.31, 0.47)
_K = (1, 2, 4, 8, 16, 32, 64, 128, 256, 512)
_CHOSEN = (
    Case("steep", "sine", 8.0, 4.0, 0.61, 0.125),
    *(Case(f"sine, k = {k}", "sine", k, 4.0, *SMOOTH) for k in _K),
    *(Case(f"rings, k_v = {k}", "rings", 8.0, k, *SMOOTH, "h_v") for k in (4, 64)),
    Case("ridges", "ridges", 8.0, 4.0, *SMOOTH),
    *(Case(f"crease, δ = {d:g}", "ridges", 8.0, 4.0, 0.375 + d, 0.47) for d in (1e-2, 1e-4, 1e-6, 1e-8)),
    *(Case(f"seam, k = {k:g}", "sine", k, 4.0, 1e-4, 0.47) for k in (8.0, 7.0, 7.3)),
)


def _everywhere(name):
    """Return the Cases that every covered field has: at the pole v = 0 unless it is creased there, and a smooth one."""
    at = (0.0, 1e-5, 1e-2)[bool(HEIGHT_FIELDS[name].creases) :]
    poles = [Case(f"{name}, pole, v = {v:g}", name, 8.0, 4.0, 0.31, v, "h_v") for v in at]
    smooth = [Case(f"{name}, {slope}", name, 8.0, 4.0, *SMOOTH, slope) for slope in SLOPES]
    return poles + smooth * (name not in {case.field for case in _CHOSEN})


CASES = (*_CHOSEN, *(case for name in SLOPE_TERMS for case in _everywhere(name)))
"""The places: smooth ones for k from 1 to 512, beside a crease, at the pole's border, beside the seam."""
