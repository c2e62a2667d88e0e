"""Numbers of the seed's cells and pictures, computed again and looked at; numbers only, for the ledger."""

import math
from collections.abc import Callable
from unittest.mock import Mock, patch

import numpy as np

from book.drawing.registry import Drawing, figure
from book.figures.chapter_scene import SIZE, numeric, symbolic
from proofs.formulas.bump import normal_by_beta, perturbed
from proofs.formulas.chart import seed_chart
from proofs.formulas.symbols import normal
from renderer import Light, Scene, central, exact, gradient_at, pixel, render
from renderer.generate.kernels import function_of
from renderer.picture.differences import difference_on_a, distance_on_a
from renderer.picture.facts import SMOOTH_POINT
from renderer.picture.views import to_bytes
from verify.accuracy.orders import enclosed_slope
from verify.benchmark.baselines.seed_loops import seed_program, seed_scene

BETA, STEP = 0.35, 1e-7  # the seed's own, in its Cell 5
PIXEL = (90, 120)  # on sphere A, off every clamp
FIRST_LEVEL = 0.5 / 255  # what rounds to the first of 255 levels
SMALL = 128
CLIFF = (1e-10, 1e-12, 1e-14)  # steps at which the error of a difference grows again


def calls(gradient: Callable, holder: dict, *names: str) -> int:
    """Return how often one of the seed's gradients, at a chart point, calls the functions of these names."""
    counted = {name: Mock(wraps=holder[name]) for name in names}
    with patch.dict(holder, counted):
        gradient(0.3, 0.4, seed_scene(Scene()))
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
    closed, here, there, aside = (
        np.array(of(*normals, *g, beta))
        for of, beta in ((slope, BETA), (bump, BETA), (bump, BETA + STEP), (bump, BETA + 1e-200j))
    )
    return np.abs(closed - (there - here) / STEP).max(), np.abs(closed - aside.imag / 1e-200).max()


def image_slope_ratio() -> float:
    """Return how many times the error of a central difference of red in β falls from the step 1e-2 to 1e-3."""

    def difference(step):
        high, low = (pixel(Scene(beta=BETA + sign * step), SIZE, SIZE, *PIXEL).rgb[0] for sign in (1, -1))
        return (high - low) / (2 * step)

    finest = (4 * difference(5e-5) - difference(1e-4)) / 3  # Richardson: fourth order
    return abs(difference(1e-2) - finest) / abs(difference(1e-3) - finest)


@figure(record="frames")
def seed_times(record: dict) -> Drawing:
    """Time of the seed's loops by a central difference over the exact time; numbers only."""
    times = record["numbers"]
    return Drawing(numbers={"ratio_128": times["seed_central_128_1_ms"] / times["seed_exact_128_1_ms"]})


@figure
def seed_cells() -> Drawing:
    """The seed's cells, done again: counts, checks of derivatives, a chart point, a crease and the cliff."""
    one_sided, complex_step = normal_derivative_errors()
    u, v = chart_point(0.4, 0.35)
    program, scene = seed_program(), seed_scene(Scene())
    ways = {"central": program.grad_numeric, "exact": program.grad_exact}
    central_calls, exact_calls = (calls(way, vars(math), "sin", "cos") for way in ways.values())
    slope, *others = (gradient_at(Scene(), *SMOOTH_POINT, method)[0] for method in (exact(), *map(central, CLIFF)))
    numbers = {
        "heights": {name: calls(way, way.__globals__, "height1") for name, way in ways.items()},
        "trigonometric_ratio": central_calls / exact_calls,
        "one_sided": one_sided,
        "complex_step": complex_step,
        "u_of_the_normal": u,
        "v_of_the_normal": v,
        "slope_on_crease": abs(program.grad_exact(0.125, SMOOTH_POINT[1], scene)[0]),
        "image_slope_ratio": image_slope_ratio(),
        "cliff": {f"{eps:.0e}": abs(other - slope) / abs(slope) for eps, other in zip(CLIFF, others, strict=True)},
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
    frames = ((eps, numeric("sine", eps=eps)) for eps in 10.0 ** -np.arange(8, 17))
    off = ((eps, np.abs(difference_on_a(frame, symbolic("sine"))).max()) for eps, frame in frames)
    return next(eps for eps, largest in off if 100 * largest >= FIRST_LEVEL)


def clamp_taken(eps: float) -> float:
    """Return the share of A's pixels whose v ± ε lies in the chart and whose rounded span is below 2ε all the same."""
    v = symbolic().data_on_a["v"]
    v = v[(v - eps > 0) & (v + eps < 1)]
    return np.mean((v + eps) - (v - eps) < 2 * eps)


def lit_from_behind() -> dict[str, int]:
    """Return how many of A's pixels face away from a light behind it, and how many of them its highlight shows."""
    numbers = {}
    for p in (2, 32):
        frame = render(Scene(kd=0, ka=0, beta=0, shininess=p, ball=False, lights=[Light((10, 0, -6))]), SIZE, SIZE)
        unlit = frame.rgb[frame.light_cosines(0) < 0].max(axis=1)
        numbers |= {"unlit": unlit.size, f"shining_{p}": sum(unlit > 2 * FIRST_LEVEL)}
    return numbers


@figure
def seed_pictures() -> Drawing:
    """The seed's words on its pictures against the pictures: limits, what an eye sees, where the creases part."""
    right, on_a = symbolic(), symbolic().stage.on_a
    small, large = numeric(eps=1e-3), numeric(eps=1e-2)
    levels = np.abs(to_bytes(small.rgb).astype(int) - to_bytes(right.rgb))[on_a].max(axis=1)
    h_u, h_v = (right.data_on_a[name] for name in ("h_u", "h_v"))
    sum_of_slopes, length = np.abs(h_u) + np.abs(h_v), np.hypot(h_u, h_v)
    steps = (1e-2, 1e-3, 1e-4)
    sine = [distance_on_a(numeric("sine", eps=eps), symbolic("sine"))[1] for eps in steps]
    numbers = {
        "off_a": np.abs(large.rgb - right.rgb)[~on_a].max(),
        "levels_changed": np.mean(levels > 0),
        "sum_over_length": np.max(sum_of_slopes[length > 0] / length[length > 0]),
        "kink_share": np.mean(right.kink[on_a]),
        "straddling_share": np.mean(large.straddling[on_a]),
        "straddled_without_flag": np.mean(~right.kink[large.straddling & on_a]),
        "sine_rms_slope": enclosed_slope(steps, sine),
        "first_visible": first_visible_step(),
        "clamp_1e-3": clamp_taken(1e-3),
        "clamp_1e-6": clamp_taken(1e-6),
    }
    return Drawing(numbers=numbers | flat_limits() | lit_from_behind())
