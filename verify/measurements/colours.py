"""Float64's errors from B's hit to the colour, whose bounds Coq proves: the printed stages against balls."""

import numpy as np
from sympy import lambdify

from proofs.engine.claim import Rounded
from proofs.engine.theorem import all_theorems
from verify.checkers.measurements import Measurement, measures
from verify.evaluate.arrays import distance, in_balls, in_float64

SEED, SAMPLES = 27, 300


def _inputs(random, claim):
    """Return float64 inputs that a stage's hypotheses allow: a B near a ray, a tangent gradient, a light, weights."""
    values = dict(
        zip((s.name for s in claim.program.inputs), random.uniform(0, 1, len(claim.program.inputs)), strict=True)
    )
    if claim.name == "hit":
        eye = np.array([0, 0, values["eye"]])
        toward = np.array([values["x"], values["y"], 0]) - eye
        toward /= np.linalg.norm(toward)
        across = np.cross(toward, random.normal(size=3))
        across *= random.uniform(0, 0.95) / np.linalg.norm(across)
        size = 10.0 ** random.uniform(-3, 0)
        center = eye + size * (10.0 ** random.uniform(0.5, 4) * toward + across)
        values |= dict(zip(("ball_center_x", "ball_center_y", "ball_center_z"), center, strict=True))
        values |= {"ball_radius": size, "ball_on": 1.0}
    if claim.name == "normal":
        normal = random.normal(size=3)
        normal /= np.linalg.norm(normal) * (1 - 2.0**-40)
        tangent = np.cross(normal, random.normal(size=3)) * 10.0 ** random.uniform(-6, 6)
        for axis, n, g in zip("xyz", normal, tangent, strict=True):
            values |= {f"normal_{axis}": n, f"g_{axis}": g}
    return values


def claims() -> dict[str, Rounded]:
    """Return {stage: what is claimed of it}."""
    return {claim.name: claim for claim in all_theorems()["colour_accuracy"].rounded if isinstance(claim, Rounded)}


@np.errstate(divide="ignore", invalid="ignore")
def shares(claim: Rounded, random: np.random.Generator, samples: int) -> list[float]:
    """Return how far a stage's results are off, over their bounds; infinite where what loses nothing is off."""
    stage = claim.program.keep(*(output for output, _ in claim.bounds))
    drawn = [_inputs(random, claim) for _ in range(samples)]
    inputs = {s.name: np.array([values[s.name] for values in drawn]) for s in stage.inputs}
    computed, exact, ratios = in_float64(stage, inputs), in_balls(stage, inputs), []
    for output, bound in claim.bounds:
        off = distance(computed[output.name], exact[output.name])
        most = lambdify(stage.inputs, bound.doit())(*inputs.values())
        ratios += np.where(off > 0, off / most, 0.0).tolist()
    return ratios


@measures("colour_accuracy", false={"within a tenth of it": {"share": 0.1}})
def stages(share: float = 1.0) -> Measurement:
    """Measure every stage at random, the normal with gradients of all sizes."""
    random = np.random.default_rng(SEED)
    return Measurement(
        np.concatenate([shares(claim, random, SAMPLES) for claim in claims().values()]),
        seed=SEED,
        bound=share,
        quantity="how far a stage's result is off, over its bound",
    )
