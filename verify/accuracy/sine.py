"""Certified error of the kernels' sine and cosine of half-turns of a product, in units of 2⁻⁵³.

Over boxes of the reduced argument r, 0 ≤ r ≤ 1/4 + 2⁻³⁰; the rest is by symmetry. The reduction is exact, but for the
rounding of r, where product_error is added. The error is at most that of the rounded lines, of their polynomial, as it
stands with its float64 coefficients, and of the rounding of r.
"""

import math
from functools import cache
from itertools import zip_longest

import numpy as np
from flint import arb, ctx, fmpq
from sympy import Poly, Rational, S, Symbol

from proofs.engine.program import Program, chain
from proofs.formulas import elementary as e
from proofs.formulas.enclosed import RULES
from renderer.operations import UNIT
from verify.accuracy.base_errors import OverBoxes, boxes, run
from verify.evaluate.arrays import distance, in_balls, in_float64

END, PIECES = 2.0**-2 + 2.0**-30, 2000  # |product − quarters/2| ≤ 1/4, and |product_error| < 2^-30
ROOM = 1 + 2.0**-40  # for the roundings of what is added up here
SIGNS = {e.sine_near: (0, 1, 0, -1), e.cosine_near: (1, 0, -1, 0)}
"""{line: the signs of its function's derivatives at 0, which repeat themselves}"""


def departure(near: Symbol, program: Program) -> float:
    """Return a bound of the distance of a line's polynomial from its function up to END, by the Taylor series."""
    coefficients = Poly(program.expand(near, until=(e.remainder,)), e.remainder).all_coeffs()[::-1]
    with ctx.workprec(160):
        taylor = [SIGNS[near][n % 4] * arb.pi() ** n / arb(n).fac() for n in range(len(coefficients) + 2)]
        apart = [t - arb(fmpq(int(c.p), int(c.q))) for t, c in zip_longest(taylor, coefficients, fillvalue=S.Zero)]
        sizes = [abs(difference) * arb(END) ** n for n, difference in enumerate(apart)]
        return float(sum(sizes[:-2]) + 2 * sum(sizes[-2:]))  # of the terms that are left out each is below half of one


@cache
def pieces(off: int = 0) -> list[tuple[arb, arb, arb]]:
    """Return pieces of r, and how far sine and cosine are off there at most, whatever r was reduced from.

    off: by how many units in its last place a coefficient of the cosine is another one: a false variant.
    """
    first = e.cosine_series[0]
    changed = {first: first + off * Rational(math.ulp(float(first)))}
    program = chain("near", {s: e.reduction[s].xreplace(changed) for s in (e.z, e.sine_tail, *SIGNS)})
    ends = np.linspace(0, END, PIECES + 1)
    scope, rounded = run(program, {"remainder": OverBoxes(boxes(ends))}), np.spacing(ends[1:]) / 2
    totals = []
    for near, other in (SIGNS, reversed(SIGNS)):  # each is the other's slope
        steepest = math.pi * scope[other.name].size.size
        totals.append(scope[near.name].error.size + steepest * rounded + departure(near, program))
    most = np.max(totals, axis=(0, 1)) / UNIT * ROOM
    return [(arb(low), arb(high), arb(each)) for low, high, each in zip(ends, ends[1:], most, strict=False)]


def errors(points: np.ndarray) -> np.ndarray:
    """Return the larger error of sine and cosine, measured, at an array of r, of products that round."""
    factor = np.random.default_rng(3).uniform(1, 2, points.shape)
    inputs, off = {"x": points / factor, "y": factor}, np.zeros(points.shape)
    for program in (RULES["enclosed_sine"], RULES["enclosed_cosine"]):
        (ours,), (exact,) = in_float64(program, inputs).values(), in_balls(program, inputs).values()
        off = np.maximum(off, distance(ours, exact))
    return off / UNIT
