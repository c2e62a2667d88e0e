"""Accuracy of the picture, the exact gradient and the central difference, against balls. See verify/accuracy."""

import math
from functools import cache, partial

import numpy as np

from proofs.formulas.algebraic_form import MAX_WAVE_NUMBER
from proofs.formulas.certified import ALGEBRAIC_GRADIENT, GENERAL_GRADIENT
from proofs.formulas.finite_difference import METHODS
from verify.accuracy import base_errors, orders
from verify.accuracy.differences import CASES, SLOPES, STEPS, bounds, parts
from verify.accuracy.gradient_errors import UNIT, worst_at
from verify.accuracy.pixels import SCENES, SEED, SHININESSES, checked_pixels
from verify.checkers.measurements import Enclosure, Measurement, measures
from verify.stability.rows import SWEEPS, sweep
from verify.stability.wave_numbers import SEED as SWEEP_SEED


@cache
def _pixels():
    return [*checked_pixels(SCENES), *checked_pixels(SHININESSES, each=10)]


@measures("pixel_accuracy", false={"bounds of 60 bits": {"share": 2**-7}})
def pixels(share: float = 1.0) -> Measurement:
    """Measure random and adversarial pixels of every field and model, and of other exponents of shininess."""
    decided = [p for p in _pixels() if not p.undecided]
    return Measurement(
        [p.error / p.bound for p in decided if p.bound > 0],
        bound=share,
        seed=SEED,
        holds=all(p.error <= share * p.bound and p.same_chamber for p in decided) and len(decided) >= 2000,
        quantity="the largest error of a channel over its pixel's bound",
    )


@measures(
    "gradient_accuracy",
    false={"with libm's sine of a rounded πku": {"form": "libm, rounded argument"}, "within one unit": {"bound": 1.0}},
)
def general_gradient(form: str | None = None, bound: float = GENERAL_GRADIENT) -> Measurement:
    """Measure the general form, |k| to 2^20, at random and beside creases; k_u and k_v equal or not, or one 0."""
    sweeps = [sweep(name) for name in SWEEPS if name.startswith("wave_numbers")]
    return Measurement(
        np.concatenate([(one.others[form] if form else one.errors).ravel() / UNIT for one in sweeps]),
        seed=SWEEP_SEED,
        bound=bound,
        holds=not any(one.escaped for one in sweeps),
        quantity="the general form: the largest error over π max(1, |k|) 2^-53",
    )


@measures("algebraic_gradient_accuracy", false={"within 40 (1 + k)": {"bound": 40}, "up to the rim": {"least": 0.01}})
def algebraic_gradient(bound: int = ALGEBRAIC_GRADIENT, least: float = base_errors.LEAST_SQUARE) -> Enclosure:
    """Enclose the algebraic form from the image point: its bases over every box of the hits, and their powers."""
    return Enclosure(
        pieces=partial(base_errors.gradient_pieces, least),
        over={
            "R/e": (base_errors.RATIOS,),
            r"\rho/\rho_s": ((0.0, math.sqrt(1 - least)),),
            "k_u": ((-MAX_WAVE_NUMBER, MAX_WAVE_NUMBER),),
            "k_v": ((-MAX_WAVE_NUMBER, MAX_WAVE_NUMBER),),
        },
        at=worst_at,
        bound=bound,
        quantity="the algebraic form: the bound over π k (1 + k) 2^-53, over all boxes of R/e and ρ/ρ_s, all "
        "wave numbers",
    )


@cache
def _taken_apart():
    cases = [case._replace(method=method) for method in METHODS for case in CASES]
    return [(parts(case), bounds(case)) for case in cases]


@measures("difference_bounds", false={"a third of the bounds": {"share": 1 / 3}})
def under_the_bounds(share: float = 1.0) -> Measurement:
    """Measure every part of the error of every difference, ε from 1e-1 to 1e-16, below its proved bound."""
    seen_over, ratios = [], []
    for errors, limits in _taken_apart():
        off = [(np.abs(errors[part]), limit) for part, limit in limits.items()]
        seen_over += [np.divide(size, limit, out=np.zeros(size.shape), where=size != 0) for size, limit in off]
        rounding = (STEPS < 1e-9) & (errors["total"] != 0)
        ratios.append(limits["total"][rounding] / np.abs(errors["total"][rounding]))
    median = np.median(np.concatenate(ratios))
    return Measurement(seen_over, bound=share, holds=median <= 30, quantity="a part of the error over its bound")


@cache
def _quadrature(component):
    steps = np.logspace(-3, -8, 11)
    return steps, np.array([orders.quadrature(component, step) for step in steps])


@measures("difference_slopes", false={"∝ ε": {"slope": 1.0}, "√(k_v ε/3) in h_v": {"at_poles": True}})
def ridges_fall_like_a_root(slope: float = 0.5, at_poles: bool = False) -> Measurement:
    """Measure the RMS error of ridges over the chart: slope and constant by quadrature."""
    steps, rms = (np.array(each) for each in zip(*map(_quadrature, SLOPES), strict=True))
    law = np.array([orders.predicted(component, steps[0])[0] for component in SLOPES])
    law[1] *= (orders.SCENE.kv / (orders.SCENE.kv - 1)) ** 0.5 if at_poles else 1.0

    def off(rms):
        return [[orders.fitted_slope(*each) - slope for each in zip(steps, rms, strict=True)], *(rms / law - 1).T]

    return Measurement(
        rms,
        of=off,
        bound=0.02,
        quantity="how far the fitted slope is from ½, and the constant from the theorem's, relatively",
    )


@measures("difference_slopes", false={"first order for all": {"odd": 1.0}, "second for all": {"other": 2.0}})
def clamped_orders(odd: float = 2.0, other: float = 1.0) -> Measurement:
    """Measure the order of the difference clamped at the pole at v = ε/2."""
    orders_of_fields = map(orders.clamped_order, orders.FIELDS)
    errors = np.array([*map(orders.clamped_errors, orders.FIELDS)])

    def fitted(errors):
        return [orders.fitted_slope(orders.STEPS, each) for each in errors]

    return Measurement(
        errors,
        of=fitted,
        claimed=[{1: other, 2: odd}.get(order, order) for order in orders_of_fields],
        bound=0.02,
        quantity="how far the fitted orders are from 2 for the chapter's fields and from 1 for cos πk_v v",
    )


@measures("difference_slopes", false={"third order": {"slope": 3.0}})
def truncation_slope(slope: float = 2.0) -> Measurement:
    """Measure the order of the truncation error at a smooth point."""
    of_part = parts(CASES[0])
    branch = (STEPS < 1e-3) & (STEPS > 1e-12)
    return Measurement(
        np.abs(of_part["truncation"][branch]),
        of=partial(orders.fitted_slope, STEPS[branch]),
        claimed=slope,
        bound=0.02,
        quantity="how far the truncation error's fitted slope is from 2",
    )
