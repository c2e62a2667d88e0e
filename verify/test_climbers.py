"""An optimiser climbs toward the worst case of each bound that is measured on samples, and of one that is certified.

What is exhaustive (`crease_products`), of every pixel (`crease_contrast`, `dark_difference`) or a fitted order
(`difference_slopes`) leaves nothing to climb.
"""

import math
from functools import cache

import numpy as np
import pytest
from hypothesis import Phase, given, seed, settings, target
from hypothesis.strategies import fixed_dictionaries, floats, integers, just, one_of, sampled_from

from proofs.engine.theorem import all_theorems
from proofs.formulas.certified import ALGEBRAIC_GRADIENT
from proofs.formulas.enclosed import RULES
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from proofs.formulas.symbols import k_v
from renderer import render
from renderer.generate.step_terms import SLOPE_TERMS
from verify.accuracy.base_errors import LEAST_SQUARE, RATIOS
from verify.accuracy.differences import SLOPES, Case, bounds, parts
from verify.accuracy.gradient_errors import UNIT, errors_at
from verify.accuracy.pixels import SCENES, SIZE, checked_pixel
from verify.checkers.measurements import binades, colours, enclosing
from verify.evaluate.arrays import distance, in_balls, in_float64
from verify.stability.geometry import toward_the_pole
from verify.stability.wave_numbers import LARGEST

EXHAUSTIVE = {"crease_products", "crease_contrast", "dark_difference", "difference_slopes"}


def general_gradient(field, u, v, ku, kv):
    """Return the error of the general form in units of π max(1, |k|) 2^-53."""
    if any(0 < abs(product) < 1e-285 for product in (ku * u, kv * v)):
        return 0.0
    program, at = gradient(HEIGHT_FIELDS[field]), {"u": u, "v": v, "k_u": ku, "k_v": kv}
    ours, true = in_float64(program, at), in_balls(program, at)
    off = (distance(ours[name], true[name]) / max(1.0, abs(k)) for name, k in zip(SLOPES, (ku, kv), strict=True))
    return float(max(off)) / (math.pi * UNIT)


def algebraic_gradient(field, ratio, square, angle, half_u, wave_v):
    """Return the error of the algebraic form in units of (1 + k) π k 2^-53."""
    eye, field = 1 / ratio, HEIGHT_FIELDS[field]
    rho = math.sqrt(1 - square) * (1 - 1e-12) * eye / math.sqrt((eye - 1) * (eye + 1))
    at = {"eye": eye, "radius": 1.0, "x": [rho * math.cos(angle)], "y": [rho * math.sin(angle)]}
    kv = wave_v / float(field.wave_numbers[1].subs(k_v, 1))
    return float(errors_at(field, at | {"k_u": 2.0 * half_u, "k_v": kv})[0])


def difference(field, u, v, ku, kv, digits):
    """Return the largest part of a central difference's error over its bound."""
    shares = [0.0]
    for case in (Case("", field, ku, kv, u, v, slope) for slope in SLOPES):
        seen, most = (of(case, [10.0**-digits]) for of in (parts, bounds))
        shares += [float(abs(seen[part][0]) / most[part][0]) for part in seen if seen[part][0]]
    return max(shares)


def stable_frame(digits, number):
    """Return the error of g by the stable frame."""
    return float(toward_the_pole(sines=np.array([10.0**-digits]), samples=1, seed=number).worst().max())


@cache
def _frame(name):
    return render(SCENES[name], SIZE, SIZE, bounds=True)


def pixel(name, column, row):
    """Return the error of a decided pixel over its bound."""
    seen = checked_pixel(name, _frame(name), "", column, row)
    return 0.0 if seen.undecided or not seen.error else float(seen.error / seen.bound)


def lost_step(significand, exponent, share):
    """Return half a spacing over a step that moved a slope, 0 where none moved; at a power of two a quarter."""
    at = np.ldexp(float(significand), exponent)
    moved = any(map(float, binades.slopes(at, share * np.spacing(at))))
    return (0.25 if significand == 2**52 else 0.5) / share if moved else 0.0


