"""The central difference's error, taken apart: truncation, rounded arguments, rounded evaluation; each exactly.

The difference in exact arithmetic, and the same of the arguments u ± ε as float64 has them, are balls of the
program's own lines; the float64 difference is the kernel's. With D the exact difference and D̂ that of the rounded
arguments: total = (D − h') + (D̂ − D) + (computed − D̂).
"""

from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from proofs.engine.program import Program
from proofs.formulas.finite_difference import central, span_v, u_minus, u_plus, v_minus, v_plus
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from proofs.formulas.step_bounds import TERMS
from renderer import Scene
from renderer.generate.step_terms import SLOPE_TERMS
from renderer.kernels import FIELDS
from renderer.shader.shader import difference
from verify.evaluate.arrays import Inputs, in_balls, in_float64, signed_distance

PER_DECADE = 40
ARGUMENTS = (u_plus, u_minus, v_plus, v_minus, span_v)
STEPS = np.array([10.0 ** (-n / PER_DECADE) for n in range(PER_DECADE, 16 * PER_DECADE + 1)])
PARTS = (*TERMS[:3], "total")  # straddling and one-sided differences: all that is not rounding is truncation's part
SLOPES = ("h_u", "h_v")


class Case(NamedTuple):
    """Where a difference is taken: the component, one of SLOPES, of a field at (u, v)."""

    name: str
    field: str
    k_u: float
    k_v: float
    u: float
    v: float
    component: str = "h_u"

    @property
    def scene(self) -> Scene:
        """The scene whose field it is."""
        return Scene(field=self.field, ku=self.k_u, kv=self.k_v)

    @property
    def inputs(self) -> dict[str, float]:
        """The point and the wave numbers, {name: number}."""
        return {name: getattr(self, name) for name in ("u", "v", "k_u", "k_v")}


@cache
def _split(field):
    """Return a central difference in two programs: where it samples, and the quotient of given samples."""
    whole = central(HEIGHT_FIELDS[field])
    rest = tuple(line for line in whole.definitions if line[0] not in ARGUMENTS)
    return whole.keep(*ARGUMENTS), Program("given", (*whole.inputs, *ARGUMENTS), rest, whole.outputs)


def by_the_kernel(field: str, at: Inputs) -> dict[str, np.ndarray]:
    """Return {component: the renderer's difference}; at: arrays of u, v, k_u, k_v, epsilon by name."""
    with np.errstate(all="ignore"):
        found = difference(FIELDS[field], "central", *(at[name] for name in ("u", "v", "k_u", "k_v", "epsilon")))
    return {name: np.broadcast_to(part, np.shape(at["u"])) for name, part in zip(SLOPES, found, strict=True)}


def taken_apart(
    field: str, inputs: Inputs, steps: ArrayLike, computed: dict[str, np.ndarray] | None = None
) -> dict[str, np.ndarray]:
    """Return {component: the signed errors of PARTS} over arrays of points or of steps.

    inputs: u, v, k_u, k_v by name. computed: {component: differences} in place of the kernel's.
    """
    names = ("u", "v", "k_u", "k_v", "epsilon")
    at = dict(zip(names, np.broadcast_arrays(*(inputs[name] for name in names[:-1]), steps), strict=True))
    where, given = _split(field)
    slope, exact = in_balls(gradient(HEIGHT_FIELDS[field]), inputs), in_balls(central(HEIGHT_FIELDS[field]), at)
    moved, found = in_balls(given, at | in_float64(where, at)), computed or by_the_kernel(field, at)
    pairs = dict.fromkeys(found, ((exact, slope), (moved, exact), (found, moved), (found, slope)))
    return {c: np.array([signed_distance(a[c], b[c]) for a, b in both]) for c, both in pairs.items()}


def parts(case: Case, steps: ArrayLike = STEPS, computed: np.ndarray | None = None) -> dict[str, np.ndarray]:
    """Return {part: signed errors} of a case over the steps; `computed` replaces the kernel's differences."""
    replaced = None if computed is None else {case.component: computed}
    found = taken_apart(case.field, case.inputs, np.asarray(steps, np.float64), replaced)
    return dict(zip(PARTS, found[case.component], strict=True))


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


def _poles(field):
    """Return the Cases of a covered field at the pole v = 0, which is no place for one that is creased there."""
    at = (0.0, 1e-5, 1e-2)[bool(field.creases) :]
    return [Case(f"{field.name}, pole, v = {v:g}", field.name, 8.0, 4.0, 0.31, v, "h_v") for v in at]


_COVERED = [HEIGHT_FIELDS[name] for name in SLOPE_TERMS]
CASES = (
    *_CHOSEN,
    *(case for field in _COVERED for case in _poles(field)),
    *(Case(f"{f.name}, {slope}", f.name, 8.0, 4.0, *SMOOTH, slope)
      for f in _COVERED if f.name not in {case.field for case in _CHOSEN} for slope in SLOPES),
)  # fmt: skip
"""The places: smooth ones for k from 1 to 512, beside a crease, at the pole's border, beside the seam; and one smooth
place of any other field that the theorems cover."""
