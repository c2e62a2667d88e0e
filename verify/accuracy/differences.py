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
from proofs.formulas.height_fields import HEIGHT_FIELDS, factors, gradient
from renderer import Scene
from renderer.kernels import FIELDS
from renderer.shader.shader import difference
from verify.evaluate.arrays import Inputs, in_balls, in_float64, signed_distance

PER_DECADE = 40
ARGUMENTS = (u_plus, u_minus, v_plus, v_minus, span_v)
STEPS = np.array([10.0 ** (-n / PER_DECADE) for n in range(PER_DECADE, 16 * PER_DECADE + 1)])
PARTS = ("truncation", "argument", "roundoff", "total")


class Case(NamedTuple):
    """Where a difference is taken: the component ("h_u" or "h_v") of a field at (u, v), and what is special there."""

    name: str
    field: str
    k_u: float
    k_v: float
    u: float
    v: float
    component: str = "h_u"
    place: str = "smooth"
    distance: float = 1.0  # to the crease, the pole or the seam, in the component's coordinate

    @property
    def frequency(self) -> float:
        """Half the number of waves along the component's coordinate."""
        k = self.k_u if self.component == "h_u" else self.k_v
        return abs(2 * k if self.field == "rings" else k)

    @property
    def scene(self) -> Scene:
        """The scene whose field it is."""
        return Scene(field=self.field, ku=self.k_u, kv=self.k_v)

    @property
    def inputs(self) -> dict[str, float]:
        """The point and the wave numbers, {name: number}."""
        return {name: getattr(self, name) for name in ("u", "v", "k_u", "k_v")}


class Parts(NamedTuple):
    """The signed errors of one difference, float64 of exact numbers: (steps,) each, and the exact slope.

    moving, still: |sin| of the factor that the step moves, and of the other (1 for rings, which has none).
    """

    steps: np.ndarray
    truncation: np.ndarray
    argument: np.ndarray
    roundoff: np.ndarray
    total: np.ndarray
    slope: float
    moving: float
    still: float


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
    return {name: np.broadcast_to(part, np.shape(at["u"])) for name, part in zip(("h_u", "h_v"), found, strict=True)}


def taken_apart(
    field: str, inputs: Inputs, steps: ArrayLike, computed: dict[str, np.ndarray] | None = None
) -> dict[str, np.ndarray]:
    """Return {component: (truncation, argument, roundoff, total)} over arrays of points or of steps.

    inputs: u, v, k_u, k_v by name. computed: {component: differences} in place of the kernel's.
    """
    names = ("u", "v", "k_u", "k_v", "epsilon")
    at = dict(zip(names, np.broadcast_arrays(*(inputs[name] for name in names[:-1]), steps), strict=True))
    where, given = _split(field)
    slope, exact = in_balls(gradient(HEIGHT_FIELDS[field]), inputs), in_balls(central(HEIGHT_FIELDS[field]), at)
    moved, found = in_balls(given, at | in_float64(where, at)), computed or by_the_kernel(field, at)
    pairs = dict.fromkeys(found, ((exact, slope), (moved, exact), (found, moved), (found, slope)))
    return {c: np.array([signed_distance(a[c], b[c]) for a, b in both]) for c, both in pairs.items()}


def parts(case: Case, steps: ArrayLike = STEPS, computed: np.ndarray | None = None) -> Parts:
    """Return the Parts of a case over the steps; `computed` replaces the kernel's differences."""
    steps = np.asarray(steps, np.float64)
    found = taken_apart(case.field, case.inputs, steps, None if computed is None else {case.component: computed})
    slope = in_balls(gradient(HEIGHT_FIELDS[case.field]), case.inputs)[case.component].item()
    truncation, argument, roundoff, total = found[case.component]
    return Parts(steps, truncation, argument, roundoff, total, float(slope), *_factors(case))


def _factors(case):
    lines = in_balls(factors(HEIGHT_FIELDS[case.field]), case.inputs)
    sines = [abs(float(lines[name].item())) if name in lines else 1.0 for name in ("sin_u", "sin_v")]
    return sines if case.component == "h_u" else sines[::-1]


SMOOTH = (0.31, 0.47)
_K = (1, 2, 4, 8, 16, 32, 64, 128, 256, 512)

CASES = (
    Case("steep", "sine", 8.0, 4.0, 0.61, 0.125),
    *(Case(f"sine, k = {k}", "sine", k, 4.0, *SMOOTH) for k in _K),
    *(Case(f"rings, k_v = {k}", "rings", 8.0, k, *SMOOTH, "h_v") for k in (4, 64)),
    Case("ridges", "ridges", 8.0, 4.0, *SMOOTH),
    *(Case(f"crease, δ = {d:g}", "ridges", 8.0, 4.0, 0.375 + d, 0.47, "h_u", "crease", (0.375 + d) - 0.375)
      for d in (1e-2, 1e-4, 1e-6, 1e-8)),
    *(Case(f"{field}, pole, v = {v:g}", field, 8.0, 4.0, 0.31, v, "h_v", "pole", v)
      for field in ("sine", "ridges", "rings") for v in (0.0, 1e-5, 1e-2) if (field, v) != ("ridges", 0.0)),
    *(Case(f"seam, k = {k:g}", "sine", k, 4.0, 1e-4, 0.47, "h_u", "seam", 1e-4) for k in (8.0, 7.0, 7.3)),
)  # fmt: skip
"""The places: smooth ones for k from 1 to 512, beside a crease, at the pole's border, beside the seam."""