def of_shares(measured, claims):
    """Return the height of what a measurement finds of a claim: an error over its bound."""
    return lambda name, number: max(measured.shares(claims[name], np.random.default_rng(number), 1))


_algebraic = sampled_from([name for name, field in HEIGHT_FIELDS.items() if field.wave_numbers])
_inside = floats(0, 1, exclude_max=True)
_waves = one_of(floats(-LARGEST, LARGEST), integers(-1000, 1000).map(float))
_moderate = one_of(integers(1, 512).map(float), floats(1, 512), floats(-512, -1))
_clear = one_of(just(0.0), floats(1e-9, 1 - 1e-9))  # nothing underflows
_pixels, _seeds = integers(0, SIZE - 1), integers(0, 2**16)
STAGES = colours.claims()
CLIMBS = {
    "gradient_accuracy": (general_gradient, 10.0, 2.0, {
        "field": _algebraic, "u": _inside, "v": _inside, "ku": _waves, "kv": _waves}),
    "algebraic_gradient_accuracy": (algebraic_gradient, ALGEBRAIC_GRADIENT, 0.1, {
        "field": _algebraic, "ratio": floats(*RATIOS), "square": floats(LEAST_SQUARE, 1),
        "angle": floats(-math.pi, math.pi), "half_u": integers(1, 32), "wave_v": integers(1, 64)}),
    "difference_bounds": (difference, 1.0, 0.3, {
        "field": sampled_from([*SLOPE_TERMS]), "u": _clear, "v": _clear, "ku": _moderate, "kv": _moderate,
        "digits": floats(1, 16)}),
    "pole_accuracy": (stable_frame, 1e-12, 1e-16, {"digits": floats(3.9, 6.3), "number": _seeds}),
    "binades": (lost_step, 1.0, 0.5, {
        "significand": one_of(just(2**52), integers(2**52, 2**53 - 1)), "exponent": integers(-112, -53),
        "share": one_of(just(0.5), floats(0.2, 1.2))}),
    "colour_accuracy": (of_shares(colours, STAGES), 1.0, 0.05, {"name": sampled_from([*STAGES]), "number": _seeds}),
    "enclosing_rules": (of_shares(enclosing, RULES), 1.0, 0.9, {"name": sampled_from([*RULES]), "number": _seeds}),
    "pixel_accuracy": (pixel, 1.0, 1e-4, {
        "name": sampled_from([*SCENES]), "column": _pixels, "row": _pixels}),
}  # fmt: skip
"""{theorem: (what is climbed, the bound that it claims, what is found at least, from where)}"""


def climb(theorem, examples):
    """Return the highest value that was reached, by hypothesis, which goes on from the highest ones."""
    height, _, _, where = CLIMBS[theorem]
    reached = [0.0]

    @seed(24)
    @settings(max_examples=examples, deadline=None, database=None, phases=[Phase.generate, Phase.target])
    @given(fixed_dictionaries(where))
    def look(at):
        found = height(**at)
        assert not math.isinf(found), at
        reached.append(0.0 if math.isnan(found) else found)  # no digits decide there
        target(reached[-1])

    look()
    return max(reached)


@pytest.mark.parametrize("examples", [40, pytest.param(2000, marks=pytest.mark.long)])
@pytest.mark.parametrize("theorem", CLIMBS)
def test_no_climber_gets_above_the_bound(theorem, examples):
    """And it finds what is there: the least would be no bound, which a few steps show."""
    _, bound, least, _ = CLIMBS[theorem]
    assert least < climb(theorem, examples) <= bound


def test_each_measured_bound_has_a_climber():
    measured = {id for id, theorem in all_theorems().items() if theorem.expected == "measured"}
    assert EXHAUSTIVE <= measured <= EXHAUSTIVE | CLIMBS.keys()
