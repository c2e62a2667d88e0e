"""Wave numbers: small, large to 2²⁰, negative, zero, not whole; the gradient as a function of float64 (u, v)."""

import numpy as np
from numpy.typing import ArrayLike

from proofs.engine.program import Program
from proofs.formulas.height_fields import HEIGHT_FIELDS, HeightField, gradient
from proofs.formulas.symbols import k_u, k_v, real, u, v
from verify.evaluate.arrays import distance, in_balls, in_float64, with_bounds
from verify.evaluate.programs import naive_gradient
from verify.stability.sweep import Sweep

SEED, LARGEST = 4, 2.0**20
LEAST = 1e-150  # the chart's smallest v off the pole; far below it the product of two sines underflows
of_u, of_v = real("argument_of_u argument_of_v")


def rounded_product_gradient(field: HeightField) -> Program:
    """Return the gradient with the product k·u rounded first, and reduced in half-turns after that."""
    program = gradient(field)
    swap = {k_u * u: of_u, k_v * v: of_v}
    lines = [(s, e.xreplace(swap)) for s, e in program.definitions]
    return Program("rounded", program.inputs, ((of_u, k_u * u), (of_v, k_v * v), *lines), program.outputs)


def wave_numbers(values: int, random: np.random.Generator) -> np.ndarray:
    """Return k between 10⁻³ and 2²⁰ evenly by ratio; from 1 on every third one is whole, and about half negative."""
    k = np.geomspace(1e-3, LARGEST - 0.3, values)
    whole = (np.arange(values) % 3 == 0) & (k >= 1)
    k[whole] = np.rint(k[whole])
    return np.where(random.random(values) < 0.5, -k, k)


def points_of_the_chart(k: np.ndarray, samples: int, random: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Return (u, v): half at random, half next to a crease m/k, where a rounded product is worst."""
    u_at, v_at = random.uniform(0, 1, (2, len(k), samples))
    half = samples // 2
    for at in (u_at, v_at):
        nearest = np.rint(at[:, :half] * k[:, None]) / np.where(k == 0, 1, k)[:, None]
        at[:, :half] = np.clip(np.nextafter(nearest, at[:, :half]), LEAST, np.nextafter(1, 0))
    return u_at, v_at


def large_wave_numbers(field: str, k: ArrayLike | None = None, samples: int = 24) -> Sweep:
    """The error of (h_u, h_v) over π max(1, |k|) against |k|; by default for `wave_numbers`.

    Reason of the bound: the product k·u is exact as a pair, the reduction is exact, so what is left is the error of
    two factors and of two products, each a few roundings of a number below π|k|: independent of k.
    """
    random = np.random.default_rng(SEED)
    k = wave_numbers(74, random) if k is None else np.array(k)
    u_at, v_at = points_of_the_chart(k, samples, random)
    inputs = {"u": u_at, "v": v_at, "k_u": k[:, None], "k_v": k[:, None]}
    program = gradient(HEIGHT_FIELDS[field])
    truth, ours = in_balls(program, inputs), with_bounds(program, inputs)
    scale = np.pi * np.maximum(1, np.abs(k))[:, None]

    def error(values):
        return np.maximum(*(distance(values[n], truth[n]) for n in ("h_u", "h_v"))) / scale

    others = {
        "libm, rounded argument": error(in_float64(naive_gradient(HEIGHT_FIELDS[field]), inputs)),
        "reduced, rounded product": error(in_float64(rounded_product_gradient(HEIGHT_FIELDS[field]), inputs)),
    }
    bound = np.maximum(ours["h_u"].bound, ours["h_v"].bound) / scale
    return Sweep(np.abs(k), error({n: ours[n].value for n in ours}), bound, others)
