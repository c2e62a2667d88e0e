"""What the seed's cells compute, done again away from the picture; numbers only, for the ledger."""

import math
from unittest.mock import patch

import numpy as np

from book.drawing.registry import Drawing, committed, figure
from proofs.formulas.bump import normal_by_beta, perturbed
from proofs.formulas.chart import seed_chart
from proofs.formulas.symbols import normal
from renderer import Scene, central, exact, gradient_at, pixel
from renderer.facts import SMOOTH_POINT
from renderer.generate.kernels import function_of
from verify.benchmark.baselines import seed_loops

FRAMES = "verify/benchmark/results/frames.json"
BETA, STEP = 0.35, 1e-7  # the seed's own, in its Cell 5
PIXEL = (90, 120)  # on sphere A, off every clamp


def calls(gradient, holder, names, eps=1e-3):
    """Return how often one of the seed's gradients, at a chart point, calls the functions of these names."""
    made = []

    def counted(function):
        return lambda *arguments: made.append(function) or function(*arguments)

    with patch.multiple(holder, **{name: counted(getattr(holder, name)) for name in names}):
        gradient(Scene(), 0.3, 0.4, eps)
    return len(made)


def chart_point(n_x, n_y):
    """Return (u, v) of the unit normal with these components, n_z > 0."""
    values = dict(zip(normal, (n_x, n_y, math.sqrt(1 - n_x**2 - n_y**2)), strict=True))
    return tuple(float(seed_chart.expand(output).evalf(subs=values)) for output in seed_chart.outputs)


def normal_derivative_errors():
    """Return the worst component of ∂N'/∂β, by a one-sided and by a complex step, against the closed form."""
    samples = np.random.default_rng(5).normal(size=(2000, 2, 3))  # in the seed's order: N, g, N, g, …
    normals, g = samples[:, 0].T, 4 * samples[:, 1].T
    normals = normals / np.linalg.norm(normals, axis=0)
    bump, slope = (function_of(program) for program in (perturbed, normal_by_beta))
    closed, here = np.array(slope(*normals, *g, BETA)), np.array(bump(*normals, *g, BETA))
    one_sided = (np.array(bump(*normals, *g, BETA + STEP)) - here) / STEP
    complex_step = np.array(bump(*normals, *g, BETA + 1e-200j)).imag / 1e-200
    return np.abs(closed - one_sided).max(), np.abs(closed - complex_step).max()


def image_slope_ratio(steps=(1e-2, 1e-3)):
    """Return how many times the error of a central difference of red in β falls from one step to the next."""

    def difference(step):
        ends = (pixel(Scene(beta=BETA + sign * step), 256, 256, *PIXEL).rgb[0] for sign in (1, -1))
        return float(np.subtract(*ends)) / (2 * step)

    finest = (4 * difference(5e-5) - difference(1e-4)) / 3  # Richardson: fourth order
    first, second = (abs(difference(step) - finest) for step in steps)
    return first / second


@figure("seed_cells", data=[FRAMES])
def seed_cells() -> Drawing:
    """The seed's cells, done again: counts, checks of derivatives, a chart point, a crease and the cliff."""
    one_sided, complex_step = normal_derivative_errors()
    u, v = chart_point(0.4, 0.35)
    slope = float(gradient_at(Scene(), *SMOOTH_POINT, exact())[0])
    times = committed(FRAMES)["numbers"]
    numbers = {
        "heights_central": calls(seed_loops.central_gradient, seed_loops, ["height_of_field"]),
        "heights_exact": calls(seed_loops.exact_gradient, seed_loops, ["height_of_field"]),
        "trigonometric_ratio": calls(seed_loops.central_gradient, math, ["sin", "cos"])
        / calls(seed_loops.exact_gradient, math, ["sin", "cos"]),
        "time_ratio_128": times["seed_central_128_1_ms"] / times["seed_exact_128_1_ms"],
        "one_sided": one_sided,
        "complex_step": complex_step,
        "u_of_the_normal": u,
        "v_of_the_normal": v,
        "slope_on_crease": abs(seed_loops.exact_gradient(Scene(), 0.125, SMOOTH_POINT[1])[0]),
        "image_slope_ratio": image_slope_ratio(),
    }
    for eps in (1e-8, 1e-10, 1e-12, 1e-14):
        error = abs(float(gradient_at(Scene(), *SMOOTH_POINT, central(eps))[0]) - slope)
        numbers[f"cliff_{eps:.0e}"] = error / abs(slope)
    return Drawing(numbers=numbers)
