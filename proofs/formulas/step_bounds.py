"""The proved bounds of the differences' errors, as programs: theorems state them, pages and kernels use them.

They are of a field that swings at `frequency` half-turns per unit of u or v, πk its steepest slope.
"""

from sympy import pi, sqrt

from proofs.engine.program import Program
from proofs.engine.vectors import real
from proofs.formulas.symbols import epsilon, v

TERMS = ("truncation", "argument rounding", "roundoff", "straddling", "one-sided")
"""The parts of the error. Truncation is that of the quotient in exact arithmetic; where a crease or the seam lies
between the samples, or one of them is clamped at a pole, it is straddling or one-sided instead. Argument rounding is
that of u ± ε and v ± ε, roundoff that of the heights and of the quotient."""

frequency, steepest, third_derivative = real("frequency steepest third_derivative")
span, excess, unit, evaluation, argument = real("span excess unit evaluation argument")
truncation, rounding, apart, distance, tent, rest = real("truncation rounding apart distance tent rest")
creases, root_mean_square, best, floor = real("creases root_mean_square best floor")

_third = {third_derivative: (pi * frequency) ** 3}

slope_bound = Program("slope_bound", frequency, {steepest: pi * frequency})
"""L = πk."""

truncation_bound = Program(
    "truncation_bound", (epsilon, frequency), _third | {truncation: epsilon**2 / 6 * third_derivative}
)
"""ε²/6 · (πk)³, where no crease, seam or pole lies within ε. Theorem: truncation_bound."""

forward_bound = Program(
    "forward_bound", (epsilon, frequency), {steepest: pi * frequency, truncation: epsilon / 2 * steepest**2}
)
"""ε/2 · (πk)² of the forward difference, and of the backward one. Theorem: forward_and_fourth_order."""

fourth_bound = Program(
    "fourth_bound", (epsilon, frequency), {steepest: pi * frequency, truncation: epsilon**4 / 30 * steepest**5}
)
"""ε⁴/30 · (πk)⁵ of the fourth-order difference, where no crease, seam or pole lies within 2ε. Theorem:
forward_and_fourth_order."""

clamped_bound = Program(
    "clamped_bound",
    (epsilon, v, frequency),
    _third | {truncation: (epsilon**2 + 2 * epsilon * v - 2 * v**2) / 6 * third_derivative},
)
"""(ε² + 2εv − 2v²)/6 · (πk)³ for the difference clamped at the pole, 0 ≤ v < ε, of a field that is odd about v = 0 up
to v + ε. Theorem: clamped_difference_of_odd."""

crease_bound = Program("crease_bound", frequency, {apart: 2 * pi * frequency})
"""2πk: a difference quotient and a slope are each at most L = πk in size (the mean value theorem), so they are at most
2L apart, whatever lies within ε."""

tent_bound = Program(
    "tent_bound",
    (epsilon, distance, frequency),
    {
        tent: pi * frequency * (1 - distance / epsilon),
        rest: 2 * pi * frequency * (pi * frequency * epsilon) ** 2 / 3,
        truncation: tent + rest,
    },
)
"""πk(1 − δ/ε) + ⅔πk(πkε)² where one crease, at the distance δ < ε, lies between the samples. Theorem:
crease_error_area."""

crease_rms = Program(
    "crease_rms",
    (epsilon, frequency, creases),
    {root_mean_square: pi * frequency * sqrt(creases * epsilon / 3), rest: tent_bound[rest]},
    (root_mean_square, rest),
)
"""πk√(nε/3), the root mean square of the tents at n creases over the chart, and how far the error's may be from it.
Theorem: crease_error_area."""

rounding_bound = Program(
    "rounding_bound",
    (span, steepest, excess, evaluation, argument),
    {rounding: 2 * (evaluation + steepest * argument) * (1 + excess) / span + steepest * excess},
)
"""2(η + Lα)(1 + κ)/S + Lκ, over the span S of the samples, L = sup|h'|. Theorem: roundoff_bound."""

two_roundings = Program("two_roundings", unit, {excess: 2 * unit + unit**2})
"""κ of a rounded difference and quotient, in units of roundoff μ. Theorem: roundoff_bound."""

three_roundings = Program("three_roundings", unit, {excess: (3 * unit + unit**2) / (1 - unit)})
"""κ where the span is rounded as well. Theorem: roundoff_bound."""

best_step = Program(
    "best_step",
    (truncation, best),
    {rounding: 2 * truncation * best**3, floor: 3 * truncation * best**2},
    (rounding, floor),
)
"""The E for which a step is the one at which Tε² + E/ε is least, and that least value. Theorem: best_step."""
