"""The exact gradient in float64 against balls: as a function of the chart point, and of the image point.

Errors are counted in units of π max(1, |k|) 2^-53: that is the rounding of one number as large as the gradient can be.
"""

import math
from typing import NamedTuple

import numpy as np
from flint import arb, ctx
from sympy import lambdify

from proofs.engine.program import chain
from proofs.formulas import symbols
from proofs.formulas.camera import angles_on_a
from proofs.formulas.chart import chart
from proofs.formulas.half_turns import ordinary
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from renderer import Scene, exact, gradient_at
from renderer.generate.kernels import function_of
from verify.benchmark.methods.algebraic import algebraic_gradient
from verify.evaluate.balls import Balls

BITS, UNIT, SMALLEST = 1200, 2.0**-53, 1e-280
GENERAL, ALGEBRAIC = 8.0, 8.0  # the bounds: 8, and 8 (1 + k)


class Worst(NamedTuple):
    """The largest error over its unit, and where."""

    units: float
    where: str
    points: int


def _units(computed, ball, k):
    """Return |computed − exact|/(π max(1, |k|) 2^-53), from the ball's far end."""
    if not math.isfinite(computed):
        return math.inf
    return float(abs(arb(computed) - ball).upper()) / (math.pi * max(1.0, abs(k)) * UNIT)


def wave_number_pairs(rng, count=24):
    """Return wave numbers of every kind up to 2^20 in magnitude: whole, real, negative, zero, the largest."""
    pairs = [(8.0, 4.0), (7.3, -3.1), (0.0, 5.0), (3.0, 0.0), (-64.0, 64.0), (2.0**20, -(2.0**20)), (0.25, 1e-5)]
    pairs += [tuple(float(s * 2.0**p) for s, p in zip(rng.choice([-1, 1], 2), rng.uniform(-3, 20, 2), strict=True))
              for _ in range(count)]  # fmt: skip
    return pairs + [tuple(float(k) for k in rng.integers(-(2**20), 2**20, 2)) for _ in range(count)]


def chart_points(rng, k_u, k_v, count):
    """Return u ∈ [0, 1), v ∈ [0, 1]: at random, and floats beside m/k. None is so small that ku underflows."""
    u, v = rng.random(count), rng.random(count)
    half = count // 2
    for values, k in ((u, abs(k_u)), (v, abs(k_v))):
        if k >= 1:
            values[:half] = np.floor(rng.random(half) * k) / k
            values[:half] = np.nextafter(values[:half], rng.choice([0.0, 0.5, 1.0], half))
    u, v = (np.where(c < SMALLEST, 0.0, c) for c in (u, v))
    return np.minimum(u, np.nextafter(1, 0)), v


def worst_at_chart_points(field, seed=11, each=16, form=None):
    """Return the Worst of the general exact gradient of a field over all wave numbers; form: another method's."""
    rng, balls, worst, points = np.random.default_rng(seed), Balls(gradient(HEIGHT_FIELDS[field])), (0.0, ""), 0
    for k_u, k_v in wave_number_pairs(rng):
        u, v = chart_points(rng, k_u, k_v, each)
        computed = np.array((form or _ours)(Scene(field=field, ku=k_u, kv=k_v), u, v))
        for i in range(each):
            exact_lines, undecided = balls({"u": u[i], "v": v[i], "k_u": k_u, "k_v": k_v}, 300)
            if undecided:
                raise ValueError(f"{field}: 300 bits leave {sorted(undecided)} open at u = {u[i]}, v = {v[i]}")
            with ctx.workprec(300):
                for name, k, value in (("h_u", k_u, computed[0, i]), ("h_v", k_v, computed[1, i])):
                    units = _units(float(value), exact_lines[name], k)
                    worst = max(worst, (units, f"{name} at u = {u[i]}, v = {v[i]}, k = ({k_u:g}, {k_v:g})"))
        points += each
    return Worst(*worst, points)


def _ours(scene, u, v):
    return gradient_at(scene, u, v, exact("general"))


def rounded_product(scene, u, v):
    """Return the gradient by the same formulas with sin(πku) of libm: the argument is rounded before the sine."""
    slopes = [ordinary(slope) for slope in HEIGHT_FIELDS[scene.field].gradient()]
    code = lambdify((symbols.u, symbols.v, symbols.k_u, symbols.k_v), slopes, "numpy")
    return [np.broadcast_to(slope, u.shape) for slope in code(u, v, scene.ku, scene.kv)]


def image_gradient(field, k_u, k_v):
    """Return the function (x, y, eye, radius) → (h_u, h_v): the algebraic form's lines on arrays, as the kernels'."""
    program = chain(f"image_gradient_{field}", angles_on_a, algebraic_gradient(HEIGHT_FIELDS[field], k_u, k_v))
    code, names = function_of(program), [s.name for s in program.inputs]

    def run(**values):
        values |= {"k_u": float(k_u), "k_v": float(k_v)}
        with np.errstate(all="ignore"):  # both branches of a selection are computed
            return [np.broadcast_to(c, values["x"].shape) for c in code(*(values[name] for name in names))]

    return run


def image_points(rng, eye, radius, count):
    """Return image points with 1 − (ρ/ρ_s)² ≥ 0.1: spread over the disc, and toward the pole down to sin φ = 1e-150."""
    rim = eye * radius / math.sqrt((eye - radius) * (eye + radius))
    rho = rim * math.sqrt(0.9) * np.sqrt(rng.random(count)) * (1 - 1e-12)
    near = np.arange(count) % 2 == 0
    # Near the pole ρ = e R sin φ/(e − R cos φ), which is e R sin φ/(e − R) to first order.
    sines = 10.0 ** rng.uniform(-149.9, -1, count)
    toward_pole = np.minimum(eye * radius * sines / (eye - radius), rho)
    rho = np.where(near & (toward_pole > 2e-150 * eye), toward_pole, rho)
    angle = rng.uniform(-math.pi, math.pi, count)
    return rho * np.cos(angle), rho * np.sin(angle)


RATIOS = (1e-6, 1e-3, 0.25, 0.5, 0.9, 1 - 1e-6, 1 - 1e-9)


def worst_at_image_points(field, seed=12, each=20, wave_numbers=((2, 1), (8, 4), (-8, 3), (64, 64), (0, 5))):
    """Return the Worst of the algebraic gradient, in units of (1 + k) π k 2^-53, over scales R/e and wave numbers."""
    rng, worst, points = np.random.default_rng(seed), (0.0, ""), 0
    balls = Balls(chain("from_image", angles_on_a, chart, gradient(HEIGHT_FIELDS[field])))
    for ratio in RATIOS:
        for k_u, k_v in wave_numbers:
            k_v = k_v / 2 if field == "rings" else k_v
            k = max(abs(k_u), abs(k_v)) if field != "rings" else 2 * abs(k_v)
            given = {"eye": 1 / ratio, "radius": 1.0}
            x, y = image_points(rng, **given, count=each)
            computed = image_gradient(field, k_u, k_v)(x=x, y=y, **given)
            for i in range(each):
                lines, _ = balls(given | {"x": x[i], "y": y[i], "k_u": k_u, "k_v": k_v}, BITS)
                with ctx.workprec(BITS):
                    units = max(_units(float(c[i]), lines[n], k) for c, n in zip(computed, ("h_u", "h_v"), strict=True))
                worst = max(worst, (units / (1 + k), f"x = {x[i]}, y = {y[i]}, R/e = {ratio}, k = ({k_u}, {k_v:g})"))
            points += each
    return Worst(*worst, points)
