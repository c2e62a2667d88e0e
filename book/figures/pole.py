"""Toward the pole: the seed's tangent frame against ours, and the clamped difference."""

from functools import cache, partial
from itertools import product

import numpy as np
from mpmath import mp, mpf

from book.drawing.registry import Drawing, figure
from book.drawing.style import DASHED, curve, decades, plot
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from proofs.formulas.tangent_frame import seed_frame, tangent_frame
from renderer import Scene, central, exact, gradient_at
from renderer.generate.kernels import function_of
from verify.accuracy.orders import fitted_slope
from verify.evaluate import Reference

AZIMUTHS = np.linspace(-3.0, 3.0, 25)
SEED_FALLBACK = 1e-4
K_U, K_V = 8, 4


def _tangent_gradient(frame, slopes):
    """Return g = h_u e_θ + h_v e_φ from a frame (six numbers) and a gradient."""
    return np.array([slopes[0] * frame[i] + slopes[1] * frame[i + 3] for i in range(3)])


def _by_reference(program, reference, *inputs):
    """Return the outputs of a program at its inputs, in order, to 50 digits."""
    lines = reference(dict(zip(reference.inputs, inputs, strict=True)))
    return [lines[symbol.name] for symbol in program.outputs]


@cache
def _errors(sines):
    """Return the largest errors of g over the azimuths at each sin φ: seed's frame, with its fallback, ours."""
    seed, ours = function_of(seed_frame), function_of(tangent_frame)
    programs = (tangent_frame, gradient(HEIGHT_FIELDS["sine"]))
    exact_frame, slope = (partial(_by_reference, program, Reference(program)) for program in programs)
    worst = np.zeros((3, len(sines)))
    for place, azimuth in product(range(len(sines)), AZIMUTHS):
        with mp.workdps(50):
            sine, angle = mpf(float(sines[place])), mpf(float(azimuth))
            angles = (mp.cos(angle), mp.sin(angle), mp.sqrt(1 - sine**2), sine)
            point = ((angle + mp.pi) / (2 * mp.pi), mp.asin(sine) / mp.pi)
            slopes = slope(*point, mpf(K_U), mpf(K_V))
            right = _tangent_gradient(exact_frame(*angles), slopes)
            rounded, float_slopes = np.array(angles, dtype=float), np.array(slopes, dtype=float)
            n = (rounded[3] * rounded[0], rounded[3] * rounded[1], rounded[2])
            with np.errstate(divide="ignore", invalid="ignore"):
                plain = _tangent_gradient(seed(*n), float_slopes)
            fallback = _tangent_gradient((1.0, 0.0, 0.0, 0.0, 1.0, 0.0), float_slopes)
            guarded = plain if sines[place] > SEED_FALLBACK else fallback
            for index, value in enumerate((plain, guarded, _tangent_gradient(ours(*rounded), float_slopes))):
                error = np.nan  # where a frame divides by zero
                if np.isfinite(value).all():
                    error = float(max(abs(mpf(float(v)) - r) for v, r in zip(value, right, strict=True)))
                worst[index, place] = np.maximum(worst[index, place], error)
    return worst


@figure
def pole() -> Drawing:
    """The largest error of g near the pole: the seed's frame, with and without its fallback, and the stable one."""
    sines = np.logspace(0, -8, 49)[1:]
    plain, guarded, stable = _errors(tuple(sines))
    fig, ax = plot(height=3.8)
    away, there = sines[30], sines[22]
    curve(ax, sines, guarded, "numeric", "seed, with its fallback", "above", away, linewidth=1.4, linestyle=DASHED)
    curve(ax, sines, plain, "numeric", "seed's frame", "left", there, linewidth=1.6)
    curve(ax, sines, stable, "symbolic", "stable frame", "above", away, linewidth=1.8)
    decades(ax, 2, 4, xlim=(1, 1e-9), ylim=(1e-18, 1e4), xlabel="sin φ", ylabel="error of $g$")
    index = np.abs(np.log(sines / SEED_FALLBACK)).argmin()
    numbers = {
        "seed_at_1e-4": plain[index],
        "fallback_worst": guarded.max(),
        "seed_worst": np.nanmax(plain),
        "stable_worst": stable.max(),
        "points": len(sines) * len(AZIMUTHS),
    }
    data = {"sin_phi": sines, "seed": plain, "seed_with_fallback": guarded, "stable": stable}
    return Drawing(fig, numbers | _clamped_slopes(), data)


def _clamped_slopes():
    """Return the fitted orders of the clamped difference of h_v at fixed v/ε = 1/2, and in the interior."""
    steps, scene = np.logspace(-2, -4, 9), Scene(field="sine")

    def order(places):
        pairs = zip(steps, places, strict=True)
        slopes = [[gradient_at(scene, 0.31, v, method)[1] for method in (central(eps), exact())] for eps, v in pairs]
        return fitted_slope(steps, np.abs(np.subtract(*np.transpose(slopes))))

    return {"clamped_order": order(steps / 2), "interior_order": order(np.full(9, 0.3))}
