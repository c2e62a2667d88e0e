"""The central difference's lines where each has one form: away from the seam and the poles, and at the pole v = 0.

The lines are those of `proofs.formulas.finite_difference`, with floor, Min, Max and the case of the span decided; the
theorems prove each decision about v from the lines themselves. Of u the definition of floor is used: it is 0 on [0, 1).
"""

from collections.abc import Mapping

from sympy import Expr, Max, Min, Piecewise, Rational, Symbol, floor

from proofs.engine.program import Program, chain, evaluated
from proofs.formulas.finite_difference import HEIGHTS, central
from proofs.formulas.height_fields import HEIGHT_FIELDS, HeightField
from proofs.formulas.symbols import epsilon, h_u, h_v, u, v

INSIDE = {(u, v): (0, 1), epsilon: (0, Rational(1, 2))}  # where samples are drawn
nothing_wraps = (epsilon > 0, u - epsilon >= 0, u + epsilon < 1)
nothing_clamps = (epsilon > 0, v - epsilon >= 0, v + epsilon <= 1)
pole_clamps = (epsilon > 0, v >= 0, v - epsilon < 0, v + epsilon <= 1)


@evaluated
def _decided(field, clamped):
    def decide(line):
        line = line.replace(floor, lambda moved: 0)
        line = line.replace(Min, lambda *a: next(e for e in a if e.free_symbols))
        line = line.replace(Max, lambda *a: next(e for e in a if bool(e.free_symbols) is not clamped))
        return line.replace(Piecewise, lambda *branches: branches[clamped][0])

    program = central(field)
    lines = {symbol: decide(line) for symbol, line in program.definitions}
    return Program(program.name, program.inputs, lines, program.outputs)


def inside(field: HeightField) -> Program:
    """Return the central difference where nothing wraps or clamps: `nothing_wraps` and `nothing_clamps`."""
    return _decided(field, clamped=False)


def at_pole(field: HeightField) -> Program:
    """Return the central difference where nothing wraps and v − ε is clamped to 0: `nothing_wraps`, `pole_clamps`."""
    return _decided(field, clamped=True)


@evaluated
def of_heights(heights: Mapping[Symbol, Expr]) -> Program:
    """Return the central difference with its heights given, {h_v_plus: expression, …}; the others are inputs."""
    lines = [(name, heights.get(name, line)) for name, line in central(HEIGHT_FIELDS["sine"]).definitions]
    needed = {name: line for name, line in lines if name in heights or name not in HEIGHTS}
    return chain("central_of_heights", needed, outputs=(h_u, h_v))
