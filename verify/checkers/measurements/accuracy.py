"""How accurate the picture, the exact gradient and the central difference are, against balls. See verify/accuracy."""

from functools import cache, partial

import numpy as np

from proofs.formulas.certified import ALGEBRAIC_GRADIENT, GENERAL_GRADIENT
from verify.accuracy import base_errors, orders
from verify.accuracy.differences import CASES, SLOPES, STEPS, bounds, escapes, parts
from verify.accuracy.gradient_errors import OF_WAVES, UNIT, worst_at_ratios
from verify.accuracy.pixels import SCENES, SEED, SHININESSES, checked_pixels, problems
from verify.checkers.measurement import Enclosure, Measurement, measures
from verify.stability.rows import SWEEPS, sweep
from verify.stability.wave_numbers import PAIRS, SEED as SWEEP_SEED, large_wave_numbers


@cache
def _pixels():
    return [*checked_pixels(SCENES), *checked_pixels(SHININESSES, each=10)]


@measures("pixel_accuracy", false={"bounds of 60 bits": {"share": 2**-7}})
def pixels(share: float = 1.0) -> Measurement:
    """Random and adversarial pixels of every field and model, and of other exponents of shininess."""
    decided = [p for p in _pixels() if not p.undecided]
    return Measurement(
        samples=len(decided),
        seed=SEED,
        worst=max(p.error / p.bound for p in decided if p.bound > 0),
        bound=share,
        holds=not problems(decided, share) and len(decided) >= 2000,
        what="the largest error of a channel over its pixel's bound",
        numbers={"undecided": len(_pixels()) - len(decided), "largest": max(p.error for p in decided)},
    )


def _of_sweeps(found, bound, what, form=None):
    """Return the Measurement of {name: sweep}, of our form or another."""
    units = {name: np.nanmax(seen.worst(form)) / UNIT for name, seen in found.items()}
    return Measurement(
        samples=sum(seen.points for seen in found.values()),
        seed=SWEEP_SEED,
        worst=max(units.values()),
        bound=bound,
        holds=not any(seen.escaped for seen in found.values()),
        what=f"the general form{what}: the largest error over π max(1, |k|) 2^-53",
        numbers=units,
    )


@measures("gradient_accuracy", false={"with libm's sine of a rounded πku": {"form": "libm, rounded argument"}})
def general_gradient(form: str | None = None) -> Measurement:
    """The general form, |k| to 2^20, at random and beside the creases."""
    found = {name: sweep(name) for name in SWEEPS if name.startswith("wave_numbers")}
    return _of_sweeps(found, GENERAL_GRADIENT, "", form)


@measures("gradient_accuracy", false={"within one unit": {"bound": 1.0}})
def unequal_wave_numbers(bound: float = GENERAL_GRADIENT) -> Measurement:
    """The general form where k_u and k_v differ, have other signs, or one is zero."""
    found = {f"unequal_{field}": large_wave_numbers(field, PAIRS, samples=64) for field in OF_WAVES}
    return _of_sweeps(found, bound, " where k_u is not k_v")


@measures("algebraic_gradient_accuracy", false={"within 40 (1 + k)": {"bound": 40}, "up to the rim": {"least": 0.01}})
def algebraic_gradient(bound: int = ALGEBRAIC_GRADIENT, least: float = base_errors.LEAST_SQUARE) -> Enclosure:
    """The algebraic form from the image point: its bases over every box of the hits, and their powers."""
    of_u, of_v = base_errors.base_errors(least)
    return Enclosure(
        pieces=partial(base_errors.gradient_pieces, least),
        over=(base_errors.RATIOS,),
        at=worst_at_ratios,
        bound=bound,
        what="the algebraic form: the bound over π k (1 + k) 2^-53, over all boxes of R/e and ρ/ρ_s, all wave numbers",
        numbers={"base_of_u": of_u / UNIT, "base_of_v": of_v / UNIT},
    )


@cache
def _taken_apart():
    return [(parts(case), bounds(case)) for case in CASES]


@measures("difference_bounds", false={"a third of the bounds": {"share": 1 / 3}})
def under_the_bounds(share: float = 1.0) -> Measurement:
    """Every part of the error of every difference, ε from 1e-1 to 1e-16, below its proved bound."""
    out, ratios = 0, []
    for seen, limits in _taken_apart():
        out += sum(escapes(seen, {part: share * limit for part, limit in limits.items()}).values())
        rounding = (STEPS < 1e-9) & (seen["total"] != 0)
        ratios.append(limits["total"][rounding] / np.abs(seen["total"][rounding]))
    median = np.median(np.concatenate(ratios))
    return Measurement(
        samples=len(CASES) * len(STEPS),
        worst=out,
        bound=0,
        holds=median <= 30,
        what="measured parts of the error above their bound",
        numbers={"places": len(CASES), "median_ratio_in_the_rounding_branch": median},
    )


@cache
def _quadrature(component):
    steps = np.logspace(-3, -8, 11)
    return steps, np.array([orders.quadrature(component, step) for step in steps])


@measures("difference_slopes", false={"∝ ε": {"slope": 1.0}, "√(k_v ε/3) in h_v": {"at_poles": True}})
def ridges_fall_like_a_root(slope: float = 0.5, at_poles: bool = False) -> Measurement:
    """The RMS error of ridges over the chart: slope and constant by quadrature."""
    worst = {}
    for component in SLOPES:
        steps, rms = _quadrature(component)
        law, _ = orders.predicted(component, steps)
        law = law * (orders.SCENE.kv / (orders.SCENE.kv - 1)) ** 0.5 if component == "h_v" and at_poles else law
        worst[f"{component}_slope"] = abs(orders.fitted_slope(steps, rms) - slope)
        worst[f"{component}_constant"] = np.abs(rms / law - 1).max()
    return Measurement(
        samples=2 * 11,
        worst=max(worst.values()),
        bound=0.02,
        what="how far the fitted slope is from ½, and the constant from the theorem's, relatively",
        numbers=worst,
    )


@measures("difference_slopes", false={"first order for all": {"odd": 1.0}, "second for all": {"other": 2.0}})
def clamped_orders(odd: float = 2.0, other: float = 1.0) -> Measurement:
    """The order of the difference clamped at the pole at v = ε/2."""
    found = {field: orders.fitted_slope(orders.STEPS, orders.clamped_errors(field)) for field in orders.FIELDS}
    known = {field: orders.clamped_order(field) for field in found}
    claimed = {field: {1: other, 2: odd}.get(order, order) for field, order in known.items()}
    return Measurement(
        samples=len(found) * len(orders.STEPS),
        worst=max(abs(order - claimed[field]) for field, order in found.items()),
        bound=0.02,
        what="how far the fitted orders are from 2 for the chapter's fields and from 1 for cos πk_v v",
        numbers=found,
    )


@measures("difference_slopes", false={"third order": {"slope": 3.0}})
def truncation_slope(slope: float = 2.0) -> Measurement:
    """The order of the truncation error at a smooth point."""
    seen = parts(CASES[0])
    branch = (STEPS < 1e-3) & (STEPS > 1e-12)
    order = orders.fitted_slope(STEPS[branch], np.abs(seen["truncation"][branch]))
    return Measurement(
        samples=int(branch.sum()),
        worst=abs(order - slope),
        bound=0.02,
        what="how far the truncation error's fitted slope is from 2",
        numbers={"slope": order},
    )
