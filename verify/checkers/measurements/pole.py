"""Toward the pole: the seed's frame and chart in float64 against 50 digits, and the stable ones."""

import math
import random
from functools import cache

import mpmath
from sympy import lambdify

from proofs.engine.program import chain
from proofs.formulas.bump import bumped_normal, g
from proofs.formulas.camera import angles_on_a
from proofs.formulas.chart import chart, seed_chart
from proofs.formulas.half_turns import ordinary
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from proofs.formulas.symbols import normal
from proofs.formulas.tangent_frame import seed_frame, tangent_frame
from renderer import Scene, exact
from renderer.gradients import gradient_at
from verify.checkers.measurement import Measurement, measures
from verify.evaluate import Reference

SEED, POINTS, FALLBACK = 20, 200, 1e-4
_field = HEIGHT_FIELDS["ridges"]
_reference = Reference(chain("g", angles_on_a, chart, gradient(_field), bumped_normal, outputs=g))
_scene = Scene()


@cache
def _code(line):
    names = sorted(line.free_symbols, key=str)
    return [n.name for n in names], lambdify(names, ordinary(line), "math")


def _in_float64(program, values):
    """Return {name: float} of a program's lines, evaluated as they stand, with libm."""
    scope = dict(values)
    for symbol, line in program.definitions:
        names, code = _code(line)
        scope[symbol.name] = float(code(*(scope[n] for n in names)))
    return scope


def _tangent_vector(values, h_u, h_v):
    return [h_u * values[f"e_theta_{axis}"] + h_v * values[f"e_phi_{axis}"] for axis in "xyz"]


def _seed_vector(x, y, fallback):
    """Return g as the seed computes it: its root, its chart, its frame, sin πku with a rounded argument."""
    e, r = _scene.eye, _scene.radius
    squared = x * x + y * y + e * e
    t = (e * e - math.sqrt(e * e * r * r - (e * e - r * r) * (x * x + y * y))) / squared
    values = dict(zip((n.name for n in normal), (t * x / r, t * y / r, e * (1 - t) / r), strict=True))
    values |= _in_float64(seed_chart, values) | {"k_u": _scene.ku, "k_v": _scene.kv}
    values |= _in_float64(gradient(_field), values)
    if math.sqrt(max(0.0, 1 - values["normal_z"] ** 2)) > (FALLBACK if fallback else 0):
        return _tangent_vector(_in_float64(seed_frame, values), values["h_u"], values["h_v"])
    return [values["h_u"], values["h_v"], 0.0]


def _stable_vector(x, y):
    """Return g by the chapter's lines: the angles from ρ and t, the chart by atan2, the gradient that draws."""
    values = _in_float64(angles_on_a, {"x": x, "y": y, "eye": _scene.eye, "radius": _scene.radius})
    values |= _in_float64(chart, values)
    h_u, h_v = (float(d) for d in gradient_at(_scene, values["u"], values["v"], exact()))
    return _tangent_vector(_in_float64(tangent_frame, values), h_u, h_v)


@cache
def _worst(sine):
    """Return the largest |g − g at 50 digits| near sin φ = sine: (seed, seed without the fallback, stable)."""
    rng, worst = random.Random(SEED), [0.0, 0.0, 0.0]
    e, r = _scene.eye, _scene.radius
    for _ in range(POINTS):
        angle, near = rng.uniform(-math.pi, math.pi), sine * rng.uniform(1, 1.1)
        rho = e * r * near / (e - r * math.sqrt(1 - near * near))
        x, y = rho * math.cos(angle), rho * math.sin(angle)
        values = {"x": x, "y": y, "eye": e, "radius": r, "k_u": _scene.ku, "k_v": _scene.kv, "beta": _scene.beta}
        right = _reference(values)
        for i, vector in enumerate((_seed_vector(x, y, True), _seed_vector(x, y, False), _stable_vector(x, y))):
            with mpmath.workdps(60):
                off = mpmath.sqrt(sum((right[n.name] - c) ** 2 for n, c in zip(g, vector, strict=True)))
            worst[i] = max(worst[i], float(off))
    return tuple(worst)


def _one_digit(value):
    """Return the number to one digit: more would depend on the machine's libm."""
    return float(f"{value:.0e}")


@measures(
    "pole_accuracy",
    false={"the stable forms lose as much": {"seed_form": 2}, "the fallback helps": {"with_fallback": 1}},
)
def toward_the_pole(seed_form: int = 1, with_fallback: int = 0) -> Measurement:
    """The seed's forms lose digits toward the pole, its fallback all of them; the stable forms none."""
    near, nearer = _worst(1.01e-4), _worst(6e-7)
    stable = max(near[2], nearer[2])
    return Measurement(
        samples=2 * POINTS,
        seed=SEED,
        worst=_one_digit(stable),
        bound=1e-12,
        holds=near[seed_form] > 1e-7 and nearer[seed_form] > 1e-3 and nearer[with_fallback] > 20,
        what="|g − g at 50 digits|, the largest of 200 points, sin φ from 1.01e-4 and from 6e-7, up to a tenth above",
        numbers={
            "seed_near_1e-4": _one_digit(near[1]),
            "seed_near_6e-7": _one_digit(nearer[1]),
            "seed_with_fallback": _one_digit(nearer[0]),
            "stable": _one_digit(stable),
        },
    )
