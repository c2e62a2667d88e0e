"""Our elementary functions, which Coq proves, against balls: random arguments, and adversarial ones.

Those lie on and beside the zeros, the quadrants' and the nodes' edges, and are tiny, or large.
"""

from functools import cache

import numpy as np

from proofs.engine.program import Program
from proofs.engine.theorem import all_theorems
from proofs.formulas.symbols import real
from renderer import kernels
from verify.checkers.measurement import Measurement, measures
from verify.evaluate.arrays import distance, in_balls

SEED = 5
MOST = real("most")
KERNELS = {
    "sinpi": lambda x, y: kernels.sinpi(*kernels.two_product(x, y)),
    "cospi": lambda x, y: kernels.cospi(*kernels.two_product(x, y)),
    "angle": lambda x, y: kernels.atan2pi(y, x),
    "exp": kernels.exp,
    "log": kernels.log,
    "power": kernels.power,
}


def _beside(values, count=3):
    """Return float64 numbers and their neighbours on either side; below a power of two these are half as far away."""
    return np.concatenate([values + half * np.spacing(values) / 2 for half in range(-2 * count, 2 * count + 1)])


@cache
def arguments() -> dict[str, tuple[np.ndarray, ...]]:
    """Return {name: arguments of its kernel}, in the order of the program that it stands for."""
    random = np.random.default_rng(SEED)
    spread = random.uniform(-2, 2, 3000), random.uniform(-(2**20), 2**20, 1000), 10.0 ** -np.arange(1.0, 100)
    alone = np.concatenate([*spread, _beside(np.arange(-16, 17) / 8)])
    alone = alone[(alone == 0) | (np.abs(alone) > 1e-285)]
    k = random.integers(1, 65, 800).astype(float)
    creases = _beside(np.floor((k + 1) * random.random(800)) / k)
    waves = random.uniform(-64, 64, 3000), random.uniform(0, 2.0**20, 500), np.resize(k, creases.size)
    factors = np.concatenate([*waves, np.ones_like(alone)]), np.concatenate([random.random(3500), creases, alone])
    nodes = _beside(np.array([5 / 16, 0.5, 0.75, 1.0])), 10.0 ** -np.arange(1.0, 280, 9)
    ratios = np.concatenate([random.random(2000), *nodes])
    ones = np.ones_like(ratios)
    octants = [(s * x, t * y) for x, y in ((ratios, ones), (ones, ratios)) for s in (1, -1) for t in (1, -1)]
    small = 350 * alone[np.abs(alone) <= 2]
    numbers = np.abs(alone)[np.abs(alone) > 1e-90]
    exponents = 10.0 ** random.uniform(-3, 6, 5000)
    bases = np.exp(-np.where(random.random(5000) < 0.5, 50, 707) * random.random(5000) / exponents)
    return {
        "sinpi": factors,
        "cospi": factors,
        "angle": tuple(map(np.concatenate, zip(*octants, strict=True))),
        "exp": (small, random.uniform(-(2.0**-43), 2.0**-43, small.size)),
        "log": (np.concatenate([numbers, numbers**-3]),),
        "power": (bases, exponents),
    }


@np.errstate(divide="ignore", invalid="ignore")
def shares(name: str) -> np.ndarray:
    """Return how far a kernel's results are off, over their bounds; infinite where an exact 0 is missed."""
    claim = next(claim for claim in all_theorems()["elementary_functions"].rounded if claim.name == name)
    program, ((_, bound),) = claim.program, claim.bounds
    both = Program(name, program.inputs, (*program.definitions, (MOST, bound.doit())), (*program.outputs, MOST))
    given = arguments()[name]
    exact, most = in_balls(both, dict(zip((s.name for s in program.inputs), given, strict=True))).values()
    off = distance(KERNELS[name](*given), exact)
    return np.where(off > 0, off / most.astype(float), 0.0)


@measures("elementary_functions", false={"within nine tenths of it": {"share": 0.9}})
def functions(share: float = 1.0) -> Measurement:
    """Every function."""
    found = {name: shares(name) for name in KERNELS}
    return Measurement(
        np.concatenate([*found.values()]),
        seed=SEED,
        bound=share,
        what="how far a function is off, over its bound",
        numbers={name: most.max() for name, most in found.items()},
    )
