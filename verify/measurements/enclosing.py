"""The rules of the enclosing machine, which Coq proves: their counts against exact arithmetic."""

import numpy as np
from flint import arb, ctx

from proofs.engine.program import Program
from proofs.formulas.enclosed import RULES
from renderer.generate.kernels import function_of
from renderer.machines.enclosing import Enclosed
from verify.checkers.measurements import Measurement, measures
from verify.evaluate.balls import Balls

SEED, SAMPLES, BITS = 26, 400, 256


def _operands(random, names):
    """Return random operands: float64 values, their bounds in roundings, {name: an exact number at an end of these}."""
    values = 2.0 ** random.uniform(-20, 20, len(names))
    counts = np.floor(values * 2.0 ** random.uniform(22, 52, len(names)))
    with ctx.workprec(BITS):
        ends = (
            arb((int(sign * count), -53))
            for sign, count in zip(random.choice([-1, 1], len(names)), counts, strict=True)
        )
        return values, counts, {name: arb(v) + end for name, v, end in zip(names, values, ends, strict=True)}


def shares(program: Program, random: np.random.Generator, samples: int) -> list[float]:
    """Return how far a rule's results are off, over their bounds."""
    machine, balls, (output,) = function_of(program), Balls(program), program.outputs
    ratios = []
    for _ in range(samples):
        values, counts, ends = _operands(random, balls.inputs)
        with np.errstate(all="ignore"):  # an exponential may be infinite, and its bound is
            result = machine(*map(Enclosed.counted, values, counts))
        exact = balls(ends, BITS)[output.name]
        with ctx.workprec(BITS):
            off = abs(arb(float(result.value)) - exact)
            within = off.is_zero() or np.isinf(result.bound)
            ratios.append(0.0 if within else float((off / float(result.bound)).upper()))
    return ratios


@measures("enclosing_rules", false={"half a count": {"share": 0.5}})
def rules(share: float = 1.0) -> Measurement:
    """Measure every rule, of exact numbers at the ends of their operands' bounds."""
    random = np.random.default_rng(SEED)
    ratios = [ratio for program in RULES.values() for ratio in shares(program, random, SAMPLES)]
    return Measurement(
        ratios,
        seed=SEED,
        bound=share,
        quantity="how far a result is off, over its bound",
    )
