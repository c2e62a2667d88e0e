"""The central difference's lines where each has one form: away from the seam and the poles, and at the pole v = 0.

The lines are those of `proofs.formulas.finite_difference`, with floor, Min, Max and the case of the span decided; the
theorems prove each decision about v from the lines themselves. Of u the definition of floor is used: it is 0 on [0, 1).
"""

from collections.abc import Mapping

from sympy import Expr, Max, Min, Piecewise, Rational, Symbol, floor

from proofs.engine.program import Program, evaluated
from proofs.formulas.finite_difference import central, h_u_minus, h_u_plus, h_v_minus, h_v_plus
from proofs.formulas.height_fields import HEIGHT_FIELDS, HeightField
from proofs.formulas.symbols import epsilon, u, v

INSIDE = ((u, (0, 1)), (v, (0, 1)), (epsilon, (0, Rational(1, 2))))  # where samples are drawn
nothing_wraps = (epsilon > 0, u - epsilon >= 0, u + epsilon < 1)
nothing_clamps = (epsilon > 0, v - epsilon >= 0, v + epsilon <= 1)
pole_clamps = (epsilon > 0, v >= 0, v - epsilon < 0, v + epsilon <= 1)


@evaluated
def _decided(program, name, lower, span):
    def decide(line):
        line = line.replace(floor, lambda moved: 0)
        line = line.replace(Min, lambda *a: next(e for e in a if e.free_symbols))
        line = line.replace(Max, lambda *a: next(e for e in a if bool(e.free_symbols) is lower))
        return line.replace(Piecewise, lambda *branches: branches[span][0])

    lines = tuple((symbol, decide(line)) for symbol, line in program.definitions)
    return Program(f"{program.name}_{name}", program.inputs, lines, program.outputs)


def inside(field: HeightField) -> Program:
    """Return the central difference where nothing wraps or clamps: `nothing_wraps` and `nothing_clamps`."""
    return _decided(central(field), "inside", lower=True, span=0)


def at_pole(field: HeightField) -> Program:
    """Return the central difference where nothing wraps and v − ε is clamped to 0: `nothing_wraps`, `pole_clamps`."""
    return _decided(central(field), "at_pole", lower=False, span=1)


@evaluated
def of_heights(heights: Mapping[Symbol, Expr]) -> Program:
    """Return the central difference with its heights given, {h_v_plus: expression, …}; the others are inputs."""
    program = central(HEIGHT_FIELDS["sine"])
    all_heights = {name: heights.get(name) for name in (h_u_plus, h_u_minus, h_v_plus, h_v_minus)}
    inputs = {name for name, given in all_heights.items() if given is None}
    inputs |= {s for given in heights.values() for s in given.free_symbols} - {u, v, epsilon}
    given = ((name, all_heights.get(name, line)) for name, line in program.definitions)
    lines = tuple((name, line) for name, line in given if line is not None)
    names = (u, v, epsilon, *sorted(inputs, key=lambda s: s.name))
    return Program("central_of_heights", names, lines, program.outputs)
