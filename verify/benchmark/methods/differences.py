"""Differences of higher order, as straight-line programs like those of `proofs.formulas.finite_difference`.

Each is Σ wᵢ (h(u + cᵢε) − h(u − cᵢε))/2cᵢε. No wrapping, no clamping: for points that keep clear of the chart's ends.
"""

from sympy import Rational, prod

from proofs.engine.program import Program
from proofs.formulas.symbols import epsilon, h_u, h_v, k_u, k_v, real, u, v


def extrapolated(steps):
    """Return the weight of each step cᵢ that leaves the error's terms ε², ε⁴ … out: Lagrange's at 0, in c²."""
    return {c: prod(d**2 / (d**2 - c**2) for d in steps if d != c) for c in steps}


def extrapolated_difference(name, field, steps):
    """Return the program (u, v, k_u, k_v, ε) → h_u, h_v that extrapolates central differences of steps cε to 0."""
    lines, sums = [], {h_u: 0, h_v: 0}
    for number, (step, weight) in enumerate(extrapolated(steps).items()):
        for result, coordinate in ((h_u, u), (h_v, v)):
            above, below, quotient = real(
                " ".join(f"{kind}_{result}_{number}" for kind in ("above", "below", "quotient"))
            )
            lines += [
                (above, field.expression.xreplace({coordinate: coordinate + step * epsilon})),
                (below, field.expression.xreplace({coordinate: coordinate - step * epsilon})),
                (quotient, (above - below) / (2 * step * epsilon)),
            ]
            sums[result] += weight * quotient
    return Program(f"{name}_{field.name}", (u, v, k_u, k_v, epsilon), (*lines, *sums.items()), (h_u, h_v))


def central6(field):
    """Return the sixth-order central difference: steps ε, 2ε, 3ε; 12 height evaluations."""
    return extrapolated_difference("central6", field, [Rational(n) for n in (1, 2, 3)])


def richardson(field):
    """Return Richardson's extrapolation of steps ε, ε/2, ε/4, ε/8: eighth order; 16 height evaluations."""
    return extrapolated_difference("richardson", field, [Rational(1, 2**n) for n in range(4)])
