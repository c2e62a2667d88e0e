"""What the seed's cells compute and say of its pictures, done again and looked at; numbers only, for the ledger."""

import math
from collections.abc import Callable, Iterable
from types import ModuleType
from unittest.mock import Mock, patch

import numpy as np

from book.drawing.registry import Drawing, figure
from book.figures.chapter_scene import SIZE, numeric, symbolic
from proofs.formulas.bump import normal_by_beta, perturbed
from proofs.formulas.chart import seed_chart
from proofs.formulas.symbols import normal
from renderer import Scene, central, exact, gradient_at, pixel, render
from renderer.generate.kernels import function_of
from renderer.picture.differences import difference_on_a, distance_on_a
from renderer.picture.facts import SMOOTH_POINT
from renderer.picture.views import to_bytes
from verify.accuracy.orders import enclosed_slope
from verify.benchmark.baselines import seed_loops
from verify.records import RECORDS, read

BETA, STEP = 0.35, 1e-7  # the seed's own, in its Cell 5
PIXEL = (90, 120)  # on sphere A, off every clamp
FIRST_LEVEL = 0.5 / 255  # what rounds to the first of 255 levels
SMALL = 128
SMALL_STEPS = 10.0 ** -np.arange(8, 17)


def calls(gradient: Callable, holder: ModuleType, names: Iterable[str], eps: float = 1e-3) -> int:
    """Return how often one of the seed's gradients, at a chart point, calls the functions of these names."""
    counted = {name: Mock(wraps=getattr(holder, name)) for name in names}
    with patch.multiple(holder, **counted):
        gradient(Scene(), 0.3, 0.4, eps)
    return sum(function.call_count for function in counted.values())


def chart_point(n_x: float, n_y: float) -> tuple[float, ...]:
    """Return (u, v) of the unit normal with these components, n_z > 0."""
    values = dict(zip(normal, (n_x, n_y, math.sqrt(1 - n_x**2 - n_y**2)), strict=True))
    return tuple(float(seed_chart.expand(output).evalf(subs=values)) for output in seed_chart.outputs)


def normal_derivative_errors() -> tuple[float, float]:
    """Return the worst component of ∂N'/∂β, by a one-sided and by a complex step, against the closed form."""
    samples = np.random.default_rng(5).normal(size=(2000, 2, 3))  # in the seed's order: N, g, N, g, …
    normals, g = samples[:, 0].T, 4 * samples[:, 1].T
    normals = normals / np.linalg.norm(normals, axis=0)
    bump, slope = (function_of(program) for program in (perturbed, normal_by_beta))
    closed, here = np.array(slope(*normals, *g, BETA)), np.array(bump(*normals, *g, BETA))
    one_sided = (np.array(bump(*normals, *g, BETA + STEP)) - here) / STEP
    complex_step = np.array(bump(*normals, *g, BETA + 1e-200j)).imag / 1e-200
    return np.abs(closed - one_sided).max(), np.abs(closed - complex_step).max()


def image_slope_ratio() -> float:
    """Return how many times the error of a central difference of red in β falls from the step 1e-2 to 1e-3."""

    def difference(step):
        high, low = (pixel(Scene(beta=BETA + sign * step), SIZE, SIZE, *PIXEL).rgb[0] for sign in (1, -1))
        return (high - low) / (2 * step)

    finest = (4 * difference(5e-5) - difference(1e-4)) / 3  # Richardson: fourth order
    first, second = (abs(difference(step) - finest) for step in (1e-2, 1e-3))
    return first / second


@figure("seed_times", data=[RECORDS["frames"].path])
def seed_times() -> Drawing:
    """How many times as long the seed's loops take by a central difference as exactly; numbers only."""
    times = read("frames")["numbers"]
    return Drawing(numbers={"ratio_128": times["seed_central_128_1_ms"] / times["seed_exact_128_1_ms"]})


