"""The proved bounds of the central difference's error, as programs: what is drawn behind a measured U-curve.

The same expressions as the theorems', for a field that swings at `frequency` half-turns per unit of u or v.
"""

from sympy import Rational, pi

from proofs.engine.program import Program
from proofs.formulas.symbols import epsilon, real, v

frequency, steepest = real("frequency steepest")
unit, evaluation, argument = real("unit evaluation argument")
truncation, rounding, apart = real("truncation rounding apart")

truncation_bound = Program(
    "truncation_bound", (epsilon, frequency), ((truncation, Rational(1, 6) * epsilon**2 * (pi * frequency) ** 3),)
)
"""ε²/6 · (πk)³, where no crease, seam or pole lies within ε. Theorem: truncation_bound."""

clamped_bound = Program(
    "clamped_bound",
    (epsilon, v, frequency),
    ((truncation, Rational(1, 6) * (epsilon**2 + 2 * epsilon * v - 2 * v**2) * (pi * frequency) ** 3),),
)
"""(ε² + 2εv − 2v²)/6 · (πk)³ for the difference clamped at the pole, 0 ≤ v < ε, of a field that is odd about v = 0 up
to v + ε. Theorem: clamped_difference_of_odd."""

rounding_bound = Program(
    "rounding_bound",
    (epsilon, steepest, unit, evaluation, argument),
    ((rounding, (evaluation + steepest * argument) * (1 + unit) ** 2 / epsilon + steepest * (2 * unit + unit**2)),),
)
"""(η + Lα)(1 + μ)²/ε + L(2μ + μ²), L = sup|h'|. Theorem: roundoff_bound."""

crease_bound = Program("crease_bound", (frequency,), ((apart, 2 * pi * frequency),))
"""2πk: a difference quotient and a slope are each at most L = πk in size (the mean value theorem), so they are at most
2L apart, whatever lies within ε."""

slope_bound = Program("slope_bound", (frequency,), ((steepest, pi * frequency),))
"""L = πk."""

BOUNDS = (truncation_bound, clamped_bound, rounding_bound, crease_bound, slope_bound)
"""What is drawn behind a measured U-curve."""