@figure("seed_cells")
def seed_cells() -> Drawing:
    """The seed's cells, done again: counts, checks of derivatives, a chart point, a crease and the cliff."""
    one_sided, complex_step = normal_derivative_errors()
    u, v = chart_point(0.4, 0.35)
    slope = gradient_at(Scene(), *SMOOTH_POINT, exact())[0]
    gradients = {"central": seed_loops.central_gradient, "exact": seed_loops.exact_gradient}
    trigonometric = {name: calls(gradient, math, ["sin", "cos"]) for name, gradient in gradients.items()}
    relative = {}
    for eps in (1e-8, 1e-10, 1e-12, 1e-14):
        error = abs(gradient_at(Scene(), *SMOOTH_POINT, central(eps))[0] - slope)
        relative[f"{eps:.0e}"] = error / abs(slope)
    numbers = {
        "heights": {name: calls(g, seed_loops, ["height_of_field"]) for name, g in gradients.items()},
        "trigonometric_ratio": trigonometric["central"] / trigonometric["exact"],
        "one_sided": one_sided,
        "complex_step": complex_step,
        "u_of_the_normal": u,
        "v_of_the_normal": v,
        "slope_on_crease": abs(seed_loops.exact_gradient(Scene(), 0.125, SMOOTH_POINT[1])[0]),
        "image_slope_ratio": image_slope_ratio(),
        "cliff": relative,
    }
    return Drawing(numbers=numbers)


def flat_limits() -> dict[str, float]:
    """Return three pictures' largest or mean difference from the plain sphere, and two differences' errors."""
    flat, no_height, high = (
        render(scene, SMALL, SMALL)
        for scene in (Scene(beta=0.0), Scene(field="sine", ku=0, beta=1.5), Scene(field="sine", beta=1.5))
    )
    frames = (render(high.scene, SMALL, SMALL, central(eps), stage=high.stage) for eps in (1e-3, 1e-4))
    error, finer = (np.abs(frame.rgb - high.rgb).max() for frame in frames)
    return {
        "no_height": np.abs(no_height.rgb - flat.rgb).max(),
        "called_no_height": np.abs(high.rgb - flat.rgb).mean(),
        "high_error": error,
        "high_error_ratio": error / finer,
    }


def first_visible_step() -> float:
    """Return the largest step from 1e-8 downwards at which |ΔI| × 100 reaches the first level of a linear canvas."""
    for eps in SMALL_STEPS:
        frame = render(Scene(field="sine"), SIZE, SIZE, central(eps), stage=symbolic("sine").stage)
        if 100 * np.abs(difference_on_a(frame, symbolic("sine"))).max() >= FIRST_LEVEL:
            return eps
    raise ValueError("no step of these reaches the first level")


def clamp_taken(eps: float) -> float:
    """Return the share of A's pixels whose v ± ε lies in the chart and whose rounded span is below 2ε all the same."""
    v = symbolic().surface_data["v"][symbolic().stage.on_a]
    v = v[(v - eps > 0) & (v + eps < 1)]
    return np.mean((v + eps) - (v - eps) < 2 * eps)


@figure
def seed_pictures() -> Drawing:
    """The seed's words on its pictures against the pictures: limits, what an eye sees, where the creases part."""
    on_a = symbolic().stage.on_a
    small, large = numeric(eps=1e-3), numeric(eps=1e-2)
    levels = np.abs(to_bytes(small.rgb).astype(int) - to_bytes(symbolic().rgb))[on_a].max(axis=1)
    h_u, h_v = symbolic().surface_data["h_u"][on_a], symbolic().surface_data["h_v"][on_a]
    sum_of_slopes, length = np.abs(h_u) + np.abs(h_v), np.hypot(h_u, h_v)
    steps = (1e-2, 1e-3, 1e-4)
    sine = [distance_on_a(numeric("sine", eps=eps), symbolic("sine"))[1] for eps in steps]
    straddling = large.straddling & on_a
    numbers = {
        "off_a": np.abs(large.rgb - symbolic().rgb)[~on_a].max(),
        "levels_changed": np.mean(levels > 0),
        "sum_over_length": np.max(sum_of_slopes[length > 0] / length[length > 0]),
        "straddled_without_flag": np.mean(~symbolic().kink[straddling]),
        "sine_rms_slope": enclosed_slope(steps, sine),
        "first_visible": first_visible_step(),
        "clamp_1e-3": clamp_taken(1e-3),
        "clamp_1e-6": clamp_taken(1e-6),
    }
    return Drawing(numbers=numbers | flat_limits())
